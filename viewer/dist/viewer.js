"use strict";(()=>{var No=Math.PI/180;function Xa(i,e){let t=Math.sin(i*No);return[t*Math.cos(e*No),t*Math.sin(e*No),Math.cos(i*No)]}function ef([i,e,t]){let n=Math.atan2(e,i)/No;return{theta_deg:Math.atan2(Math.hypot(i,e),t)/No,phi_deg:n<0?n+360:n}}async function Om(i,e){return i.index.files.some(r=>r.path==="report.json")?((await i.files.optionalJson("report.json").catch(()=>null))?.specimens?.find(r=>r.name===e)?.measured?.columns??[]).filter(({kind:r})=>r==="brdf").flatMap(({curves:r,scale:s})=>r.map(o=>({curve:o,scale:s}))).filter(({curve:r})=>r.along==="wavelength_nm").map(({curve:r,scale:s})=>({angles_deg:r.angles_deg,nm:r.at,values:r.measured.map(o=>o*s)})):[]}var M0=0,Bf=1,T0=2;var Tl=1,A0=2,ua=3,Pr=0,mi=1,Xi=2,uo=0,ha=1,zf=2,kf=3,Vf=4,E0=5;var ho=100,R0=101,C0=102,I0=103,P0=104,L0=200,N0=201,D0=202,F0=203,Hf=204,Gf=205,U0=206,O0=207,B0=208,z0=209,k0=210,V0=211,H0=212,G0=213,W0=214,Fc=0,Uc=1,Oc=2,Zo=3,Bc=4,zc=5,kc=6,Vc=7,ru=0,X0=1,q0=2,Lr=0,Wf=1,Xf=2,qf=3,Yf=4,$f=5,Zf=6,Kf=7,Af="attached",Y0="detached",Jf=300,fo=301,fa=302,su=303,ou=304,Ns=1e3,si=1001,Ko=1002,Ut=1003,au=1004;var po=1005;var qt=1006,da=1007;var Fi=1008;var bi=1009,jf=1010,Qf=1011,pa=1012,lu=1013,ur=1014,Nt=1015,tn=1016,cu=1017,uu=1018,mo=1020,ed=35902,td=35899,nd=1021,id=1022,jt=1023,jr=1026,as=1027,ls=1028,hu=1029,ai=1030,fu=1031;var du=1033,Al=33776,El=33777,Rl=33778,Cl=33779,pu=35840,mu=35841,gu=35842,_u=35843,xu=36196,vu=37492,yu=37496,bu=37488,wu=37489,Il=37490,Su=37491,Mu=37808,Tu=37809,Au=37810,Eu=37811,Ru=37812,Cu=37813,Iu=37814,Pu=37815,Lu=37816,Nu=37817,Du=37818,Fu=37819,Uu=37820,Ou=37821,Bu=36492,zu=36494,ku=36495,Vu=36283,Hu=36284,Pl=36285,Gu=36286;var eo=2300,to=2301,Nc=2302,Ef=2303,Rf=2400,Cf=2401,If=2402,$0=2500;var rd=0,Ll=1,ma=2,Z0=3200;var Nl=0,K0=1,cs="",Ln="srgb",dn="srgb-linear",il="linear",Yt="srgb";var Dc=7680;var J0=519,j0=512,Q0=513,eg=514,sd=515,tg=516,ng=517,od=518,ad=519,ld=35044;var Dl="300 es",Wi=2e3,Jo=2001;function E1(i){for(let e=i.length-1;e>=0;--e)if(i[e]>=65535)return!0;return!1}function R1(i){return ArrayBuffer.isView(i)&&!(i instanceof DataView)}function jo(i){return document.createElementNS("http://www.w3.org/1999/xhtml",i)}function ig(){let i=jo("canvas");return i.style.display="block",i}var Bm={},Qo=null;function rl(...i){let e="THREE."+i.shift();Qo?Qo("log",e,...i):console.log(e,...i)}function rg(i){let e=i[0];if(typeof e=="string"&&e.startsWith("TSL:")){let t=i[1];t&&t.isStackTrace?i[0]+=" "+t.getLocation():i[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return i}function nt(...i){i=rg(i);let e="THREE."+i.shift();if(Qo)Qo("warn",e,...i);else{let t=i[0];t&&t.isStackTrace?console.warn(t.getError(e)):console.warn(e,...i)}}function _t(...i){i=rg(i);let e="THREE."+i.shift();if(Qo)Qo("error",e,...i);else{let t=i[0];t&&t.isStackTrace?console.error(t.getError(e)):console.error(e,...i)}}function Qs(...i){let e=i.join(" ");e in Bm||(Bm[e]=!0,nt(...i))}function sg(i,e,t){return new Promise(function(n,r){function s(){switch(i.clientWaitSync(e,i.SYNC_FLUSH_COMMANDS_BIT,0)){case i.WAIT_FAILED:r();break;case i.TIMEOUT_EXPIRED:setTimeout(s,t);break;default:n()}}setTimeout(s,t)})}var og={[Fc]:Fc,[Oc]:kc,[Bc]:Bc,[Zo]:zc,[Uc]:Uc,[kc]:Oc,[Vc]:Vc,[zc]:Zo},Tr=class{addEventListener(e,t){this._listeners===void 0&&(this._listeners={});let n=this._listeners;n[e]===void 0&&(n[e]=[]),n[e].indexOf(t)===-1&&n[e].push(t)}hasEventListener(e,t){let n=this._listeners;return n===void 0?!1:n[e]!==void 0&&n[e].indexOf(t)!==-1}removeEventListener(e,t){let n=this._listeners;if(n===void 0)return;let r=n[e];if(r!==void 0){let s=r.indexOf(t);s!==-1&&r.splice(s,1)}}dispatchEvent(e){let t=this._listeners;if(t===void 0)return;let n=t[e.type];if(n!==void 0){e.target=this;let r=n.slice(0);for(let s=0,o=r.length;s<o;s++)r[s].call(this,e);e.target=null}}},ii=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"],zm=1234567,tl=Math.PI/180,no=180/Math.PI;function Nr(){let i=Math.random()*4294967295|0,e=Math.random()*4294967295|0,t=Math.random()*4294967295|0,n=Math.random()*4294967295|0;return(ii[i&255]+ii[i>>8&255]+ii[i>>16&255]+ii[i>>24&255]+"-"+ii[e&255]+ii[e>>8&255]+"-"+ii[e>>16&15|64]+ii[e>>24&255]+"-"+ii[t&63|128]+ii[t>>8&255]+"-"+ii[t>>16&255]+ii[t>>24&255]+ii[n&255]+ii[n>>8&255]+ii[n>>16&255]+ii[n>>24&255]).toLowerCase()}function It(i,e,t){return Math.max(e,Math.min(t,i))}function cd(i,e){return(i%e+e)%e}function C1(i,e,t,n,r){return n+(i-e)*(r-n)/(t-e)}function I1(i,e,t){return i!==e?(t-i)/(e-i):0}function nl(i,e,t){return(1-t)*i+t*e}function P1(i,e,t,n){return nl(i,e,1-Math.exp(-t*n))}function L1(i,e=1){return e-Math.abs(cd(i,e*2)-e)}function N1(i,e,t){return i<=e?0:i>=t?1:(i=(i-e)/(t-e),i*i*(3-2*i))}function D1(i,e,t){return i<=e?0:i>=t?1:(i=(i-e)/(t-e),i*i*i*(i*(i*6-15)+10))}function F1(i,e){return i+Math.floor(Math.random()*(e-i+1))}function U1(i,e){return i+Math.random()*(e-i)}function O1(i){return i*(.5-Math.random())}function B1(i){i!==void 0&&(zm=i);let e=zm+=1831565813;return e=Math.imul(e^e>>>15,e|1),e^=e+Math.imul(e^e>>>7,e|61),((e^e>>>14)>>>0)/4294967296}function z1(i){return i*tl}function k1(i){return i*no}function V1(i){return i>0&&Number.isInteger(i)&&2**Math.round(Math.log2(i))===i}function H1(i){return Math.pow(2,Math.ceil(Math.log(i)/Math.LN2))}function ud(i){return Math.pow(2,Math.floor(Math.log(i)/Math.LN2))}function G1(i,e,t,n,r){let s=Math.cos,o=Math.sin,a=s(t/2),l=o(t/2),c=s((e+n)/2),u=o((e+n)/2),h=s((e-n)/2),f=o((e-n)/2),d=s((n-e)/2),m=o((n-e)/2);switch(r){case"XYX":i.set(a*u,l*h,l*f,a*c);break;case"YZY":i.set(l*f,a*u,l*h,a*c);break;case"ZXZ":i.set(l*h,l*f,a*u,a*c);break;case"XZX":i.set(a*u,l*m,l*d,a*c);break;case"YXY":i.set(l*d,a*u,l*m,a*c);break;case"ZYZ":i.set(l*m,l*d,a*u,a*c);break;default:nt("MathUtils: .setQuaternionFromProperEuler() encountered an unknown order: "+r)}}function Wu(i){switch(i.constructor){case Uint32Array:return 4294967295;case Uint16Array:return 65535;case Uint8Array:case Uint8ClampedArray:return 255;case Int32Array:return 2147483647;case Int16Array:return 32767;case Int8Array:return 127;default:return}}function hd(i,e){if(e.constructor===Float32Array)return i;let t=Wu(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.max(i/t,-1)}function fd(i,e){if(e.constructor===Float32Array)return i;let t=Wu(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.round(i*t)}var Xu={DEG2RAD:tl,RAD2DEG:no,generateUUID:Nr,clamp:It,euclideanModulo:cd,mapLinear:C1,inverseLerp:I1,lerp:nl,damp:P1,pingpong:L1,smoothstep:N1,smootherstep:D1,randInt:F1,randFloat:U1,randFloatSpread:O1,seededRandom:B1,degToRad:z1,radToDeg:k1,isPowerOfTwo:V1,ceilPowerOfTwo:H1,floorPowerOfTwo:ud,setQuaternionFromProperEuler:G1,normalize:fd,denormalize:hd},xt=class{static{this.prototype.isVector2=!0}constructor(e=0,t=0){this.x=e,this.y=t}get width(){return this.x}set width(e){this.x=e}get height(){return this.y}set height(e){this.y=e}set(e,t){return this.x=e,this.y=t,this}setScalar(e){return this.x=e,this.y=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;default:throw new Error("THREE.Vector2: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;default:throw new Error("THREE.Vector2: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y)}copy(e){return this.x=e.x,this.y=e.y,this}add(e){return this.x+=e.x,this.y+=e.y,this}addScalar(e){return this.x+=e,this.y+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this}subScalar(e){return this.x-=e,this.y-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this}multiply(e){return this.x*=e.x,this.y*=e.y,this}multiplyScalar(e){return this.x*=e,this.y*=e,this}divide(e){return this.x/=e.x,this.y/=e.y,this}divideScalar(e){return this.multiplyScalar(1/e)}applyMatrix3(e){let t=this.x,n=this.y,r=e.elements;return this.x=r[0]*t+r[3]*n+r[6],this.y=r[1]*t+r[4]*n+r[7],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this}clamp(e,t){return this.x=It(this.x,e.x,t.x),this.y=It(this.y,e.y,t.y),this}clampScalar(e,t){return this.x=It(this.x,e,t),this.y=It(this.y,e,t),this}clampLength(e,t){let n=this.length();return this.divideScalar(n||1).multiplyScalar(It(n,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(e){return this.x*e.x+this.y*e.y}cross(e){return this.x*e.y-this.y*e.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let n=this.dot(e)/t;return Math.acos(It(n,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,n=this.y-e.y;return t*t+n*n}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this}lerpVectors(e,t,n){return this.x=e.x+(t.x-e.x)*n,this.y=e.y+(t.y-e.y)*n,this}equals(e){return e.x===this.x&&e.y===this.y}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this}rotateAround(e,t){let n=Math.cos(t),r=Math.sin(t),s=this.x-e.x,o=this.y-e.y;return this.x=s*n-o*r+e.x,this.y=s*r+o*n+e.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}},Li=class{constructor(e=0,t=0,n=0,r=1){this.isQuaternion=!0,this._x=e,this._y=t,this._z=n,this._w=r}static slerpFlat(e,t,n,r,s,o,a){let l=n[r+0],c=n[r+1],u=n[r+2],h=n[r+3],f=s[o+0],d=s[o+1],m=s[o+2],b=s[o+3];if(h!==b||l!==f||c!==d||u!==m){let g=l*f+c*d+u*m+h*b;g<0&&(f=-f,d=-d,m=-m,b=-b,g=-g);let _=1-a;if(g<.9995){let S=Math.acos(g),T=Math.sin(S);_=Math.sin(_*S)/T,a=Math.sin(a*S)/T,l=l*_+f*a,c=c*_+d*a,u=u*_+m*a,h=h*_+b*a}else{l=l*_+f*a,c=c*_+d*a,u=u*_+m*a,h=h*_+b*a;let S=1/Math.sqrt(l*l+c*c+u*u+h*h);l*=S,c*=S,u*=S,h*=S}}e[t]=l,e[t+1]=c,e[t+2]=u,e[t+3]=h}static multiplyQuaternionsFlat(e,t,n,r,s,o){let a=n[r],l=n[r+1],c=n[r+2],u=n[r+3],h=s[o],f=s[o+1],d=s[o+2],m=s[o+3];return e[t]=a*m+u*h+l*d-c*f,e[t+1]=l*m+u*f+c*h-a*d,e[t+2]=c*m+u*d+a*f-l*h,e[t+3]=u*m-a*h-l*f-c*d,e}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get w(){return this._w}set w(e){this._w=e,this._onChangeCallback()}set(e,t,n,r){return this._x=e,this._y=t,this._z=n,this._w=r,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(e){return this._x=e.x,this._y=e.y,this._z=e.z,this._w=e.w,this._onChangeCallback(),this}setFromEuler(e,t=!0){let n=e._x,r=e._y,s=e._z,o=e._order,a=Math.cos,l=Math.sin,c=a(n/2),u=a(r/2),h=a(s/2),f=l(n/2),d=l(r/2),m=l(s/2);switch(o){case"XYZ":this._x=f*u*h+c*d*m,this._y=c*d*h-f*u*m,this._z=c*u*m+f*d*h,this._w=c*u*h-f*d*m;break;case"YXZ":this._x=f*u*h+c*d*m,this._y=c*d*h-f*u*m,this._z=c*u*m-f*d*h,this._w=c*u*h+f*d*m;break;case"ZXY":this._x=f*u*h-c*d*m,this._y=c*d*h+f*u*m,this._z=c*u*m+f*d*h,this._w=c*u*h-f*d*m;break;case"ZYX":this._x=f*u*h-c*d*m,this._y=c*d*h+f*u*m,this._z=c*u*m-f*d*h,this._w=c*u*h+f*d*m;break;case"YZX":this._x=f*u*h+c*d*m,this._y=c*d*h+f*u*m,this._z=c*u*m-f*d*h,this._w=c*u*h-f*d*m;break;case"XZY":this._x=f*u*h-c*d*m,this._y=c*d*h-f*u*m,this._z=c*u*m+f*d*h,this._w=c*u*h+f*d*m;break;default:nt("Quaternion: .setFromEuler() encountered an unknown order: "+o)}return t===!0&&this._onChangeCallback(),this}setFromAxisAngle(e,t){let n=t/2,r=Math.sin(n);return this._x=e.x*r,this._y=e.y*r,this._z=e.z*r,this._w=Math.cos(n),this._onChangeCallback(),this}setFromRotationMatrix(e){let t=e.elements,n=t[0],r=t[4],s=t[8],o=t[1],a=t[5],l=t[9],c=t[2],u=t[6],h=t[10],f=n+a+h;if(f>0){let d=.5/Math.sqrt(f+1);this._w=.25/d,this._x=(u-l)*d,this._y=(s-c)*d,this._z=(o-r)*d}else if(n>a&&n>h){let d=2*Math.sqrt(1+n-a-h);this._w=(u-l)/d,this._x=.25*d,this._y=(r+o)/d,this._z=(s+c)/d}else if(a>h){let d=2*Math.sqrt(1+a-n-h);this._w=(s-c)/d,this._x=(r+o)/d,this._y=.25*d,this._z=(l+u)/d}else{let d=2*Math.sqrt(1+h-n-a);this._w=(o-r)/d,this._x=(s+c)/d,this._y=(l+u)/d,this._z=.25*d}return this._onChangeCallback(),this}setFromUnitVectors(e,t){let n=e.dot(t)+1;return n<1e-8?(n=0,Math.abs(e.x)>Math.abs(e.z)?(this._x=-e.y,this._y=e.x,this._z=0,this._w=n):(this._x=0,this._y=-e.z,this._z=e.y,this._w=n)):(this._x=e.y*t.z-e.z*t.y,this._y=e.z*t.x-e.x*t.z,this._z=e.x*t.y-e.y*t.x,this._w=n),this.normalize()}angleTo(e){return 2*Math.acos(Math.abs(It(this.dot(e),-1,1)))}rotateTowards(e,t){let n=this.angleTo(e);if(n===0)return this;let r=Math.min(1,t/n);return this.slerp(e,r),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(e){return this._x*e._x+this._y*e._y+this._z*e._z+this._w*e._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let e=this.length();return e===0?(this._x=0,this._y=0,this._z=0,this._w=1):(e=1/e,this._x=this._x*e,this._y=this._y*e,this._z=this._z*e,this._w=this._w*e),this._onChangeCallback(),this}multiply(e){return this.multiplyQuaternions(this,e)}premultiply(e){return this.multiplyQuaternions(e,this)}multiplyQuaternions(e,t){let n=e._x,r=e._y,s=e._z,o=e._w,a=t._x,l=t._y,c=t._z,u=t._w;return this._x=n*u+o*a+r*c-s*l,this._y=r*u+o*l+s*a-n*c,this._z=s*u+o*c+n*l-r*a,this._w=o*u-n*a-r*l-s*c,this._onChangeCallback(),this}slerp(e,t){let n=e._x,r=e._y,s=e._z,o=e._w,a=this.dot(e);a<0&&(n=-n,r=-r,s=-s,o=-o,a=-a);let l=1-t;if(a<.9995){let c=Math.acos(a),u=Math.sin(c);l=Math.sin(l*c)/u,t=Math.sin(t*c)/u,this._x=this._x*l+n*t,this._y=this._y*l+r*t,this._z=this._z*l+s*t,this._w=this._w*l+o*t,this._onChangeCallback()}else this._x=this._x*l+n*t,this._y=this._y*l+r*t,this._z=this._z*l+s*t,this._w=this._w*l+o*t,this.normalize();return this}slerpQuaternions(e,t,n){return this.copy(e).slerp(t,n)}random(){let e=2*Math.PI*Math.random(),t=2*Math.PI*Math.random(),n=Math.random(),r=Math.sqrt(1-n),s=Math.sqrt(n);return this.set(r*Math.sin(e),r*Math.cos(e),s*Math.sin(t),s*Math.cos(t))}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._w===this._w}fromArray(e,t=0){return this._x=e[t],this._y=e[t+1],this._z=e[t+2],this._w=e[t+3],this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._w,e}fromBufferAttribute(e,t){return this._x=e.getX(t),this._y=e.getY(t),this._z=e.getZ(t),this._w=e.getW(t),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},J=class{static{this.prototype.isVector3=!0}constructor(e=0,t=0,n=0){this.x=e,this.y=t,this.z=n}set(e,t,n){return n===void 0&&(n=this.z),this.x=e,this.y=t,this.z=n,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;default:throw new Error("THREE.Vector3: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("THREE.Vector3: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this}multiplyVectors(e,t){return this.x=e.x*t.x,this.y=e.y*t.y,this.z=e.z*t.z,this}applyEuler(e){return this.applyQuaternion(km.setFromEuler(e))}applyAxisAngle(e,t){return this.applyQuaternion(km.setFromAxisAngle(e,t))}applyMatrix3(e){let t=this.x,n=this.y,r=this.z,s=e.elements;return this.x=s[0]*t+s[3]*n+s[6]*r,this.y=s[1]*t+s[4]*n+s[7]*r,this.z=s[2]*t+s[5]*n+s[8]*r,this}applyNormalMatrix(e){return this.applyMatrix3(e).normalize()}applyMatrix4(e){let t=this.x,n=this.y,r=this.z,s=e.elements,o=1/(s[3]*t+s[7]*n+s[11]*r+s[15]);return this.x=(s[0]*t+s[4]*n+s[8]*r+s[12])*o,this.y=(s[1]*t+s[5]*n+s[9]*r+s[13])*o,this.z=(s[2]*t+s[6]*n+s[10]*r+s[14])*o,this}applyQuaternion(e){let t=this.x,n=this.y,r=this.z,s=e.x,o=e.y,a=e.z,l=e.w,c=2*(o*r-a*n),u=2*(a*t-s*r),h=2*(s*n-o*t);return this.x=t+l*c+o*h-a*u,this.y=n+l*u+a*c-s*h,this.z=r+l*h+s*u-o*c,this}project(e){return this.applyMatrix4(e.matrixWorldInverse).applyMatrix4(e.projectionMatrix)}unproject(e){return this.applyMatrix4(e.projectionMatrixInverse).applyMatrix4(e.matrixWorld)}transformDirection(e){let t=this.x,n=this.y,r=this.z,s=e.elements;return this.x=s[0]*t+s[4]*n+s[8]*r,this.y=s[1]*t+s[5]*n+s[9]*r,this.z=s[2]*t+s[6]*n+s[10]*r,this.normalize()}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this}divideScalar(e){return this.multiplyScalar(1/e)}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this}clamp(e,t){return this.x=It(this.x,e.x,t.x),this.y=It(this.y,e.y,t.y),this.z=It(this.z,e.z,t.z),this}clampScalar(e,t){return this.x=It(this.x,e,t),this.y=It(this.y,e,t),this.z=It(this.z,e,t),this}clampLength(e,t){let n=this.length();return this.divideScalar(n||1).multiplyScalar(It(n,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this}lerpVectors(e,t,n){return this.x=e.x+(t.x-e.x)*n,this.y=e.y+(t.y-e.y)*n,this.z=e.z+(t.z-e.z)*n,this}cross(e){return this.crossVectors(this,e)}crossVectors(e,t){let n=e.x,r=e.y,s=e.z,o=t.x,a=t.y,l=t.z;return this.x=r*l-s*a,this.y=s*o-n*l,this.z=n*a-r*o,this}projectOnVector(e){let t=e.lengthSq();if(t===0)return this.set(0,0,0);let n=e.dot(this)/t;return this.copy(e).multiplyScalar(n)}projectOnPlane(e){return tf.copy(this).projectOnVector(e),this.sub(tf)}reflect(e){return this.sub(tf.copy(e).multiplyScalar(2*this.dot(e)))}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let n=this.dot(e)/t;return Math.acos(It(n,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,n=this.y-e.y,r=this.z-e.z;return t*t+n*n+r*r}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)+Math.abs(this.z-e.z)}setFromSpherical(e){return this.setFromSphericalCoords(e.radius,e.phi,e.theta)}setFromSphericalCoords(e,t,n){let r=Math.sin(t)*e;return this.x=r*Math.sin(n),this.y=Math.cos(t)*e,this.z=r*Math.cos(n),this}setFromCylindrical(e){return this.setFromCylindricalCoords(e.radius,e.theta,e.y)}setFromCylindricalCoords(e,t,n){return this.x=e*Math.sin(t),this.y=n,this.z=e*Math.cos(t),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this}setFromMatrixScale(e){let t=this.setFromMatrixColumn(e,0).length(),n=this.setFromMatrixColumn(e,1).length(),r=this.setFromMatrixColumn(e,2).length();return this.x=t,this.y=n,this.z=r,this}setFromMatrixColumn(e,t){return this.fromArray(e.elements,t*4)}setFromMatrix3Column(e,t){return this.fromArray(e.elements,t*3)}setFromEuler(e){return this.x=e._x,this.y=e._y,this.z=e._z,this}setFromColor(e){return this.x=e.r,this.y=e.g,this.z=e.b,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let e=Math.random()*Math.PI*2,t=Math.random()*2-1,n=Math.sqrt(1-t*t);return this.x=n*Math.cos(e),this.y=t,this.z=n*Math.sin(e),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},tf=new J,km=new Li,dt=class{static{this.prototype.isMatrix3=!0}constructor(e,t,n,r,s,o,a,l,c){this.elements=[1,0,0,0,1,0,0,0,1],e!==void 0&&this.set(e,t,n,r,s,o,a,l,c)}set(e,t,n,r,s,o,a,l,c){let u=this.elements;return u[0]=e,u[1]=r,u[2]=a,u[3]=t,u[4]=s,u[5]=l,u[6]=n,u[7]=o,u[8]=c,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(e){let t=this.elements,n=e.elements;return t[0]=n[0],t[1]=n[1],t[2]=n[2],t[3]=n[3],t[4]=n[4],t[5]=n[5],t[6]=n[6],t[7]=n[7],t[8]=n[8],this}extractBasis(e,t,n){return e.setFromMatrix3Column(this,0),t.setFromMatrix3Column(this,1),n.setFromMatrix3Column(this,2),this}setFromMatrix4(e){let t=e.elements;return this.set(t[0],t[4],t[8],t[1],t[5],t[9],t[2],t[6],t[10]),this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let n=e.elements,r=t.elements,s=this.elements,o=n[0],a=n[3],l=n[6],c=n[1],u=n[4],h=n[7],f=n[2],d=n[5],m=n[8],b=r[0],g=r[3],_=r[6],S=r[1],T=r[4],M=r[7],P=r[2],R=r[5],y=r[8];return s[0]=o*b+a*S+l*P,s[3]=o*g+a*T+l*R,s[6]=o*_+a*M+l*y,s[1]=c*b+u*S+h*P,s[4]=c*g+u*T+h*R,s[7]=c*_+u*M+h*y,s[2]=f*b+d*S+m*P,s[5]=f*g+d*T+m*R,s[8]=f*_+d*M+m*y,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[3]*=e,t[6]*=e,t[1]*=e,t[4]*=e,t[7]*=e,t[2]*=e,t[5]*=e,t[8]*=e,this}determinant(){let e=this.elements,t=e[0],n=e[1],r=e[2],s=e[3],o=e[4],a=e[5],l=e[6],c=e[7],u=e[8];return t*o*u-t*a*c-n*s*u+n*a*l+r*s*c-r*o*l}invert(){let e=this.elements,t=e[0],n=e[1],r=e[2],s=e[3],o=e[4],a=e[5],l=e[6],c=e[7],u=e[8],h=u*o-a*c,f=a*l-u*s,d=c*s-o*l,m=t*h+n*f+r*d;if(m===0)return this.set(0,0,0,0,0,0,0,0,0);let b=1/m;return e[0]=h*b,e[1]=(r*c-u*n)*b,e[2]=(a*n-r*o)*b,e[3]=f*b,e[4]=(u*t-r*l)*b,e[5]=(r*s-a*t)*b,e[6]=d*b,e[7]=(n*l-c*t)*b,e[8]=(o*t-n*s)*b,this}transpose(){let e,t=this.elements;return e=t[1],t[1]=t[3],t[3]=e,e=t[2],t[2]=t[6],t[6]=e,e=t[5],t[5]=t[7],t[7]=e,this}getNormalMatrix(e){return this.setFromMatrix4(e).invert().transpose()}transposeIntoArray(e){let t=this.elements;return e[0]=t[0],e[1]=t[3],e[2]=t[6],e[3]=t[1],e[4]=t[4],e[5]=t[7],e[6]=t[2],e[7]=t[5],e[8]=t[8],this}setUvTransform(e,t,n,r,s,o,a){let l=Math.cos(s),c=Math.sin(s);return this.set(n*l,n*c,-n*(l*o+c*a)+o+e,-r*c,r*l,-r*(-c*o+l*a)+a+t,0,0,1),this}scale(e,t){return Qs("Matrix3: .scale() is deprecated. Use .makeScale() instead."),this.premultiply(nf.makeScale(e,t)),this}rotate(e){return Qs("Matrix3: .rotate() is deprecated. Use .makeRotation() instead."),this.premultiply(nf.makeRotation(-e)),this}translate(e,t){return Qs("Matrix3: .translate() is deprecated. Use .makeTranslation() instead."),this.premultiply(nf.makeTranslation(e,t)),this}makeTranslation(e,t){return e.isVector2?this.set(1,0,e.x,0,1,e.y,0,0,1):this.set(1,0,e,0,1,t,0,0,1),this}makeRotation(e){let t=Math.cos(e),n=Math.sin(e);return this.set(t,-n,0,n,t,0,0,0,1),this}makeScale(e,t){return this.set(e,0,0,0,t,0,0,0,1),this}equals(e){let t=this.elements,n=e.elements;for(let r=0;r<9;r++)if(t[r]!==n[r])return!1;return!0}fromArray(e,t=0){for(let n=0;n<9;n++)this.elements[n]=e[n+t];return this}toArray(e=[],t=0){let n=this.elements;return e[t]=n[0],e[t+1]=n[1],e[t+2]=n[2],e[t+3]=n[3],e[t+4]=n[4],e[t+5]=n[5],e[t+6]=n[6],e[t+7]=n[7],e[t+8]=n[8],e}clone(){return new this.constructor().fromArray(this.elements)}},nf=new dt,Vm=new dt().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),Hm=new dt().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function W1(){let i={enabled:!0,workingColorSpace:dn,spaces:{},convert:function(r,s,o){return this.enabled===!1||s===o||!s||!o||(this.spaces[s].transfer===Yt&&(r.r=Jr(r.r),r.g=Jr(r.g),r.b=Jr(r.b)),this.spaces[s].primaries!==this.spaces[o].primaries&&(r.applyMatrix3(this.spaces[s].toXYZ),r.applyMatrix3(this.spaces[o].fromXYZ)),this.spaces[o].transfer===Yt&&(r.r=$o(r.r),r.g=$o(r.g),r.b=$o(r.b))),r},workingToColorSpace:function(r,s){return this.convert(r,this.workingColorSpace,s)},colorSpaceToWorking:function(r,s){return this.convert(r,s,this.workingColorSpace)},getPrimaries:function(r){return this.spaces[r].primaries},getTransfer:function(r){return r===cs?il:this.spaces[r].transfer},getToneMappingMode:function(r){return this.spaces[r].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(r,s=this.workingColorSpace){return r.fromArray(this.spaces[s].luminanceCoefficients)},define:function(r){Object.assign(this.spaces,r)},_getMatrix:function(r,s,o){return r.copy(this.spaces[o].fromXYZ).multiply(this.spaces[s].toXYZ)},_getDrawingBufferColorSpace:function(r){return this.spaces[r].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(r=this.workingColorSpace){return this.spaces[r].workingColorSpaceConfig.unpackColorSpace}},e=[.64,.33,.3,.6,.15,.06],t=[.2126,.7152,.0722],n=[.3127,.329];return i.define({[dn]:{primaries:e,whitePoint:n,transfer:il,toXYZ:Vm,fromXYZ:Hm,luminanceCoefficients:t,workingColorSpaceConfig:{unpackColorSpace:Ln},outputColorSpaceConfig:{drawingBufferColorSpace:Ln}},[Ln]:{primaries:e,whitePoint:n,transfer:Yt,toXYZ:Vm,fromXYZ:Hm,luminanceCoefficients:t,outputColorSpaceConfig:{drawingBufferColorSpace:Ln}}}),i}var Rt=W1();function Jr(i){return i<.04045?i*.0773993808:Math.pow(i*.9478672986+.0521327014,2.4)}function $o(i){return i<.0031308?i*12.92:1.055*Math.pow(i,.41666)-.055}var Do,Hc=class{static getDataURL(e,t="image/png"){if(/^data:/i.test(e.src)||typeof HTMLCanvasElement>"u")return e.src;let n;if(e instanceof HTMLCanvasElement)n=e;else{Do===void 0&&(Do=jo("canvas")),Do.width=e.width,Do.height=e.height;let r=Do.getContext("2d");e instanceof ImageData?r.putImageData(e,0,0):r.drawImage(e,0,0,e.width,e.height),n=Do}return n.toDataURL(t)}static sRGBToLinear(e){if(typeof HTMLImageElement<"u"&&e instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&e instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&e instanceof ImageBitmap){let t=jo("canvas");t.width=e.width,t.height=e.height;let n=t.getContext("2d");n.drawImage(e,0,0,e.width,e.height);let r=n.getImageData(0,0,e.width,e.height),s=r.data;for(let o=0;o<s.length;o++)s[o]=Jr(s[o]/255)*255;return n.putImageData(r,0,0),t}else if(e.data){let t=e.data.slice(0);for(let n=0;n<t.length;n++)t instanceof Uint8Array||t instanceof Uint8ClampedArray?t[n]=Math.floor(Jr(t[n]/255)*255):t[n]=Jr(t[n]);return{data:t,width:e.width,height:e.height}}else return nt("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),e}},X1=0,ea=class{constructor(e=null){this.isTextureSource=!0,Object.defineProperty(this,"id",{value:X1++}),this.uuid=Nr(),this.data=e,this.dataReady=!0,this.version=0}getSize(e){let t=this.data;return typeof HTMLVideoElement<"u"&&t instanceof HTMLVideoElement?e.set(t.videoWidth,t.videoHeight,0):typeof VideoFrame<"u"&&t instanceof VideoFrame?e.set(t.displayWidth,t.displayHeight,0):t!==null?e.set(t.width||0,t.height||0,t.depth||0):e.set(0,0,0),e}set needsUpdate(e){e===!0&&this.version++}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.images[this.uuid]!==void 0)return e.images[this.uuid];let n={uuid:this.uuid,url:""},r=this.data;if(r!==null){let s;if(Array.isArray(r)){s=[];for(let o=0,a=r.length;o<a;o++)r[o].isDataTexture?s.push(rf(r[o].image)):s.push(rf(r[o]))}else s=rf(r);n.url=s}return t||(e.images[this.uuid]=n),n}};function rf(i){return typeof HTMLImageElement<"u"&&i instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&i instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&i instanceof ImageBitmap?Hc.getDataURL(i):i.data?{data:Array.from(i.data),width:i.width,height:i.height,type:i.data.constructor.name}:(nt("Texture: Unable to serialize Texture."),{})}var q1=0,sf=new J,$n=class i extends Tr{constructor(e=i.DEFAULT_IMAGE,t=i.DEFAULT_MAPPING,n=si,r=si,s=qt,o=Fi,a=jt,l=bi,c=i.DEFAULT_ANISOTROPY,u=cs){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:q1++}),this.uuid=Nr(),this.name="",this.source=new ea(e),this.mipmaps=[],this.mapping=t,this.channel=0,this.wrapS=n,this.wrapT=r,this.magFilter=s,this.minFilter=o,this.anisotropy=c,this.format=a,this.internalFormat=null,this.type=l,this.offset=new xt(0,0),this.repeat=new xt(1,1),this.center=new xt(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new dt,this.generateMipmaps=!0,this.mipmapsAutoUpdate=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=u,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(e&&e.depth&&e.depth>1),this.pmremVersion=0,this.isPMREMTexture=!1,this.normalized=!1}get width(){return this.source.getSize(sf).x}get height(){return this.source.getSize(sf).y}get depth(){return this.source.getSize(sf).z}get image(){return this.source.data}set image(e){this.source.data=e}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(e){return this.name=e.name,this.source=e.source,this.mipmaps=e.mipmaps.slice(0),this.mapping=e.mapping,this.channel=e.channel,this.wrapS=e.wrapS,this.wrapT=e.wrapT,this.magFilter=e.magFilter,this.minFilter=e.minFilter,this.anisotropy=e.anisotropy,this.format=e.format,this.internalFormat=e.internalFormat,this.type=e.type,this.normalized=e.normalized,this.offset.copy(e.offset),this.repeat.copy(e.repeat),this.center.copy(e.center),this.rotation=e.rotation,this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrix.copy(e.matrix),this.generateMipmaps=e.generateMipmaps,this.mipmapsAutoUpdate=e.mipmapsAutoUpdate,this.premultiplyAlpha=e.premultiplyAlpha,this.flipY=e.flipY,this.unpackAlignment=e.unpackAlignment,this.colorSpace=e.colorSpace,this.renderTarget=e.renderTarget,this.isRenderTargetTexture=e.isRenderTargetTexture,this.isPMREMTexture=e.isPMREMTexture,this.isArrayTexture=e.isArrayTexture,this.userData=JSON.parse(JSON.stringify(e.userData)),this.needsUpdate=!0,this}setValues(e){for(let t in e){let n=e[t];if(n===void 0){nt(`Texture.setValues(): parameter '${t}' has value of undefined.`);continue}let r=this[t];if(r===void 0){nt(`Texture.setValues(): property '${t}' does not exist.`);continue}r&&n&&r.isVector2&&n.isVector2||r&&n&&r.isVector3&&n.isVector3||r&&n&&r.isMatrix3&&n.isMatrix3?r.copy(n):this[t]=n}}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.textures[this.uuid]!==void 0)return e.textures[this.uuid];let n={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(e).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,mipmapsAutoUpdate:this.mipmapsAutoUpdate,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(n.userData=this.userData),t||(e.textures[this.uuid]=n),n}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(e){if(this.mapping!==Jf)return e;if(e.applyMatrix3(this.matrix),e.x<0||e.x>1)switch(this.wrapS){case Ns:e.x=e.x-Math.floor(e.x);break;case si:e.x=e.x<0?0:1;break;case Ko:Math.abs(Math.floor(e.x)%2)===1?e.x=Math.ceil(e.x)-e.x:e.x=e.x-Math.floor(e.x);break}if(e.y<0||e.y>1)switch(this.wrapT){case Ns:e.y=e.y-Math.floor(e.y);break;case si:e.y=e.y<0?0:1;break;case Ko:Math.abs(Math.floor(e.y)%2)===1?e.y=Math.ceil(e.y)-e.y:e.y=e.y-Math.floor(e.y);break}return this.flipY&&(e.y=1-e.y),e}set needsUpdate(e){e===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(e){e===!0&&this.pmremVersion++}};$n.DEFAULT_IMAGE=null;$n.DEFAULT_MAPPING=Jf;$n.DEFAULT_ANISOTROPY=1;var Ot=class{static{this.prototype.isVector4=!0}constructor(e=0,t=0,n=0,r=1){this.x=e,this.y=t,this.z=n,this.w=r}get width(){return this.z}set width(e){this.z=e}get height(){return this.w}set height(e){this.w=e}set(e,t,n,r){return this.x=e,this.y=t,this.z=n,this.w=r,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this.w=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setW(e){return this.w=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;case 3:this.w=t;break;default:throw new Error("THREE.Vector4: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("THREE.Vector4: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this.w=e.w!==void 0?e.w:1,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this.w+=e.w,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this.w+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this.w=e.w+t.w,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this.w+=e.w*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this.w-=e.w,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this.w-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this.w=e.w-t.w,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this.w*=e.w,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this.w*=e,this}applyMatrix4(e){let t=this.x,n=this.y,r=this.z,s=this.w,o=e.elements;return this.x=o[0]*t+o[4]*n+o[8]*r+o[12]*s,this.y=o[1]*t+o[5]*n+o[9]*r+o[13]*s,this.z=o[2]*t+o[6]*n+o[10]*r+o[14]*s,this.w=o[3]*t+o[7]*n+o[11]*r+o[15]*s,this}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this.w/=e.w,this}divideScalar(e){return this.multiplyScalar(1/e)}setAxisAngleFromQuaternion(e){this.w=2*Math.acos(e.w);let t=Math.sqrt(1-e.w*e.w);return t<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=e.x/t,this.y=e.y/t,this.z=e.z/t),this}setAxisAngleFromRotationMatrix(e){let t,n,r,s,l=e.elements,c=l[0],u=l[4],h=l[8],f=l[1],d=l[5],m=l[9],b=l[2],g=l[6],_=l[10];if(Math.abs(u-f)<.01&&Math.abs(h-b)<.01&&Math.abs(m-g)<.01){if(Math.abs(u+f)<.1&&Math.abs(h+b)<.1&&Math.abs(m+g)<.1&&Math.abs(c+d+_-3)<.1)return this.set(1,0,0,0),this;t=Math.PI;let T=(c+1)/2,M=(d+1)/2,P=(_+1)/2,R=(u+f)/4,y=(h+b)/4,A=(m+g)/4;return T>M&&T>P?T<.01?(n=0,r=.707106781,s=.707106781):(n=Math.sqrt(T),r=R/n,s=y/n):M>P?M<.01?(n=.707106781,r=0,s=.707106781):(r=Math.sqrt(M),n=R/r,s=A/r):P<.01?(n=.707106781,r=.707106781,s=0):(s=Math.sqrt(P),n=y/s,r=A/s),this.set(n,r,s,t),this}let S=Math.sqrt((g-m)*(g-m)+(h-b)*(h-b)+(f-u)*(f-u));return Math.abs(S)<.001&&(S=1),this.x=(g-m)/S,this.y=(h-b)/S,this.z=(f-u)/S,this.w=Math.acos((c+d+_-1)/2),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this.w=t[15],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this.w=Math.min(this.w,e.w),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this.w=Math.max(this.w,e.w),this}clamp(e,t){return this.x=It(this.x,e.x,t.x),this.y=It(this.y,e.y,t.y),this.z=It(this.z,e.z,t.z),this.w=It(this.w,e.w,t.w),this}clampScalar(e,t){return this.x=It(this.x,e,t),this.y=It(this.y,e,t),this.z=It(this.z,e,t),this.w=It(this.w,e,t),this}clampLength(e,t){let n=this.length();return this.divideScalar(n||1).multiplyScalar(It(n,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z+this.w*e.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this.w+=(e.w-this.w)*t,this}lerpVectors(e,t,n){return this.x=e.x+(t.x-e.x)*n,this.y=e.y+(t.y-e.y)*n,this.z=e.z+(t.z-e.z)*n,this.w=e.w+(t.w-e.w)*n,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z&&e.w===this.w}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this.w=e[t+3],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e[t+3]=this.w,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this.w=e.getW(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}},Gc=class extends Tr{constructor(e=1,t=1,n={}){super(),n=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:qt,depthBuffer:!0,stencilBuffer:!1,resolveColorBuffer:!0,resolveDepthBuffer:!0,resolveStencilBuffer:!0,storeMultisampledColorBuffer:!0,storeMultisampledDepthBuffer:!0,storeMultisampledStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1,useArrayDepthTexture:!1},n),this.isRenderTarget=!0,this.width=e,this.height=t,this.depth=n.depth,this.scissor=new Ot(0,0,e,t),this.scissorTest=!1,this.viewport=new Ot(0,0,e,t),this.textures=[];let r=n.count;for(let s=0;s<r;s++)this.textures[s]=new $n({width:e,height:t,depth:n.depth}),this.textures[s].isRenderTargetTexture=!0,this.textures[s].renderTarget=this;this._setTextureOptions(n),this.depthBuffer=n.depthBuffer,this.stencilBuffer=n.stencilBuffer,this.resolveColorBuffer=n.resolveColorBuffer,this.resolveDepthBuffer=n.resolveDepthBuffer,this.resolveStencilBuffer=n.resolveStencilBuffer,this.storeMultisampledColorBuffer=n.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=n.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=n.storeMultisampledStencilBuffer,this._depthTexture=null,this.depthTexture=n.depthTexture,this.samples=n.samples,this.multiview=n.multiview,this.useArrayDepthTexture=n.useArrayDepthTexture}_setTextureOptions(e={}){let t={minFilter:qt,generateMipmaps:!1,flipY:!1,internalFormat:null};e.mapping!==void 0&&(t.mapping=e.mapping),e.wrapS!==void 0&&(t.wrapS=e.wrapS),e.wrapT!==void 0&&(t.wrapT=e.wrapT),e.wrapR!==void 0&&(t.wrapR=e.wrapR),e.magFilter!==void 0&&(t.magFilter=e.magFilter),e.minFilter!==void 0&&(t.minFilter=e.minFilter),e.format!==void 0&&(t.format=e.format),e.type!==void 0&&(t.type=e.type),e.anisotropy!==void 0&&(t.anisotropy=e.anisotropy),e.colorSpace!==void 0&&(t.colorSpace=e.colorSpace),e.flipY!==void 0&&(t.flipY=e.flipY),e.generateMipmaps!==void 0&&(t.generateMipmaps=e.generateMipmaps),e.mipmapsAutoUpdate!==void 0&&(t.mipmapsAutoUpdate=e.mipmapsAutoUpdate),e.internalFormat!==void 0&&(t.internalFormat=e.internalFormat);for(let n=0;n<this.textures.length;n++)this.textures[n].setValues(t)}get texture(){return this.textures[0]}set texture(e){this.textures[0]=e}set depthTexture(e){this._depthTexture!==null&&this._depthTexture.renderTarget===this&&(this._depthTexture.renderTarget=null),e!==null&&e.renderTarget===null&&(e.renderTarget=this),this._depthTexture=e}get depthTexture(){return this._depthTexture}setSize(e,t,n=1){if(this.width!==e||this.height!==t||this.depth!==n){this.width=e,this.height=t,this.depth=n;for(let r=0,s=this.textures.length;r<s;r++)this.textures[r].image.width=e,this.textures[r].image.height=t,this.textures[r].image.depth=n,this.textures[r].isData3DTexture!==!0&&(this.textures[r].isArrayTexture=this.textures[r].image.depth>1);this.dispose()}this.viewport.set(0,0,e,t),this.scissor.set(0,0,e,t)}clone(){return new this.constructor().copy(this)}copy(e){this.width=e.width,this.height=e.height,this.depth=e.depth,this.scissor.copy(e.scissor),this.scissorTest=e.scissorTest,this.viewport.copy(e.viewport),this.textures.length=0;for(let t=0,n=e.textures.length;t<n;t++){this.textures[t]=e.textures[t].clone(),this.textures[t].isRenderTargetTexture=!0,this.textures[t].renderTarget=this;let r=Object.assign({},e.textures[t].image);this.textures[t].source=new ea(r)}if(this.depthBuffer=e.depthBuffer,this.stencilBuffer=e.stencilBuffer,this.resolveColorBuffer=e.resolveColorBuffer,this.resolveDepthBuffer=e.resolveDepthBuffer,this.resolveStencilBuffer=e.resolveStencilBuffer,this.storeMultisampledColorBuffer=e.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=e.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=e.storeMultisampledStencilBuffer,e.depthTexture!==null)if(e.depthTexture.renderTarget===e){let t=e.depthTexture.clone();t.renderTarget=null,this.depthTexture=t}else this.depthTexture=e.depthTexture;else this.depthTexture=null;return this.samples=e.samples,this.multiview=e.multiview,this.useArrayDepthTexture=e.useArrayDepthTexture,this}dispose(){this.dispatchEvent({type:"dispose"})}},Zn=class extends Gc{constructor(e=1,t=1,n={}){super(e,t,n),this.isWebGLRenderTarget=!0}},io=class extends $n{constructor(e=null,t=1,n=1,r=1){super(null),this.isDataArrayTexture=!0,this.image={data:e,width:t,height:n,depth:r},this.magFilter=Ut,this.minFilter=Ut,this.wrapR=si,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}addLayerUpdate(e){this.layerUpdates.add(e)}clearLayerUpdates(){this.layerUpdates.clear()}};var Wc=class extends $n{constructor(e=null,t=1,n=1,r=1){super(null),this.isData3DTexture=!0,this.image={data:e,width:t,height:n,depth:r},this.magFilter=Ut,this.minFilter=Ut,this.wrapR=si,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}};var it=class i{static{this.prototype.isMatrix4=!0}constructor(e,t,n,r,s,o,a,l,c,u,h,f,d,m,b,g){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],e!==void 0&&this.set(e,t,n,r,s,o,a,l,c,u,h,f,d,m,b,g)}set(e,t,n,r,s,o,a,l,c,u,h,f,d,m,b,g){let _=this.elements;return _[0]=e,_[4]=t,_[8]=n,_[12]=r,_[1]=s,_[5]=o,_[9]=a,_[13]=l,_[2]=c,_[6]=u,_[10]=h,_[14]=f,_[3]=d,_[7]=m,_[11]=b,_[15]=g,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new i().fromArray(this.elements)}copy(e){let t=this.elements,n=e.elements;return t[0]=n[0],t[1]=n[1],t[2]=n[2],t[3]=n[3],t[4]=n[4],t[5]=n[5],t[6]=n[6],t[7]=n[7],t[8]=n[8],t[9]=n[9],t[10]=n[10],t[11]=n[11],t[12]=n[12],t[13]=n[13],t[14]=n[14],t[15]=n[15],this}copyPosition(e){let t=this.elements,n=e.elements;return t[12]=n[12],t[13]=n[13],t[14]=n[14],this}setFromMatrix3(e){let t=e.elements;return this.set(t[0],t[3],t[6],0,t[1],t[4],t[7],0,t[2],t[5],t[8],0,0,0,0,1),this}extractBasis(e,t,n){return this.determinantAffine()===0?(e.set(1,0,0),t.set(0,1,0),n.set(0,0,1),this):(e.setFromMatrixColumn(this,0),t.setFromMatrixColumn(this,1),n.setFromMatrixColumn(this,2),this)}makeBasis(e,t,n){return this.set(e.x,t.x,n.x,0,e.y,t.y,n.y,0,e.z,t.z,n.z,0,0,0,0,1),this}extractRotation(e){if(e.determinantAffine()===0)return this.identity();let t=this.elements,n=e.elements,r=1/Fo.setFromMatrixColumn(e,0).length(),s=1/Fo.setFromMatrixColumn(e,1).length(),o=1/Fo.setFromMatrixColumn(e,2).length();return t[0]=n[0]*r,t[1]=n[1]*r,t[2]=n[2]*r,t[3]=0,t[4]=n[4]*s,t[5]=n[5]*s,t[6]=n[6]*s,t[7]=0,t[8]=n[8]*o,t[9]=n[9]*o,t[10]=n[10]*o,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromEuler(e){let t=this.elements,n=e.x,r=e.y,s=e.z,o=Math.cos(n),a=Math.sin(n),l=Math.cos(r),c=Math.sin(r),u=Math.cos(s),h=Math.sin(s);if(e.order==="XYZ"){let f=o*u,d=o*h,m=a*u,b=a*h;t[0]=l*u,t[4]=-l*h,t[8]=c,t[1]=d+m*c,t[5]=f-b*c,t[9]=-a*l,t[2]=b-f*c,t[6]=m+d*c,t[10]=o*l}else if(e.order==="YXZ"){let f=l*u,d=l*h,m=c*u,b=c*h;t[0]=f+b*a,t[4]=m*a-d,t[8]=o*c,t[1]=o*h,t[5]=o*u,t[9]=-a,t[2]=d*a-m,t[6]=b+f*a,t[10]=o*l}else if(e.order==="ZXY"){let f=l*u,d=l*h,m=c*u,b=c*h;t[0]=f-b*a,t[4]=-o*h,t[8]=m+d*a,t[1]=d+m*a,t[5]=o*u,t[9]=b-f*a,t[2]=-o*c,t[6]=a,t[10]=o*l}else if(e.order==="ZYX"){let f=o*u,d=o*h,m=a*u,b=a*h;t[0]=l*u,t[4]=m*c-d,t[8]=f*c+b,t[1]=l*h,t[5]=b*c+f,t[9]=d*c-m,t[2]=-c,t[6]=a*l,t[10]=o*l}else if(e.order==="YZX"){let f=o*l,d=o*c,m=a*l,b=a*c;t[0]=l*u,t[4]=b-f*h,t[8]=m*h+d,t[1]=h,t[5]=o*u,t[9]=-a*u,t[2]=-c*u,t[6]=d*h+m,t[10]=f-b*h}else if(e.order==="XZY"){let f=o*l,d=o*c,m=a*l,b=a*c;t[0]=l*u,t[4]=-h,t[8]=c*u,t[1]=f*h+b,t[5]=o*u,t[9]=d*h-m,t[2]=m*h-d,t[6]=a*u,t[10]=b*h+f}return t[3]=0,t[7]=0,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromQuaternion(e){return this.compose(Y1,e,$1)}lookAt(e,t,n){let r=this.elements;return Ci.subVectors(e,t),Ci.lengthSq()===0&&(Ci.z=1),Ci.normalize(),As.crossVectors(n,Ci),As.lengthSq()===0&&(Math.abs(n.z)===1?Ci.x+=1e-4:Ci.z+=1e-4,Ci.normalize(),As.crossVectors(n,Ci)),As.normalize(),lc.crossVectors(Ci,As),r[0]=As.x,r[4]=lc.x,r[8]=Ci.x,r[1]=As.y,r[5]=lc.y,r[9]=Ci.y,r[2]=As.z,r[6]=lc.z,r[10]=Ci.z,this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let n=e.elements,r=t.elements,s=this.elements,o=n[0],a=n[4],l=n[8],c=n[12],u=n[1],h=n[5],f=n[9],d=n[13],m=n[2],b=n[6],g=n[10],_=n[14],S=n[3],T=n[7],M=n[11],P=n[15],R=r[0],y=r[4],A=r[8],V=r[12],z=r[1],D=r[5],q=r[9],Y=r[13],U=r[2],W=r[6],K=r[10],$=r[14],xe=r[3],ne=r[7],re=r[11],de=r[15];return s[0]=o*R+a*z+l*U+c*xe,s[4]=o*y+a*D+l*W+c*ne,s[8]=o*A+a*q+l*K+c*re,s[12]=o*V+a*Y+l*$+c*de,s[1]=u*R+h*z+f*U+d*xe,s[5]=u*y+h*D+f*W+d*ne,s[9]=u*A+h*q+f*K+d*re,s[13]=u*V+h*Y+f*$+d*de,s[2]=m*R+b*z+g*U+_*xe,s[6]=m*y+b*D+g*W+_*ne,s[10]=m*A+b*q+g*K+_*re,s[14]=m*V+b*Y+g*$+_*de,s[3]=S*R+T*z+M*U+P*xe,s[7]=S*y+T*D+M*W+P*ne,s[11]=S*A+T*q+M*K+P*re,s[15]=S*V+T*Y+M*$+P*de,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[4]*=e,t[8]*=e,t[12]*=e,t[1]*=e,t[5]*=e,t[9]*=e,t[13]*=e,t[2]*=e,t[6]*=e,t[10]*=e,t[14]*=e,t[3]*=e,t[7]*=e,t[11]*=e,t[15]*=e,this}determinant(){let e=this.elements,t=e[0],n=e[4],r=e[8],s=e[12],o=e[1],a=e[5],l=e[9],c=e[13],u=e[2],h=e[6],f=e[10],d=e[14],m=e[3],b=e[7],g=e[11],_=e[15],S=l*d-c*f,T=a*d-c*h,M=a*f-l*h,P=o*d-c*u,R=o*f-l*u,y=o*h-a*u;return t*(b*S-g*T+_*M)-n*(m*S-g*P+_*R)+r*(m*T-b*P+_*y)-s*(m*M-b*R+g*y)}determinantAffine(){let e=this.elements,t=e[0],n=e[4],r=e[8],s=e[1],o=e[5],a=e[9],l=e[2],c=e[6],u=e[10];return t*(o*u-a*c)-n*(s*u-a*l)+r*(s*c-o*l)}transpose(){let e=this.elements,t;return t=e[1],e[1]=e[4],e[4]=t,t=e[2],e[2]=e[8],e[8]=t,t=e[6],e[6]=e[9],e[9]=t,t=e[3],e[3]=e[12],e[12]=t,t=e[7],e[7]=e[13],e[13]=t,t=e[11],e[11]=e[14],e[14]=t,this}setPosition(e,t,n){let r=this.elements;return e.isVector3?(r[12]=e.x,r[13]=e.y,r[14]=e.z):(r[12]=e,r[13]=t,r[14]=n),this}invert(){let e=this.elements,t=e[0],n=e[1],r=e[2],s=e[3],o=e[4],a=e[5],l=e[6],c=e[7],u=e[8],h=e[9],f=e[10],d=e[11],m=e[12],b=e[13],g=e[14],_=e[15],S=t*a-n*o,T=t*l-r*o,M=t*c-s*o,P=n*l-r*a,R=n*c-s*a,y=r*c-s*l,A=u*b-h*m,V=u*g-f*m,z=u*_-d*m,D=h*g-f*b,q=h*_-d*b,Y=f*_-d*g,U=S*Y-T*q+M*D+P*z-R*V+y*A;if(U===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let W=1/U;return e[0]=(a*Y-l*q+c*D)*W,e[1]=(r*q-n*Y-s*D)*W,e[2]=(b*y-g*R+_*P)*W,e[3]=(f*R-h*y-d*P)*W,e[4]=(l*z-o*Y-c*V)*W,e[5]=(t*Y-r*z+s*V)*W,e[6]=(g*M-m*y-_*T)*W,e[7]=(u*y-f*M+d*T)*W,e[8]=(o*q-a*z+c*A)*W,e[9]=(n*z-t*q-s*A)*W,e[10]=(m*R-b*M+_*S)*W,e[11]=(h*M-u*R-d*S)*W,e[12]=(a*V-o*D-l*A)*W,e[13]=(t*D-n*V+r*A)*W,e[14]=(b*T-m*P-g*S)*W,e[15]=(u*P-h*T+f*S)*W,this}scale(e){let t=this.elements,n=e.x,r=e.y,s=e.z;return t[0]*=n,t[4]*=r,t[8]*=s,t[1]*=n,t[5]*=r,t[9]*=s,t[2]*=n,t[6]*=r,t[10]*=s,t[3]*=n,t[7]*=r,t[11]*=s,this}getMaxScaleOnAxis(){let e=this.elements,t=e[0]*e[0]+e[1]*e[1]+e[2]*e[2],n=e[4]*e[4]+e[5]*e[5]+e[6]*e[6],r=e[8]*e[8]+e[9]*e[9]+e[10]*e[10];return Math.sqrt(Math.max(t,n,r))}makeTranslation(e,t,n){return e.isVector3?this.set(1,0,0,e.x,0,1,0,e.y,0,0,1,e.z,0,0,0,1):this.set(1,0,0,e,0,1,0,t,0,0,1,n,0,0,0,1),this}makeRotationX(e){let t=Math.cos(e),n=Math.sin(e);return this.set(1,0,0,0,0,t,-n,0,0,n,t,0,0,0,0,1),this}makeRotationY(e){let t=Math.cos(e),n=Math.sin(e);return this.set(t,0,n,0,0,1,0,0,-n,0,t,0,0,0,0,1),this}makeRotationZ(e){let t=Math.cos(e),n=Math.sin(e);return this.set(t,-n,0,0,n,t,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(e,t){let n=Math.cos(t),r=Math.sin(t),s=1-n,o=e.x,a=e.y,l=e.z,c=s*o,u=s*a;return this.set(c*o+n,c*a-r*l,c*l+r*a,0,c*a+r*l,u*a+n,u*l-r*o,0,c*l-r*a,u*l+r*o,s*l*l+n,0,0,0,0,1),this}makeScale(e,t,n){return this.set(e,0,0,0,0,t,0,0,0,0,n,0,0,0,0,1),this}makeShear(e,t,n,r,s,o){return this.set(1,n,s,0,e,1,o,0,t,r,1,0,0,0,0,1),this}compose(e,t,n){let r=this.elements,s=t._x,o=t._y,a=t._z,l=t._w,c=s+s,u=o+o,h=a+a,f=s*c,d=s*u,m=s*h,b=o*u,g=o*h,_=a*h,S=l*c,T=l*u,M=l*h,P=n.x,R=n.y,y=n.z;return r[0]=(1-(b+_))*P,r[1]=(d+M)*P,r[2]=(m-T)*P,r[3]=0,r[4]=(d-M)*R,r[5]=(1-(f+_))*R,r[6]=(g+S)*R,r[7]=0,r[8]=(m+T)*y,r[9]=(g-S)*y,r[10]=(1-(f+b))*y,r[11]=0,r[12]=e.x,r[13]=e.y,r[14]=e.z,r[15]=1,this}decompose(e,t,n){let r=this.elements;e.x=r[12],e.y=r[13],e.z=r[14];let s=this.determinantAffine();if(s===0)return n.set(1,1,1),t.identity(),this;let o=Fo.set(r[0],r[1],r[2]).length(),a=Fo.set(r[4],r[5],r[6]).length(),l=Fo.set(r[8],r[9],r[10]).length();s<0&&(o=-o),rr.copy(this);let c=1/o,u=1/a,h=1/l;return rr.elements[0]*=c,rr.elements[1]*=c,rr.elements[2]*=c,rr.elements[4]*=u,rr.elements[5]*=u,rr.elements[6]*=u,rr.elements[8]*=h,rr.elements[9]*=h,rr.elements[10]*=h,t.setFromRotationMatrix(rr),n.x=o,n.y=a,n.z=l,this}makePerspective(e,t,n,r,s,o,a=Wi,l=!1){let c=this.elements,u=2*s/(t-e),h=2*s/(n-r),f=(t+e)/(t-e),d=(n+r)/(n-r),m,b;if(l)m=s/(o-s),b=o*s/(o-s);else if(a===Wi)m=-(o+s)/(o-s),b=-2*o*s/(o-s);else if(a===Jo)m=-o/(o-s),b=-o*s/(o-s);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return c[0]=u,c[4]=0,c[8]=f,c[12]=0,c[1]=0,c[5]=h,c[9]=d,c[13]=0,c[2]=0,c[6]=0,c[10]=m,c[14]=b,c[3]=0,c[7]=0,c[11]=-1,c[15]=0,this}makeOrthographic(e,t,n,r,s,o,a=Wi,l=!1){let c=this.elements,u=2/(t-e),h=2/(n-r),f=-(t+e)/(t-e),d=-(n+r)/(n-r),m,b;if(l)m=1/(o-s),b=o/(o-s);else if(a===Wi)m=-2/(o-s),b=-(o+s)/(o-s);else if(a===Jo)m=-1/(o-s),b=-s/(o-s);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return c[0]=u,c[4]=0,c[8]=0,c[12]=f,c[1]=0,c[5]=h,c[9]=0,c[13]=d,c[2]=0,c[6]=0,c[10]=m,c[14]=b,c[3]=0,c[7]=0,c[11]=0,c[15]=1,this}equals(e){let t=this.elements,n=e.elements;for(let r=0;r<16;r++)if(t[r]!==n[r])return!1;return!0}fromArray(e,t=0){for(let n=0;n<16;n++)this.elements[n]=e[n+t];return this}toArray(e=[],t=0){let n=this.elements;return e[t]=n[0],e[t+1]=n[1],e[t+2]=n[2],e[t+3]=n[3],e[t+4]=n[4],e[t+5]=n[5],e[t+6]=n[6],e[t+7]=n[7],e[t+8]=n[8],e[t+9]=n[9],e[t+10]=n[10],e[t+11]=n[11],e[t+12]=n[12],e[t+13]=n[13],e[t+14]=n[14],e[t+15]=n[15],e}},Fo=new J,rr=new it,Y1=new J(0,0,0),$1=new J(1,1,1),As=new J,lc=new J,Ci=new J,Gm=new it,Wm=new Li,Ar=class i{constructor(e=0,t=0,n=0,r=i.DEFAULT_ORDER){this.isEuler=!0,this._x=e,this._y=t,this._z=n,this._order=r}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get order(){return this._order}set order(e){this._order=e,this._onChangeCallback()}set(e,t,n,r=this._order){return this._x=e,this._y=t,this._z=n,this._order=r,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(e){return this._x=e._x,this._y=e._y,this._z=e._z,this._order=e._order,this._onChangeCallback(),this}setFromRotationMatrix(e,t=this._order,n=!0){let r=e.elements,s=r[0],o=r[4],a=r[8],l=r[1],c=r[5],u=r[9],h=r[2],f=r[6],d=r[10];switch(t){case"XYZ":this._y=Math.asin(It(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-u,d),this._z=Math.atan2(-o,s)):(this._x=Math.atan2(f,c),this._z=0);break;case"YXZ":this._x=Math.asin(-It(u,-1,1)),Math.abs(u)<.9999999?(this._y=Math.atan2(a,d),this._z=Math.atan2(l,c)):(this._y=Math.atan2(-h,s),this._z=0);break;case"ZXY":this._x=Math.asin(It(f,-1,1)),Math.abs(f)<.9999999?(this._y=Math.atan2(-h,d),this._z=Math.atan2(-o,c)):(this._y=0,this._z=Math.atan2(l,s));break;case"ZYX":this._y=Math.asin(-It(h,-1,1)),Math.abs(h)<.9999999?(this._x=Math.atan2(f,d),this._z=Math.atan2(l,s)):(this._x=0,this._z=Math.atan2(-o,c));break;case"YZX":this._z=Math.asin(It(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(-u,c),this._y=Math.atan2(-h,s)):(this._x=0,this._y=Math.atan2(a,d));break;case"XZY":this._z=Math.asin(-It(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(f,c),this._y=Math.atan2(a,s)):(this._x=Math.atan2(-u,d),this._y=0);break;default:nt("Euler: .setFromRotationMatrix() encountered an unknown order: "+t)}return this._order=t,n===!0&&this._onChangeCallback(),this}setFromQuaternion(e,t,n){return Gm.makeRotationFromQuaternion(e),this.setFromRotationMatrix(Gm,t,n)}setFromVector3(e,t=this._order){return this.set(e.x,e.y,e.z,t)}reorder(e){return Wm.setFromEuler(this),this.setFromQuaternion(Wm,e)}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._order===this._order}fromArray(e){return this._x=e[0],this._y=e[1],this._z=e[2],e[3]!==void 0&&(this._order=e[3]),this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._order,e}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};Ar.DEFAULT_ORDER="XYZ";var sl=class{constructor(){this.mask=1}set(e){this.mask=(1<<e|0)>>>0}enable(e){this.mask|=1<<e|0}enableAll(){this.mask=-1}toggle(e){this.mask^=1<<e|0}disable(e){this.mask&=~(1<<e|0)}disableAll(){this.mask=0}test(e){return(this.mask&e.mask)!==0}isEnabled(e){return(this.mask&(1<<e|0))!==0}},Z1=0,Xm=new J,Uo=new Li,Wr=new it,cc=new J,qa=new J,K1=new J,J1=new Li,qm=new J(1,0,0),Ym=new J(0,1,0),$m=new J(0,0,1),Zm={type:"added"},j1={type:"removed"},Oo={type:"childadded",child:null},of={type:"childremoved",child:null},wn=class i extends Tr{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:Z1++}),this.uuid=Nr(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=i.DEFAULT_UP.clone();let e=new J,t=new Ar,n=new Li,r=new J(1,1,1);function s(){n.setFromEuler(t,!1)}function o(){t.setFromQuaternion(n,void 0,!1)}t._onChange(s),n._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:e},rotation:{configurable:!0,enumerable:!0,value:t},quaternion:{configurable:!0,enumerable:!0,value:n},scale:{configurable:!0,enumerable:!0,value:r},modelViewMatrix:{value:new it},normalMatrix:{value:new dt}}),this.matrix=new it,this.matrixWorld=new it,this.matrixAutoUpdate=i.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=i.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new sl,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(e){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(e),this.matrix.decompose(this.position,this.quaternion,this.scale),this.pivot!==null&&this.position.copy(this.pivot).applyMatrix4(this.matrix).sub(this.pivot)}applyQuaternion(e){return this.quaternion.premultiply(e),this}setRotationFromAxisAngle(e,t){this.quaternion.setFromAxisAngle(e,t)}setRotationFromEuler(e){this.quaternion.setFromEuler(e,!0)}setRotationFromMatrix(e){this.quaternion.setFromRotationMatrix(e)}setRotationFromQuaternion(e){this.quaternion.copy(e)}rotateOnAxis(e,t){return Uo.setFromAxisAngle(e,t),this.quaternion.multiply(Uo),this}rotateOnWorldAxis(e,t){return Uo.setFromAxisAngle(e,t),this.quaternion.premultiply(Uo),this}rotateX(e){return this.rotateOnAxis(qm,e)}rotateY(e){return this.rotateOnAxis(Ym,e)}rotateZ(e){return this.rotateOnAxis($m,e)}translateOnAxis(e,t){return Xm.copy(e).applyQuaternion(this.quaternion),this.position.add(Xm.multiplyScalar(t)),this}translateX(e){return this.translateOnAxis(qm,e)}translateY(e){return this.translateOnAxis(Ym,e)}translateZ(e){return this.translateOnAxis($m,e)}localToWorld(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(this.matrixWorld)}worldToLocal(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(Wr.copy(this.matrixWorld).invert())}lookAt(e,t,n){e.isVector3?cc.copy(e):cc.set(e,t,n);let r=this.parent;this.updateWorldMatrix(!0,!1),qa.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?Wr.lookAt(qa,cc,this.up):Wr.lookAt(cc,qa,this.up),this.quaternion.setFromRotationMatrix(Wr),r&&(Wr.extractRotation(r.matrixWorld),Uo.setFromRotationMatrix(Wr),this.quaternion.premultiply(Uo.invert()))}add(e){if(arguments.length>1){for(let t=0;t<arguments.length;t++)this.add(arguments[t]);return this}return e===this?(_t("Object3D.add: object can't be added as a child of itself.",e),this):(e&&e.isObject3D?(e.removeFromParent(),e.parent=this,this.children.push(e),e.dispatchEvent(Zm),Oo.child=e,this.dispatchEvent(Oo),Oo.child=null):_t("Object3D.add: object not an instance of THREE.Object3D.",e),this)}remove(e){if(arguments.length>1){for(let n=0;n<arguments.length;n++)this.remove(arguments[n]);return this}let t=this.children.indexOf(e);return t!==-1&&(e.parent=null,this.children.splice(t,1),e.dispatchEvent(j1),of.child=e,this.dispatchEvent(of),of.child=null),this}removeFromParent(){let e=this.parent;return e!==null&&e.remove(this),this}clear(){return this.remove(...this.children)}attach(e){return this.updateWorldMatrix(!0,!1),Wr.copy(this.matrixWorld).invert(),e.parent!==null&&(e.parent.updateWorldMatrix(!0,!1),Wr.multiply(e.parent.matrixWorld)),e.applyMatrix4(Wr),e.removeFromParent(),e.parent=this,this.children.push(e),e.updateWorldMatrix(!1,!0),e.dispatchEvent(Zm),Oo.child=e,this.dispatchEvent(Oo),Oo.child=null,this}getObjectById(e){return this.getObjectByProperty("id",e)}getObjectByName(e){return this.getObjectByProperty("name",e)}getObjectByProperty(e,t){if(this[e]===t)return this;for(let n=0,r=this.children.length;n<r;n++){let o=this.children[n].getObjectByProperty(e,t);if(o!==void 0)return o}}getObjectsByProperty(e,t,n=[]){this[e]===t&&n.push(this);let r=this.children;for(let s=0,o=r.length;s<o;s++)r[s].getObjectsByProperty(e,t,n);return n}getWorldPosition(e){return this.updateWorldMatrix(!0,!1),e.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(qa,e,K1),e}getWorldScale(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(qa,J1,e),e}getWorldDirection(e){this.updateWorldMatrix(!0,!1);let t=this.matrixWorld.elements;return e.set(t[8],t[9],t[10]).normalize()}raycast(){}intersectsFrustum(){return!0}traverse(e){e(this);let t=this.children;for(let n=0,r=t.length;n<r;n++)t[n].traverse(e)}traverseVisible(e){if(this.visible===!1)return;e(this);let t=this.children;for(let n=0,r=t.length;n<r;n++)t[n].traverseVisible(e)}traverseAncestors(e){let t=this.parent;t!==null&&(e(t),t.traverseAncestors(e))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);let e=this.pivot;if(e!==null){let t=e.x,n=e.y,r=e.z,s=this.matrix.elements;s[12]+=t-s[0]*t-s[4]*n-s[8]*r,s[13]+=n-s[1]*t-s[5]*n-s[9]*r,s[14]+=r-s[2]*t-s[6]*n-s[10]*r}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(e){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||e)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,e=!0);let t=this.children;for(let n=0,r=t.length;n<r;n++)t[n].updateMatrixWorld(e)}updateWorldMatrix(e,t,n=!1){let r=this.parent;if(e===!0&&r!==null&&r.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||n)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,n=!0),t===!0){let s=this.children;for(let o=0,a=s.length;o<a;o++)s[o].updateWorldMatrix(!1,!0,n)}}toJSON(e){let t=e===void 0||typeof e=="string",n={};t&&(e={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},n.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let r={};r.uuid=this.uuid,r.type=this.type,r.name=this.name,r.castShadow=this.castShadow,r.receiveShadow=this.receiveShadow,r.visible=this.visible,r.frustumCulled=this.frustumCulled,r.renderOrder=this.renderOrder,r.static=this.static,r.matrixAutoUpdate=this.matrixAutoUpdate,Object.keys(this.userData).length>0&&(r.userData=this.userData),r.layers=this.layers.mask,r.matrix=this.matrix.toArray(),r.up=this.up.toArray(),this.pivot!==null&&(r.pivot=this.pivot.toArray()),this.morphTargetDictionary!==void 0&&(r.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(r.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(r.type="InstancedMesh",r.count=this.count,r.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(r.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(r.type="BatchedMesh",r.perObjectFrustumCulled=this.perObjectFrustumCulled,r.sortObjects=this.sortObjects,r.drawRanges=this._drawRanges,r.reservedRanges=this._reservedRanges,r.geometryInfo=this._geometryInfo.map(a=>({...a,boundingBox:a.boundingBox?a.boundingBox.toJSON():void 0,boundingSphere:a.boundingSphere?a.boundingSphere.toJSON():void 0})),r.instanceInfo=this._instanceInfo.map(a=>({...a})),r.availableInstanceIds=this._availableInstanceIds.slice(),r.availableGeometryIds=this._availableGeometryIds.slice(),r.nextIndexStart=this._nextIndexStart,r.nextVertexStart=this._nextVertexStart,r.geometryCount=this._geometryCount,r.maxInstanceCount=this._maxInstanceCount,r.maxVertexCount=this._maxVertexCount,r.maxIndexCount=this._maxIndexCount,r.geometryInitialized=this._geometryInitialized,r.matricesTexture=this._matricesTexture.toJSON(e),r.indirectTexture=this._indirectTexture.toJSON(e),this._colorsTexture!==null&&(r.colorsTexture=this._colorsTexture.toJSON(e)),this.boundingSphere!==null&&(r.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(r.boundingBox=this.boundingBox.toJSON()));function s(a,l){return a[l.uuid]===void 0&&(a[l.uuid]=l.toJSON(e)),l.uuid}if(this.isScene)this.background&&(this.background.isColor?r.background=this.background.toJSON():this.background.isTexture&&(r.background=this.background.toJSON(e).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(r.environment=this.environment.toJSON(e).uuid);else if(this.isMesh||this.isLine||this.isPoints){r.geometry=s(e.geometries,this.geometry);let a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){let l=a.shapes;if(Array.isArray(l))for(let c=0,u=l.length;c<u;c++){let h=l[c];s(e.shapes,h)}else s(e.shapes,l)}}if(this.isSkinnedMesh&&(r.bindMode=this.bindMode,r.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(s(e.skeletons,this.skeleton),r.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let a=[];for(let l=0,c=this.material.length;l<c;l++)a.push(s(e.materials,this.material[l]));r.material=a}else r.material=s(e.materials,this.material);if(this.children.length>0){r.children=[];for(let a=0;a<this.children.length;a++)r.children.push(this.children[a].toJSON(e).object)}if(this.animations.length>0){r.animations=[];for(let a=0;a<this.animations.length;a++){let l=this.animations[a];r.animations.push(s(e.animations,l))}}if(t){let a=o(e.geometries),l=o(e.materials),c=o(e.textures),u=o(e.images),h=o(e.shapes),f=o(e.skeletons),d=o(e.animations),m=o(e.nodes);a.length>0&&(n.geometries=a),l.length>0&&(n.materials=l),c.length>0&&(n.textures=c),u.length>0&&(n.images=u),h.length>0&&(n.shapes=h),f.length>0&&(n.skeletons=f),d.length>0&&(n.animations=d),m.length>0&&(n.nodes=m)}return n.object=r,n;function o(a){let l=[];for(let c in a){let u=a[c];delete u.metadata,l.push(u)}return l}}clone(e){return new this.constructor().copy(this,e)}copy(e,t=!0){if(this.name=e.name,this.up.copy(e.up),this.position.copy(e.position),this.rotation.order=e.rotation.order,this.quaternion.copy(e.quaternion),this.scale.copy(e.scale),this.pivot=e.pivot!==null?e.pivot.clone():null,this.matrix.copy(e.matrix),this.matrixWorld.copy(e.matrixWorld),this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrixWorldAutoUpdate=e.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=e.matrixWorldNeedsUpdate,this.layers.mask=e.layers.mask,this.visible=e.visible,this.castShadow=e.castShadow,this.receiveShadow=e.receiveShadow,this.frustumCulled=e.frustumCulled,this.renderOrder=e.renderOrder,this.static=e.static,this.animations=e.animations.slice(),this.userData=JSON.parse(JSON.stringify(e.userData)),t===!0)for(let n=0;n<e.children.length;n++){let r=e.children[n];this.add(r.clone())}return this}dispose(){this.dispatchEvent({type:"dispose"})}};wn.DEFAULT_UP=new J(0,1,0);wn.DEFAULT_MATRIX_AUTO_UPDATE=!0;wn.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var Pi=class extends wn{constructor(){super(),this.isGroup=!0,this.type="Group"}},Q1={type:"move"},ta=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new Pi,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new Pi,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new J,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new J),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new Pi,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new J,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new J,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(e){return this._targetRay!==null&&this._targetRay.dispatchEvent(e),this._grip!==null&&this._grip.dispatchEvent(e),this._hand!==null&&this._hand.dispatchEvent(e),this}connect(e){if(e&&e.hand){let t=this._hand;if(t)for(let n of e.hand.values())this._getHandJoint(t,n)}return this.dispatchEvent({type:"connected",data:e}),this}disconnect(e){return this.dispatchEvent({type:"disconnected",data:e}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(e,t,n){let r=null,s=null,o=null,a=this._targetRay,l=this._grip,c=this._hand;if(e&&t.session.visibilityState!=="visible-blurred"){if(c&&e.hand){o=!0;for(let b of e.hand.values()){let g=t.getJointPose(b,n),_=this._getHandJoint(c,b);g!==null&&(_.matrix.fromArray(g.transform.matrix),_.matrix.decompose(_.position,_.quaternion,_.scale),_.matrixWorldNeedsUpdate=!0,_.jointRadius=g.radius),_.visible=g!==null}let u=c.joints["index-finger-tip"],h=c.joints["thumb-tip"],f=u.position.distanceTo(h.position),d=.02,m=.005;c.inputState.pinching&&f>d+m?(c.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:e.handedness,target:this})):!c.inputState.pinching&&f<=d-m&&(c.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:e.handedness,target:this}))}else l!==null&&e.gripSpace&&(s=t.getPose(e.gripSpace,n),s!==null&&(l.matrix.fromArray(s.transform.matrix),l.matrix.decompose(l.position,l.quaternion,l.scale),l.matrixWorldNeedsUpdate=!0,s.linearVelocity?(l.hasLinearVelocity=!0,l.linearVelocity.copy(s.linearVelocity)):l.hasLinearVelocity=!1,s.angularVelocity?(l.hasAngularVelocity=!0,l.angularVelocity.copy(s.angularVelocity)):l.hasAngularVelocity=!1,l.eventsEnabled&&l.dispatchEvent({type:"gripUpdated",data:e,target:this})));a!==null&&(r=t.getPose(e.targetRaySpace,n),r===null&&s!==null&&(r=s),r!==null&&(a.matrix.fromArray(r.transform.matrix),a.matrix.decompose(a.position,a.quaternion,a.scale),a.matrixWorldNeedsUpdate=!0,r.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(r.linearVelocity)):a.hasLinearVelocity=!1,r.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(r.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent(Q1)))}return a!==null&&(a.visible=r!==null),l!==null&&(l.visible=s!==null),c!==null&&(c.visible=o!==null),this}_getHandJoint(e,t){if(e.joints[t.jointName]===void 0){let n=new Pi;n.matrixAutoUpdate=!1,n.visible=!1,e.joints[t.jointName]=n,e.add(n)}return e.joints[t.jointName]}},ag={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},Es={h:0,s:0,l:0},uc={h:0,s:0,l:0};function af(i,e,t){return t<0&&(t+=1),t>1&&(t-=1),t<1/6?i+(e-i)*6*t:t<1/2?e:t<2/3?i+(e-i)*6*(2/3-t):i}var ht=class{constructor(e,t,n){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(e,t,n)}set(e,t,n){if(t===void 0&&n===void 0){let r=e;r&&r.isColor?this.copy(r):typeof r=="number"?this.setHex(r):typeof r=="string"&&this.setStyle(r)}else this.setRGB(e,t,n);return this}setScalar(e){return this.r=e,this.g=e,this.b=e,this}setHex(e,t=Ln){return e=Math.floor(e),this.r=(e>>16&255)/255,this.g=(e>>8&255)/255,this.b=(e&255)/255,Rt.colorSpaceToWorking(this,t),this}setRGB(e,t,n,r=Rt.workingColorSpace){return this.r=e,this.g=t,this.b=n,Rt.colorSpaceToWorking(this,r),this}setHSL(e,t,n,r=Rt.workingColorSpace){if(e=cd(e,1),t=It(t,0,1),n=It(n,0,1),t===0)this.r=this.g=this.b=n;else{let s=n<=.5?n*(1+t):n+t-n*t,o=2*n-s;this.r=af(o,s,e+1/3),this.g=af(o,s,e),this.b=af(o,s,e-1/3)}return Rt.colorSpaceToWorking(this,r),this}setStyle(e,t=Ln){function n(s){s!==void 0&&parseFloat(s)<1&&nt("Color: Alpha component of "+e+" will be ignored.")}let r;if(r=/^(\w+)\(([^\)]*)\)/.exec(e)){let s,o=r[1],a=r[2];switch(o){case"rgb":case"rgba":if(s=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return n(s[4]),this.setRGB(Math.min(255,parseInt(s[1],10))/255,Math.min(255,parseInt(s[2],10))/255,Math.min(255,parseInt(s[3],10))/255,t);if(s=/^\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return n(s[4]),this.setRGB(Math.min(100,parseFloat(s[1]))/100,Math.min(100,parseFloat(s[2]))/100,Math.min(100,parseFloat(s[3]))/100,t);break;case"hsl":case"hsla":if(s=/^\s*([+-]?(?:\d+(?:\.\d+)?|\.\d+))\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return n(s[4]),this.setHSL(parseFloat(s[1])/360,parseFloat(s[2])/100,parseFloat(s[3])/100,t);break;default:nt("Color: Unknown color model "+e)}}else if(r=/^\#([A-Fa-f\d]+)$/.exec(e)){let s=r[1],o=s.length;if(o===3)return this.setRGB(parseInt(s.charAt(0),16)/15,parseInt(s.charAt(1),16)/15,parseInt(s.charAt(2),16)/15,t);if(o===6)return this.setHex(parseInt(s,16),t);nt("Color: Invalid hex color "+e)}else if(e&&e.length>0)return this.setColorName(e,t);return this}setColorName(e,t=Ln){let n=ag[e.toLowerCase()];return n!==void 0?this.setHex(n,t):nt("Color: Unknown color "+e),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(e){return this.r=e.r,this.g=e.g,this.b=e.b,this}copySRGBToLinear(e){return this.r=Jr(e.r),this.g=Jr(e.g),this.b=Jr(e.b),this}copyLinearToSRGB(e){return this.r=$o(e.r),this.g=$o(e.g),this.b=$o(e.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(e=Ln){return Rt.workingToColorSpace(ri.copy(this),e),Math.round(It(ri.r*255,0,255))*65536+Math.round(It(ri.g*255,0,255))*256+Math.round(It(ri.b*255,0,255))}getHexString(e=Ln){return("000000"+this.getHex(e).toString(16)).slice(-6)}getHSL(e,t=Rt.workingColorSpace){Rt.workingToColorSpace(ri.copy(this),t);let n=ri.r,r=ri.g,s=ri.b,o=Math.max(n,r,s),a=Math.min(n,r,s),l,c,u=(a+o)/2;if(a===o)l=0,c=0;else{let h=o-a;switch(c=u<=.5?h/(o+a):h/(2-o-a),o){case n:l=(r-s)/h+(r<s?6:0);break;case r:l=(s-n)/h+2;break;case s:l=(n-r)/h+4;break}l/=6}return e.h=l,e.s=c,e.l=u,e}getRGB(e,t=Rt.workingColorSpace){return Rt.workingToColorSpace(ri.copy(this),t),e.r=ri.r,e.g=ri.g,e.b=ri.b,e}getStyle(e=Ln){Rt.workingToColorSpace(ri.copy(this),e);let t=ri.r,n=ri.g,r=ri.b;return e!==Ln?`color(${e} ${t.toFixed(3)} ${n.toFixed(3)} ${r.toFixed(3)})`:`rgb(${Math.round(t*255)},${Math.round(n*255)},${Math.round(r*255)})`}offsetHSL(e,t,n){return this.getHSL(Es),this.setHSL(Es.h+e,Es.s+t,Es.l+n)}add(e){return this.r+=e.r,this.g+=e.g,this.b+=e.b,this}addColors(e,t){return this.r=e.r+t.r,this.g=e.g+t.g,this.b=e.b+t.b,this}addScalar(e){return this.r+=e,this.g+=e,this.b+=e,this}sub(e){return this.r=Math.max(0,this.r-e.r),this.g=Math.max(0,this.g-e.g),this.b=Math.max(0,this.b-e.b),this}multiply(e){return this.r*=e.r,this.g*=e.g,this.b*=e.b,this}multiplyScalar(e){return this.r*=e,this.g*=e,this.b*=e,this}lerp(e,t){return this.r+=(e.r-this.r)*t,this.g+=(e.g-this.g)*t,this.b+=(e.b-this.b)*t,this}lerpColors(e,t,n){return this.r=e.r+(t.r-e.r)*n,this.g=e.g+(t.g-e.g)*n,this.b=e.b+(t.b-e.b)*n,this}lerpHSL(e,t){this.getHSL(Es),e.getHSL(uc);let n=nl(Es.h,uc.h,t),r=nl(Es.s,uc.s,t),s=nl(Es.l,uc.l,t);return this.setHSL(n,r,s),this}setFromVector3(e){return this.r=e.x,this.g=e.y,this.b=e.z,this}applyMatrix3(e){let t=this.r,n=this.g,r=this.b,s=e.elements;return this.r=s[0]*t+s[3]*n+s[6]*r,this.g=s[1]*t+s[4]*n+s[7]*r,this.b=s[2]*t+s[5]*n+s[8]*r,this}equals(e){return e.r===this.r&&e.g===this.g&&e.b===this.b}fromArray(e,t=0){return this.r=e[t],this.g=e[t+1],this.b=e[t+2],this}toArray(e=[],t=0){return e[t]=this.r,e[t+1]=this.g,e[t+2]=this.b,e}fromBufferAttribute(e,t){return this.r=e.getX(t),this.g=e.getY(t),this.b=e.getZ(t),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},ri=new ht;ht.NAMES=ag;var ol=class extends wn{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new Ar,this.environmentIntensity=1,this.environmentRotation=new Ar,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(e,t){return super.copy(e,t),this.background=e.background!==null?e.background.clone():null,this.environment=e.environment!==null?e.environment.clone():null,this.fog=e.fog!==null?e.fog.clone():null,this.backgroundBlurriness=e.backgroundBlurriness,this.backgroundIntensity=e.backgroundIntensity,this.backgroundRotation.copy(e.backgroundRotation),this.environmentIntensity=e.environmentIntensity,this.environmentRotation.copy(e.environmentRotation),this.overrideMaterial=e.overrideMaterial!==null?e.overrideMaterial.clone():null,this.matrixAutoUpdate=e.matrixAutoUpdate,this}toJSON(e){let t=super.toJSON(e);return this.fog!==null&&(t.object.fog=this.fog.toJSON()),t.object.backgroundBlurriness=this.backgroundBlurriness,t.object.backgroundIntensity=this.backgroundIntensity,t.object.backgroundRotation=this.backgroundRotation.toArray(),t.object.environmentIntensity=this.environmentIntensity,t.object.environmentRotation=this.environmentRotation.toArray(),t}},sr=new J,Xr=new J,lf=new J,qr=new J,Bo=new J,zo=new J,Km=new J,cf=new J,uf=new J,hf=new J,ff=new Ot,df=new Ot,pf=new Ot,Ls=class i{constructor(e=new J,t=new J,n=new J){this.a=e,this.b=t,this.c=n}static getNormal(e,t,n,r){r.subVectors(n,t),sr.subVectors(e,t),r.cross(sr);let s=r.lengthSq();return s>0?r.multiplyScalar(1/Math.sqrt(s)):r.set(0,0,0)}static getBarycoord(e,t,n,r,s){sr.subVectors(r,t),Xr.subVectors(n,t),lf.subVectors(e,t);let o=sr.dot(sr),a=sr.dot(Xr),l=sr.dot(lf),c=Xr.dot(Xr),u=Xr.dot(lf),h=o*c-a*a;if(h===0)return s.set(0,0,0),null;let f=1/h,d=(c*l-a*u)*f,m=(o*u-a*l)*f;return s.set(1-d-m,m,d)}static containsPoint(e,t,n,r){return this.getBarycoord(e,t,n,r,qr)===null?!1:qr.x>=0&&qr.y>=0&&qr.x+qr.y<=1}static getInterpolation(e,t,n,r,s,o,a,l){return this.getBarycoord(e,t,n,r,qr)===null?(l.x=0,l.y=0,"z"in l&&(l.z=0),"w"in l&&(l.w=0),null):(l.setScalar(0),l.addScaledVector(s,qr.x),l.addScaledVector(o,qr.y),l.addScaledVector(a,qr.z),l)}static getInterpolatedAttribute(e,t,n,r,s,o){return ff.setScalar(0),df.setScalar(0),pf.setScalar(0),ff.fromBufferAttribute(e,t),df.fromBufferAttribute(e,n),pf.fromBufferAttribute(e,r),o.setScalar(0),o.addScaledVector(ff,s.x),o.addScaledVector(df,s.y),o.addScaledVector(pf,s.z),o}static isFrontFacing(e,t,n,r){return sr.subVectors(n,t),Xr.subVectors(e,t),sr.cross(Xr).dot(r)<0}set(e,t,n){return this.a.copy(e),this.b.copy(t),this.c.copy(n),this}setFromPointsAndIndices(e,t,n,r){return this.a.copy(e[t]),this.b.copy(e[n]),this.c.copy(e[r]),this}setFromAttributeAndIndices(e,t,n,r){return this.a.fromBufferAttribute(e,t),this.b.fromBufferAttribute(e,n),this.c.fromBufferAttribute(e,r),this}clone(){return new this.constructor().copy(this)}copy(e){return this.a.copy(e.a),this.b.copy(e.b),this.c.copy(e.c),this}getArea(){return sr.subVectors(this.c,this.b),Xr.subVectors(this.a,this.b),sr.cross(Xr).length()*.5}getMidpoint(e){return e.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(e){return i.getNormal(this.a,this.b,this.c,e)}getPlane(e){return e.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(e,t){return i.getBarycoord(e,this.a,this.b,this.c,t)}getInterpolation(e,t,n,r,s){return i.getInterpolation(e,this.a,this.b,this.c,t,n,r,s)}containsPoint(e){return i.containsPoint(e,this.a,this.b,this.c)}isFrontFacing(e){return i.isFrontFacing(this.a,this.b,this.c,e)}intersectsBox(e){return e.intersectsTriangle(this)}closestPointToPoint(e,t){let n=this.a,r=this.b,s=this.c,o,a;Bo.subVectors(r,n),zo.subVectors(s,n),cf.subVectors(e,n);let l=Bo.dot(cf),c=zo.dot(cf);if(l<=0&&c<=0)return t.copy(n);uf.subVectors(e,r);let u=Bo.dot(uf),h=zo.dot(uf);if(u>=0&&h<=u)return t.copy(r);let f=l*h-u*c;if(f<=0&&l>=0&&u<=0&&l-u>0)return o=l/(l-u),t.copy(n).addScaledVector(Bo,o);hf.subVectors(e,s);let d=Bo.dot(hf),m=zo.dot(hf);if(m>=0&&d<=m)return t.copy(s);let b=d*c-l*m;if(b<=0&&c>=0&&m<=0)return a=c/(c-m),t.copy(n).addScaledVector(zo,a);let g=u*m-d*h;if(g<=0&&h-u>=0&&d-m>=0)return Km.subVectors(s,r),a=(h-u)/(h-u+(d-m)),t.copy(r).addScaledVector(Km,a);let _=1/(g+b+f);return o=b*_,a=f*_,t.copy(n).addScaledVector(Bo,o).addScaledVector(zo,a)}equals(e){return e.a.equals(this.a)&&e.b.equals(this.b)&&e.c.equals(this.c)}},Ni=class{constructor(e=new J(1/0,1/0,1/0),t=new J(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=e,this.max=t}set(e,t){return this.min.copy(e),this.max.copy(t),this}setFromArray(e){this.makeEmpty();for(let t=0,n=e.length;t<n;t+=3)this.expandByPoint(or.fromArray(e,t));return this}setFromBufferAttribute(e){this.makeEmpty();for(let t=0,n=e.count;t<n;t++)this.expandByPoint(or.fromBufferAttribute(e,t));return this}setFromPoints(e){this.makeEmpty();for(let t=0,n=e.length;t<n;t++)this.expandByPoint(e[t]);return this}setFromCenterAndSize(e,t){let n=or.copy(t).multiplyScalar(.5);return this.min.copy(e).sub(n),this.max.copy(e).add(n),this}setFromObject(e,t=!1){return this.makeEmpty(),this.expandByObject(e,t)}clone(){return new this.constructor().copy(this)}copy(e){return this.min.copy(e.min),this.max.copy(e.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(e){return this.isEmpty()?e.set(0,0,0):e.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(e){return this.isEmpty()?e.set(0,0,0):e.subVectors(this.max,this.min)}expandByPoint(e){return this.min.min(e),this.max.max(e),this}expandByVector(e){return this.min.sub(e),this.max.add(e),this}expandByScalar(e){return this.min.addScalar(-e),this.max.addScalar(e),this}expandByObject(e,t=!1){e.updateWorldMatrix(!1,!1);let n=e.geometry;if(n!==void 0){let s=n.getAttribute("position");if(t===!0&&s!==void 0&&e.isInstancedMesh!==!0&&e.isBatchedMesh!==!0)for(let o=0,a=s.count;o<a;o++)e.isMesh===!0?e.getVertexPosition(o,or):or.fromBufferAttribute(s,o),or.applyMatrix4(e.matrixWorld),this.expandByPoint(or);else e.boundingBox!==void 0?(e.boundingBox===null&&e.computeBoundingBox(),hc.copy(e.boundingBox)):(n.boundingBox===null&&n.computeBoundingBox(),hc.copy(n.boundingBox)),hc.applyMatrix4(e.matrixWorld),this.union(hc)}let r=e.children;for(let s=0,o=r.length;s<o;s++)this.expandByObject(r[s],t);return this}containsPoint(e){return e.x>=this.min.x&&e.x<=this.max.x&&e.y>=this.min.y&&e.y<=this.max.y&&e.z>=this.min.z&&e.z<=this.max.z}containsBox(e){return this.min.x<=e.min.x&&e.max.x<=this.max.x&&this.min.y<=e.min.y&&e.max.y<=this.max.y&&this.min.z<=e.min.z&&e.max.z<=this.max.z}getParameter(e,t){return t.set((e.x-this.min.x)/(this.max.x-this.min.x),(e.y-this.min.y)/(this.max.y-this.min.y),(e.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(e){return e.max.x>=this.min.x&&e.min.x<=this.max.x&&e.max.y>=this.min.y&&e.min.y<=this.max.y&&e.max.z>=this.min.z&&e.min.z<=this.max.z}intersectsSphere(e){return this.clampPoint(e.center,or),or.distanceToSquared(e.center)<=e.radius*e.radius}intersectsPlane(e){let t,n;return e.normal.x>0?(t=e.normal.x*this.min.x,n=e.normal.x*this.max.x):(t=e.normal.x*this.max.x,n=e.normal.x*this.min.x),e.normal.y>0?(t+=e.normal.y*this.min.y,n+=e.normal.y*this.max.y):(t+=e.normal.y*this.max.y,n+=e.normal.y*this.min.y),e.normal.z>0?(t+=e.normal.z*this.min.z,n+=e.normal.z*this.max.z):(t+=e.normal.z*this.max.z,n+=e.normal.z*this.min.z),t<=-e.constant&&n>=-e.constant}intersectsTriangle(e){if(this.isEmpty())return!1;this.getCenter(Ya),fc.subVectors(this.max,Ya),ko.subVectors(e.a,Ya),Vo.subVectors(e.b,Ya),Ho.subVectors(e.c,Ya),Rs.subVectors(Vo,ko),Cs.subVectors(Ho,Vo),Zs.subVectors(ko,Ho);let t=[0,-Rs.z,Rs.y,0,-Cs.z,Cs.y,0,-Zs.z,Zs.y,Rs.z,0,-Rs.x,Cs.z,0,-Cs.x,Zs.z,0,-Zs.x,-Rs.y,Rs.x,0,-Cs.y,Cs.x,0,-Zs.y,Zs.x,0];return!mf(t,ko,Vo,Ho,fc)||(t=[1,0,0,0,1,0,0,0,1],!mf(t,ko,Vo,Ho,fc))?!1:(dc.crossVectors(Rs,Cs),t=[dc.x,dc.y,dc.z],mf(t,ko,Vo,Ho,fc))}clampPoint(e,t){return t.copy(e).clamp(this.min,this.max)}distanceToPoint(e){return this.clampPoint(e,or).distanceTo(e)}getBoundingSphere(e){return this.isEmpty()?e.makeEmpty():(this.getCenter(e.center),e.radius=this.getSize(or).length()*.5),e}intersect(e){return this.min.max(e.min),this.max.min(e.max),this.isEmpty()&&this.makeEmpty(),this}union(e){return this.min.min(e.min),this.max.max(e.max),this}applyMatrix4(e){return this.isEmpty()?this:(Yr[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(e),Yr[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(e),Yr[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(e),Yr[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(e),Yr[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(e),Yr[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(e),Yr[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(e),Yr[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(e),this.setFromPoints(Yr),this)}translate(e){return this.min.add(e),this.max.add(e),this}equals(e){return e.min.equals(this.min)&&e.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(e){return this.min.fromArray(e.min),this.max.fromArray(e.max),this}},Yr=[new J,new J,new J,new J,new J,new J,new J,new J],or=new J,hc=new Ni,ko=new J,Vo=new J,Ho=new J,Rs=new J,Cs=new J,Zs=new J,Ya=new J,fc=new J,dc=new J,Ks=new J;function mf(i,e,t,n,r){for(let s=0,o=i.length-3;s<=o;s+=3){Ks.fromArray(i,s);let a=r.x*Math.abs(Ks.x)+r.y*Math.abs(Ks.y)+r.z*Math.abs(Ks.z),l=e.dot(Ks),c=t.dot(Ks),u=n.dot(Ks);if(Math.max(-Math.max(l,c,u),Math.min(l,c,u))>a)return!1}return!0}var Kr=ey();function ey(){let i=new ArrayBuffer(4),e=new Float32Array(i),t=new Uint32Array(i),n=new Uint32Array(512),r=new Uint32Array(512);for(let l=0;l<256;++l){let c=l-127;c<-27?(n[l]=0,n[l|256]=32768,r[l]=24,r[l|256]=24):c<-14?(n[l]=1024>>-c-14,n[l|256]=1024>>-c-14|32768,r[l]=-c-1,r[l|256]=-c-1):c<=15?(n[l]=c+15<<10,n[l|256]=c+15<<10|32768,r[l]=13,r[l|256]=13):c<128?(n[l]=31744,n[l|256]=64512,r[l]=24,r[l|256]=24):(n[l]=31744,n[l|256]=64512,r[l]=13,r[l|256]=13)}let s=new Uint32Array(2048),o=new Uint32Array(64),a=new Uint32Array(64);for(let l=1;l<1024;++l){let c=l<<13,u=0;for(;(c&8388608)===0;)c<<=1,u-=8388608;c&=-8388609,u+=947912704,s[l]=c|u}for(let l=1024;l<2048;++l)s[l]=939524096+(l-1024<<13);for(let l=1;l<31;++l)o[l]=l<<23;o[31]=1199570944,o[32]=2147483648;for(let l=33;l<63;++l)o[l]=2147483648+(l-32<<23);o[63]=3347054592;for(let l=1;l<64;++l)l!==32&&(a[l]=1024);return{floatView:e,uint32View:t,baseTable:n,shiftTable:r,mantissaTable:s,exponentTable:o,offsetTable:a}}function ty(i){Math.abs(i)>65504&&nt("DataUtils.toHalfFloat(): Value out of range."),i=It(i,-65504,65504),Kr.floatView[0]=i;let e=Kr.uint32View[0],t=e>>23&511;return Kr.baseTable[t]+((e&8388607)>>Kr.shiftTable[t])}function ny(i){let e=i>>10;return Kr.uint32View[0]=Kr.mantissaTable[Kr.offsetTable[e]+(i&1023)]+Kr.exponentTable[e],Kr.floatView[0]}var Ue=class{static toHalfFloat(e){return ty(e)}static fromHalfFloat(e){return ny(e)}},Un=new J,pc=new xt,iy=0,an=class extends Tr{constructor(e,t,n=!1){if(super(),Array.isArray(e))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:iy++}),this.name="",this.array=e,this.itemSize=t,this.count=e!==void 0?e.length/t:0,this.normalized=n,this.usage=ld,this.updateRanges=[],this.gpuType=Nt,this.version=0,this._normalizationScale=e!==void 0?Wu(e):void 0}onUploadCallback(){}set needsUpdate(e){e===!0&&this.version++}setUsage(e){return this.usage=e,this}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}copy(e){return this.name=e.name,this.array=new e.array.constructor(e.array),this.itemSize=e.itemSize,this.count=e.count,this.normalized=e.normalized,this.usage=e.usage,this.gpuType=e.gpuType,this._normalizationScale=e._normalizationScale,this}copyAt(e,t,n){e*=this.itemSize,n*=t.itemSize;for(let r=0,s=this.itemSize;r<s;r++)this.array[e+r]=t.array[n+r];return this}copyArray(e){return this.array.set(e),this}applyMatrix3(e){if(this.itemSize===2)for(let t=0,n=this.count;t<n;t++)pc.fromBufferAttribute(this,t),pc.applyMatrix3(e),this.setXY(t,pc.x,pc.y);else if(this.itemSize===3)for(let t=0,n=this.count;t<n;t++)Un.fromBufferAttribute(this,t),Un.applyMatrix3(e),this.setXYZ(t,Un.x,Un.y,Un.z);return this}applyMatrix4(e){for(let t=0,n=this.count;t<n;t++)Un.fromBufferAttribute(this,t),Un.applyMatrix4(e),this.setXYZ(t,Un.x,Un.y,Un.z);return this}applyNormalMatrix(e){for(let t=0,n=this.count;t<n;t++)Un.fromBufferAttribute(this,t),Un.applyNormalMatrix(e),this.setXYZ(t,Un.x,Un.y,Un.z);return this}transformDirection(e){for(let t=0,n=this.count;t<n;t++)Un.fromBufferAttribute(this,t),Un.transformDirection(e),this.setXYZ(t,Un.x,Un.y,Un.z);return this}set(e,t=0){return this.array.set(e,t),this}getComponent(e,t){let n=this.array[e*this.itemSize+t];return this.normalized&&(n=this._denormalize(n)),n}setComponent(e,t,n){return this.normalized&&(n=this._normalize(n)),this.array[e*this.itemSize+t]=n,this}getX(e){let t=this.array[e*this.itemSize];return this.normalized&&(t=this._denormalize(t)),t}setX(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize]=t,this}getY(e){let t=this.array[e*this.itemSize+1];return this.normalized&&(t=this._denormalize(t)),t}setY(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+1]=t,this}getZ(e){let t=this.array[e*this.itemSize+2];return this.normalized&&(t=this._denormalize(t)),t}setZ(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+2]=t,this}getW(e){let t=this.array[e*this.itemSize+3];return this.normalized&&(t=this._denormalize(t)),t}setW(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+3]=t,this}setXY(e,t,n){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),n=this._normalize(n)),this.array[e+0]=t,this.array[e+1]=n,this}setXYZ(e,t,n,r){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),n=this._normalize(n),r=this._normalize(r)),this.array[e+0]=t,this.array[e+1]=n,this.array[e+2]=r,this}setXYZW(e,t,n,r,s){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),n=this._normalize(n),r=this._normalize(r),s=this._normalize(s)),this.array[e+0]=t,this.array[e+1]=n,this.array[e+2]=r,this.array[e+3]=s,this}onUpload(e){return this.onUploadCallback=e,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let e={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return e.name=this.name,e.usage=this.usage,e.gpuType=this.gpuType,e}dispose(){this.dispatchEvent({type:"dispose"})}_denormalize(e){let t=this._normalizationScale;return t!==void 0?Math.max(e/t,-1):hd(e,this.array)}_normalize(e){let t=this._normalizationScale;return t!==void 0?Math.round(e*t):fd(e,this.array)}};var al=class extends an{constructor(e,t,n){super(new Uint16Array(e),t,n)}};var ll=class extends an{constructor(e,t,n){super(new Uint32Array(e),t,n)}};var Cn=class extends an{constructor(e,t,n){super(new Float32Array(e),t,n)}},ry=new Ni,$a=new J,gf=new J,vi=class{constructor(e=new J,t=-1){this.isSphere=!0,this.center=e,this.radius=t}set(e,t){return this.center.copy(e),this.radius=t,this}setFromPoints(e,t){let n=this.center;t!==void 0?n.copy(t):ry.setFromPoints(e).getCenter(n);let r=0;for(let s=0,o=e.length;s<o;s++)r=Math.max(r,n.distanceToSquared(e[s]));return this.radius=Math.sqrt(r),this}copy(e){return this.center.copy(e.center),this.radius=e.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(e){return e.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(e){return e.distanceTo(this.center)-this.radius}intersectsSphere(e){let t=this.radius+e.radius;return e.center.distanceToSquared(this.center)<=t*t}intersectsBox(e){return e.intersectsSphere(this)}intersectsPlane(e){return Math.abs(e.distanceToPoint(this.center))<=this.radius}clampPoint(e,t){let n=this.center.distanceToSquared(e);return t.copy(e),n>this.radius*this.radius&&(t.sub(this.center).normalize(),t.multiplyScalar(this.radius).add(this.center)),t}getBoundingBox(e){return this.isEmpty()?(e.makeEmpty(),e):(e.set(this.center,this.center),e.expandByScalar(this.radius),e)}applyMatrix4(e){return this.center.applyMatrix4(e),this.radius=this.radius*e.getMaxScaleOnAxis(),this}translate(e){return this.center.add(e),this}expandByPoint(e){if(this.isEmpty())return this.center.copy(e),this.radius=0,this;$a.subVectors(e,this.center);let t=$a.lengthSq();if(t>this.radius*this.radius){let n=Math.sqrt(t),r=(n-this.radius)*.5;this.center.addScaledVector($a,r/n),this.radius+=r}return this}union(e){return e.isEmpty()?this:this.isEmpty()?(this.copy(e),this):(this.center.equals(e.center)===!0?this.radius=Math.max(this.radius,e.radius):(gf.subVectors(e.center,this.center).setLength(e.radius),this.expandByPoint($a.copy(e.center).add(gf)),this.expandByPoint($a.copy(e.center).sub(gf))),this)}equals(e){return e.center.equals(this.center)&&e.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(e){return this.radius=e.radius,this.center.fromArray(e.center),this}},sy=0,Gi=new it,_f=new wn,Go=new J,Ii=new Ni,Za=new Ni,Yn=new J,_n=class i extends Tr{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:sy++}),this.uuid=Nr(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(e){return Array.isArray(e)?this.index=new(E1(e)?ll:al)(e,1):this.index=e,this}setIndirect(e,t=0){return this.indirect=e,this.indirectOffset=t,this}getIndirect(){return this.indirect}getAttribute(e){return this.attributes[e]}setAttribute(e,t){return this.attributes[e]=t,this}deleteAttribute(e){return delete this.attributes[e],this}hasAttribute(e){return this.attributes[e]!==void 0}addGroup(e,t,n=0){this.groups.push({start:e,count:t,materialIndex:n})}clearGroups(){this.groups=[]}setDrawRange(e,t){this.drawRange.start=e,this.drawRange.count=t}applyMatrix4(e){let t=this.attributes.position;t!==void 0&&(t.applyMatrix4(e),t.needsUpdate=!0);let n=this.attributes.normal;if(n!==void 0){let s=new dt().getNormalMatrix(e);n.applyNormalMatrix(s),n.needsUpdate=!0}let r=this.attributes.tangent;return r!==void 0&&(r.transformDirection(e),r.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(e){return Gi.makeRotationFromQuaternion(e),this.applyMatrix4(Gi),this}rotateX(e){return Gi.makeRotationX(e),this.applyMatrix4(Gi),this}rotateY(e){return Gi.makeRotationY(e),this.applyMatrix4(Gi),this}rotateZ(e){return Gi.makeRotationZ(e),this.applyMatrix4(Gi),this}translate(e,t,n){return Gi.makeTranslation(e,t,n),this.applyMatrix4(Gi),this}scale(e,t,n){return Gi.makeScale(e,t,n),this.applyMatrix4(Gi),this}lookAt(e){return _f.lookAt(e),_f.updateMatrix(),this.applyMatrix4(_f.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(Go).negate(),this.translate(Go.x,Go.y,Go.z),this}setFromPoints(e){let t=this.getAttribute("position");if(t===void 0){let n=[];for(let r=0,s=e.length;r<s;r++){let o=e[r];n.push(o.x,o.y,o.z||0)}this.setAttribute("position",new Cn(n,3))}else{let n=Math.min(e.length,t.count);for(let r=0;r<n;r++){let s=e[r];t.setXYZ(r,s.x,s.y,s.z||0)}e.length>t.count&&nt("BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),t.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new Ni);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){_t("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new J(-1/0,-1/0,-1/0),new J(1/0,1/0,1/0));return}if(e!==void 0){if(this.boundingBox.setFromBufferAttribute(e),t)for(let n=0,r=t.length;n<r;n++){let s=t[n];Ii.setFromBufferAttribute(s),this.morphTargetsRelative?(Yn.addVectors(this.boundingBox.min,Ii.min),this.boundingBox.expandByPoint(Yn),Yn.addVectors(this.boundingBox.max,Ii.max),this.boundingBox.expandByPoint(Yn)):(this.boundingBox.expandByPoint(Ii.min),this.boundingBox.expandByPoint(Ii.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&_t('BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new vi);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){_t("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new J,1/0);return}if(e){let n=this.boundingSphere.center;if(Ii.setFromBufferAttribute(e),t)for(let s=0,o=t.length;s<o;s++){let a=t[s];Za.setFromBufferAttribute(a),this.morphTargetsRelative?(Yn.addVectors(Ii.min,Za.min),Ii.expandByPoint(Yn),Yn.addVectors(Ii.max,Za.max),Ii.expandByPoint(Yn)):(Ii.expandByPoint(Za.min),Ii.expandByPoint(Za.max))}Ii.getCenter(n);let r=0;for(let s=0,o=e.count;s<o;s++)Yn.fromBufferAttribute(e,s),r=Math.max(r,n.distanceToSquared(Yn));if(t)for(let s=0,o=t.length;s<o;s++){let a=t[s],l=this.morphTargetsRelative;for(let c=0,u=a.count;c<u;c++)Yn.fromBufferAttribute(a,c),l&&(Go.fromBufferAttribute(e,c),Yn.add(Go)),r=Math.max(r,n.distanceToSquared(Yn))}this.boundingSphere.radius=Math.sqrt(r),isNaN(this.boundingSphere.radius)&&_t('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let e=this.index,t=this.attributes;if(e===null||t.position===void 0||t.normal===void 0||t.uv===void 0){_t("BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let n=t.position,r=t.normal,s=t.uv,o=this.getAttribute("tangent");(o===void 0||o.count!==n.count)&&(o=new an(new Float32Array(4*n.count),4),this.setAttribute("tangent",o));let a=[],l=[],c=new Uint8Array(n.count);for(let V=0;V<n.count;V++)a[V]=new J,l[V]=new J;let u=new J,h=new J,f=new J,d=new xt,m=new xt,b=new xt,g=new J,_=new J;function S(V,z,D){c[V]=c[z]=c[D]=1,u.fromBufferAttribute(n,V),h.fromBufferAttribute(n,z),f.fromBufferAttribute(n,D),d.fromBufferAttribute(s,V),m.fromBufferAttribute(s,z),b.fromBufferAttribute(s,D),h.sub(u),f.sub(u),m.sub(d),b.sub(d);let q=1/(m.x*b.y-b.x*m.y);isFinite(q)&&(g.copy(h).multiplyScalar(b.y).addScaledVector(f,-m.y).multiplyScalar(q),_.copy(f).multiplyScalar(m.x).addScaledVector(h,-b.x).multiplyScalar(q),a[V].add(g),a[z].add(g),a[D].add(g),l[V].add(_),l[z].add(_),l[D].add(_))}let T=this.groups;T.length===0&&(T=[{start:0,count:e.count}]);for(let V=0,z=T.length;V<z;++V){let D=T[V],q=D.start,Y=D.count;for(let U=q,W=q+Y;U<W;U+=3)S(e.getX(U+0),e.getX(U+1),e.getX(U+2))}let M=new J,P=new J,R=new J,y=new J;function A(V){R.fromBufferAttribute(r,V),y.copy(R);let z=a[V];M.copy(z),M.sub(R.multiplyScalar(R.dot(z))).normalize(),P.crossVectors(y,z);let q=P.dot(l[V])<0?-1:1;o.setXYZW(V,M.x,M.y,M.z,q)}for(let V=0,z=n.count;V<z;++V)c[V]&&A(V);this._transformed=!0}computeVertexNormals(){let e=this.index,t=this.getAttribute("position");if(t!==void 0){let n=this.getAttribute("normal");if(n===void 0||n.count!==t.count)n=new an(new Float32Array(t.count*3),3),this.setAttribute("normal",n);else for(let f=0,d=n.count;f<d;f++)n.setXYZ(f,0,0,0);let r=new J,s=new J,o=new J,a=new J,l=new J,c=new J,u=new J,h=new J;if(e)for(let f=0,d=e.count;f<d;f+=3){let m=e.getX(f+0),b=e.getX(f+1),g=e.getX(f+2);r.fromBufferAttribute(t,m),s.fromBufferAttribute(t,b),o.fromBufferAttribute(t,g),u.subVectors(o,s),h.subVectors(r,s),u.cross(h),a.fromBufferAttribute(n,m),l.fromBufferAttribute(n,b),c.fromBufferAttribute(n,g),a.add(u),l.add(u),c.add(u),n.setXYZ(m,a.x,a.y,a.z),n.setXYZ(b,l.x,l.y,l.z),n.setXYZ(g,c.x,c.y,c.z)}else for(let f=0,d=t.count;f<d;f+=3)r.fromBufferAttribute(t,f+0),s.fromBufferAttribute(t,f+1),o.fromBufferAttribute(t,f+2),u.subVectors(o,s),h.subVectors(r,s),u.cross(h),n.setXYZ(f+0,u.x,u.y,u.z),n.setXYZ(f+1,u.x,u.y,u.z),n.setXYZ(f+2,u.x,u.y,u.z);this.normalizeNormals(),n.needsUpdate=!0}}normalizeNormals(){let e=this.attributes.normal;for(let t=0,n=e.count;t<n;t++)Yn.fromBufferAttribute(e,t),Yn.normalize(),e.setXYZ(t,Yn.x,Yn.y,Yn.z)}toNonIndexed(){function e(a,l){let c=a.array,u=a.itemSize,h=a.normalized,f=new c.constructor(l.length*u),d=0,m=0;for(let b=0,g=l.length;b<g;b++){a.isInterleavedBufferAttribute?d=l[b]*a.data.stride+a.offset:d=l[b]*u;for(let _=0;_<u;_++)f[m++]=c[d++]}return new an(f,u,h)}if(this.index===null)return nt("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let t=new i,n=this.index.array,r=this.attributes;for(let a in r){let l=r[a],c=e(l,n);t.setAttribute(a,c)}let s=this.morphAttributes;for(let a in s){let l=[],c=s[a];for(let u=0,h=c.length;u<h;u++){let f=c[u],d=e(f,n);l.push(d)}t.morphAttributes[a]=l}t.morphTargetsRelative=this.morphTargetsRelative;let o=this.groups;for(let a=0,l=o.length;a<l;a++){let c=o[a];t.addGroup(c.start,c.count,c.materialIndex)}return t}toJSON(){let e={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(e.uuid=this.uuid,e.type=this.parameters!==void 0&&this._transformed===!0?"BufferGeometry":this.type,e.name=this.name,Object.keys(this.userData).length>0&&(e.userData=this.userData),this.parameters!==void 0&&this._transformed!==!0){let l=this.parameters;for(let c in l)l[c]!==void 0&&(e[c]=l[c]);return e}e.data={attributes:{}};let t=this.index;t!==null&&(e.data.index={type:t.array.constructor.name,array:Array.prototype.slice.call(t.array)});let n=this.attributes;for(let l in n){let c=n[l];e.data.attributes[l]=c.toJSON(e.data)}let r={},s=!1;for(let l in this.morphAttributes){let c=this.morphAttributes[l],u=[];for(let h=0,f=c.length;h<f;h++){let d=c[h];u.push(d.toJSON(e.data))}u.length>0&&(r[l]=u,s=!0)}s&&(e.data.morphAttributes=r,e.data.morphTargetsRelative=this.morphTargetsRelative);let o=this.groups;o.length>0&&(e.data.groups=JSON.parse(JSON.stringify(o)));let a=this.boundingSphere;return a!==null&&(e.data.boundingSphere=a.toJSON()),e}clone(){return new this.constructor().copy(this)}copy(e){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let t={};this.name=e.name;let n=e.index;n!==null&&this.setIndex(n.clone());let r=e.attributes;for(let c in r){let u=r[c];this.setAttribute(c,u.clone(t))}let s=e.morphAttributes;for(let c in s){let u=[],h=s[c];for(let f=0,d=h.length;f<d;f++)u.push(h[f].clone(t));this.morphAttributes[c]=u}this.morphTargetsRelative=e.morphTargetsRelative;let o=e.groups;for(let c=0,u=o.length;c<u;c++){let h=o[c];this.addGroup(h.start,h.count,h.materialIndex)}let a=e.boundingBox;a!==null&&(this.boundingBox=a.clone());let l=e.boundingSphere;return l!==null&&(this.boundingSphere=l.clone()),this.drawRange.start=e.drawRange.start,this.drawRange.count=e.drawRange.count,this.userData=e.userData,this._transformed=e._transformed,this}dispose(){this.dispatchEvent({type:"dispose"})}},na=class{constructor(e,t){this.isInterleavedBuffer=!0,this.array=e,this.stride=t,this.count=e!==void 0?e.length/t:0,this.usage=ld,this.updateRanges=[],this.version=0,this.uuid=Nr()}onUploadCallback(){}set needsUpdate(e){e===!0&&this.version++}setUsage(e){return this.usage=e,this}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}copy(e){return this.array=new e.array.constructor(e.array),this.count=e.count,this.stride=e.stride,this.usage=e.usage,this}copyAt(e,t,n){e*=this.stride,n*=t.stride;for(let r=0,s=this.stride;r<s;r++)this.array[e+r]=t.array[n+r];return this}set(e,t=0){return this.array.set(e,t),this}clone(e){e.arrayBuffers===void 0&&(e.arrayBuffers={});let t=Jm(this.array);e.arrayBuffers[t]===void 0&&(e.arrayBuffers[t]=this.array.slice(0).buffer);let n=new this.array.constructor(e.arrayBuffers[t]),r=new this.constructor(n,this.stride);return r.setUsage(this.usage),r}onUpload(e){return this.onUploadCallback=e,this}toJSON(e){e.arrayBuffers===void 0&&(e.arrayBuffers={});let t=Jm(this.array);e.arrayBuffers[t]===void 0&&(e.arrayBuffers[t]=Array.from(new Uint32Array(this.array.slice(0).buffer)));let n={uuid:this.uuid,buffer:t,type:this.array.constructor.name,stride:this.stride};return n.usage=this.usage,n}};function Jm(i){return i.buffer._uuid===void 0&&(i.buffer._uuid=Nr()),i.byteOffset===0&&i.byteLength===i.buffer.byteLength?i.buffer._uuid:i.buffer._uuid+":"+i.byteOffset+":"+i.byteLength}var di=new J,ia=class i{constructor(e,t,n,r=!1){this.isInterleavedBufferAttribute=!0,this.name="",this.data=e,this.itemSize=t,this.offset=n,this.normalized=r,this._normalizationScale=e!==void 0?Wu(e.array):void 0}get count(){return this.data.count}get array(){return this.data.array}set needsUpdate(e){this.data.needsUpdate=e}applyMatrix4(e){for(let t=0,n=this.data.count;t<n;t++)di.fromBufferAttribute(this,t),di.applyMatrix4(e),this.setXYZ(t,di.x,di.y,di.z);return this}applyNormalMatrix(e){for(let t=0,n=this.count;t<n;t++)di.fromBufferAttribute(this,t),di.applyNormalMatrix(e),this.setXYZ(t,di.x,di.y,di.z);return this}transformDirection(e){for(let t=0,n=this.count;t<n;t++)di.fromBufferAttribute(this,t),di.transformDirection(e),this.setXYZ(t,di.x,di.y,di.z);return this}getComponent(e,t){let n=this.array[e*this.data.stride+this.offset+t];return this.normalized&&(n=this._denormalize(n)),n}setComponent(e,t,n){return this.normalized&&(n=this._normalize(n)),this.data.array[e*this.data.stride+this.offset+t]=n,this}setX(e,t){return this.normalized&&(t=this._normalize(t)),this.data.array[e*this.data.stride+this.offset]=t,this}setY(e,t){return this.normalized&&(t=this._normalize(t)),this.data.array[e*this.data.stride+this.offset+1]=t,this}setZ(e,t){return this.normalized&&(t=this._normalize(t)),this.data.array[e*this.data.stride+this.offset+2]=t,this}setW(e,t){return this.normalized&&(t=this._normalize(t)),this.data.array[e*this.data.stride+this.offset+3]=t,this}getX(e){let t=this.data.array[e*this.data.stride+this.offset];return this.normalized&&(t=this._denormalize(t)),t}getY(e){let t=this.data.array[e*this.data.stride+this.offset+1];return this.normalized&&(t=this._denormalize(t)),t}getZ(e){let t=this.data.array[e*this.data.stride+this.offset+2];return this.normalized&&(t=this._denormalize(t)),t}getW(e){let t=this.data.array[e*this.data.stride+this.offset+3];return this.normalized&&(t=this._denormalize(t)),t}setXY(e,t,n){return e=e*this.data.stride+this.offset,this.normalized&&(t=this._normalize(t),n=this._normalize(n)),this.data.array[e+0]=t,this.data.array[e+1]=n,this}setXYZ(e,t,n,r){return e=e*this.data.stride+this.offset,this.normalized&&(t=this._normalize(t),n=this._normalize(n),r=this._normalize(r)),this.data.array[e+0]=t,this.data.array[e+1]=n,this.data.array[e+2]=r,this}setXYZW(e,t,n,r,s){return e=e*this.data.stride+this.offset,this.normalized&&(t=this._normalize(t),n=this._normalize(n),r=this._normalize(r),s=this._normalize(s)),this.data.array[e+0]=t,this.data.array[e+1]=n,this.data.array[e+2]=r,this.data.array[e+3]=s,this}clone(e){if(e===void 0){rl("InterleavedBufferAttribute.clone(): Cloning an interleaved buffer attribute will de-interleave buffer data.");let t=[];for(let n=0;n<this.count;n++){let r=n*this.data.stride+this.offset;for(let s=0;s<this.itemSize;s++)t.push(this.data.array[r+s])}return new an(new this.array.constructor(t),this.itemSize,this.normalized)}else return e.interleavedBuffers===void 0&&(e.interleavedBuffers={}),e.interleavedBuffers[this.data.uuid]===void 0&&(e.interleavedBuffers[this.data.uuid]=this.data.clone(e)),new i(e.interleavedBuffers[this.data.uuid],this.itemSize,this.offset,this.normalized)}toJSON(e){if(e===void 0){rl("InterleavedBufferAttribute.toJSON(): Serializing an interleaved buffer attribute will de-interleave buffer data.");let t=[];for(let n=0;n<this.count;n++){let r=n*this.data.stride+this.offset;for(let s=0;s<this.itemSize;s++)t.push(this.data.array[r+s])}return{itemSize:this.itemSize,type:this.array.constructor.name,array:t,normalized:this.normalized}}else return e.interleavedBuffers===void 0&&(e.interleavedBuffers={}),e.interleavedBuffers[this.data.uuid]===void 0&&(e.interleavedBuffers[this.data.uuid]=this.data.toJSON(e)),{isInterleavedBufferAttribute:!0,itemSize:this.itemSize,data:this.data.uuid,offset:this.offset,normalized:this.normalized}}_denormalize(e){let t=this._normalizationScale;return t!==void 0?Math.max(e/t,-1):hd(e,this.data.array)}_normalize(e){let t=this._normalizationScale;return t!==void 0?Math.round(e*t):fd(e,this.data.array)}},xf=new J,oy=new J,ay=new dt,ar=class{constructor(e=new J(1,0,0),t=0){this.isPlane=!0,this.normal=e,this.constant=t}set(e,t){return this.normal.copy(e),this.constant=t,this}setComponents(e,t,n,r){return this.normal.set(e,t,n),this.constant=r,this}setFromNormalAndCoplanarPoint(e,t){return this.normal.copy(e),this.constant=-t.dot(this.normal),this}setFromCoplanarPoints(e,t,n){let r=xf.subVectors(n,t).cross(oy.subVectors(e,t)).normalize();return this.setFromNormalAndCoplanarPoint(r,e),this}copy(e){return this.normal.copy(e.normal),this.constant=e.constant,this}normalize(){let e=1/this.normal.length();return this.normal.multiplyScalar(e),this.constant*=e,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(e){return this.normal.dot(e)+this.constant}distanceToSphere(e){return this.distanceToPoint(e.center)-e.radius}projectPoint(e,t){return t.copy(e).addScaledVector(this.normal,-this.distanceToPoint(e))}intersectLine(e,t,n=!0){let r=e.delta(xf),s=this.normal.dot(r);if(s===0)return this.distanceToPoint(e.start)===0?t.copy(e.start):null;let o=-(e.start.dot(this.normal)+this.constant)/s;return n===!0&&(o<0||o>1)?null:t.copy(e.start).addScaledVector(r,o)}intersectsLine(e){let t=this.distanceToPoint(e.start),n=this.distanceToPoint(e.end);return t<0&&n>0||n<0&&t>0}intersectsBox(e){return e.intersectsPlane(this)}intersectsSphere(e){return e.intersectsPlane(this)}coplanarPoint(e){return e.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(e,t){let n=t||ay.getNormalMatrix(e),r=this.coplanarPoint(xf).applyMatrix4(e),s=this.normal.applyMatrix3(n).normalize();return this.constant=-r.dot(s),this}translate(e){return this.constant-=e.dot(this.normal),this}equals(e){return e.normal.equals(this.normal)&&e.constant===this.constant}clone(){return new this.constructor().copy(this)}toJSON(){return{normal:this.normal.toArray(),constant:this.constant}}fromJSON(e){return this.normal.fromArray(e.normal),this.constant=e.constant,this}},ly=0,Kn=class extends Tr{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:ly++}),this.uuid=Nr(),this.name="",this.type="Material",this.blending=ha,this.side=Pr,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=Hf,this.blendDst=Gf,this.blendEquation=ho,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new ht(0,0,0),this.blendAlpha=0,this.depthFunc=Zo,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=J0,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=Dc,this.stencilZFail=Dc,this.stencilZPass=Dc,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(e){this._alphaTest>0!=e>0&&this.version++,this._alphaTest=e}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(e){if(e!==void 0)for(let t in e){let n=e[t];if(n===void 0){nt(`Material: parameter '${t}' has value of undefined.`);continue}let r=this[t];if(r===void 0){nt(`Material: '${t}' is not a property of THREE.${this.type}.`);continue}r&&r.isColor?r.set(n):r&&r.isVector2&&n&&n.isVector2||r&&r.isEuler&&n&&n.isEuler||r&&r.isVector3&&n&&n.isVector3?r.copy(n):this[t]=n}}toJSON(e){let t=e===void 0||typeof e=="string";t&&(e={textures:{},images:{}});let n={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};n.uuid=this.uuid,n.type=this.type,n.blending=this.blending,n.side=this.side,n.shadowSide=this.shadowSide,n.vertexColors=this.vertexColors,n.opacity=this.opacity,n.transparent=this.transparent,n.blendSrc=this.blendSrc,n.blendDst=this.blendDst,n.blendEquation=this.blendEquation,n.blendSrcAlpha=this.blendSrcAlpha,n.blendDstAlpha=this.blendDstAlpha,n.blendEquationAlpha=this.blendEquationAlpha,n.blendColor=this.blendColor.getHex(),n.blendAlpha=this.blendAlpha,n.depthFunc=this.depthFunc,n.depthTest=this.depthTest,n.depthWrite=this.depthWrite,n.colorWrite=this.colorWrite,n.clipIntersection=this.clipIntersection,n.clipShadows=this.clipShadows,n.stencilWriteMask=this.stencilWriteMask,n.stencilFunc=this.stencilFunc,n.stencilRef=this.stencilRef,n.stencilFuncMask=this.stencilFuncMask,n.stencilFail=this.stencilFail,n.stencilZFail=this.stencilZFail,n.stencilZPass=this.stencilZPass,n.stencilWrite=this.stencilWrite,n.polygonOffset=this.polygonOffset,n.polygonOffsetFactor=this.polygonOffsetFactor,n.polygonOffsetUnits=this.polygonOffsetUnits,n.dithering=this.dithering,n.alphaTest=this.alphaTest,n.alphaHash=this.alphaHash,n.alphaToCoverage=this.alphaToCoverage,n.premultipliedAlpha=this.premultipliedAlpha,n.forceSinglePass=this.forceSinglePass,n.allowOverride=this.allowOverride,n.visible=this.visible,n.toneMapped=this.toneMapped,n.name=this.name,this.color&&this.color.isColor&&(n.color=this.color.getHex()),this.roughness!==void 0&&(n.roughness=this.roughness),this.metalness!==void 0&&(n.metalness=this.metalness),this.sheen!==void 0&&(n.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(n.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(n.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(n.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&(n.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(n.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(n.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(n.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(n.shininess=this.shininess),this.clearcoat!==void 0&&(n.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(n.clearcoatRoughness=this.clearcoatRoughness),this.diffuseRoughness!==void 0&&(n.diffuseRoughness=this.diffuseRoughness),this.diffuseRoughnessMap&&this.diffuseRoughnessMap.isTexture&&(n.diffuseRoughnessMap=this.diffuseRoughnessMap.toJSON(e).uuid),this.clearcoatMap&&this.clearcoatMap.isTexture&&(n.clearcoatMap=this.clearcoatMap.toJSON(e).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(n.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(e).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(n.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(e).uuid,n.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(n.sheenColorMap=this.sheenColorMap.toJSON(e).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(n.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(e).uuid),this.dispersion!==void 0&&(n.dispersion=this.dispersion),this.retroreflectivity!==void 0&&(n.retroreflectivity=this.retroreflectivity),this.iridescence!==void 0&&(n.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(n.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessMinimum!==void 0&&(n.iridescenceThicknessMinimum=this.iridescenceThicknessMinimum),this.iridescenceThicknessMaximum!==void 0&&(n.iridescenceThicknessMaximum=this.iridescenceThicknessMaximum),this.iridescenceMap&&this.iridescenceMap.isTexture&&(n.iridescenceMap=this.iridescenceMap.toJSON(e).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(n.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(e).uuid),this.anisotropy!==void 0&&(n.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(n.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(n.anisotropyMap=this.anisotropyMap.toJSON(e).uuid),this.map&&this.map.isTexture&&(n.map=this.map.toJSON(e).uuid),this.matcap&&this.matcap.isTexture&&(n.matcap=this.matcap.toJSON(e).uuid),this.alphaMap&&this.alphaMap.isTexture&&(n.alphaMap=this.alphaMap.toJSON(e).uuid),this.lightMap&&this.lightMap.isTexture&&(n.lightMap=this.lightMap.toJSON(e).uuid,n.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(n.aoMap=this.aoMap.toJSON(e).uuid,n.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(n.bumpMap=this.bumpMap.toJSON(e).uuid,n.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(n.normalMap=this.normalMap.toJSON(e).uuid,n.normalMapType=this.normalMapType,n.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(n.displacementMap=this.displacementMap.toJSON(e).uuid,n.displacementScale=this.displacementScale,n.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(n.roughnessMap=this.roughnessMap.toJSON(e).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(n.metalnessMap=this.metalnessMap.toJSON(e).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(n.emissiveMap=this.emissiveMap.toJSON(e).uuid),this.specularMap&&this.specularMap.isTexture&&(n.specularMap=this.specularMap.toJSON(e).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(n.specularIntensityMap=this.specularIntensityMap.toJSON(e).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(n.specularColorMap=this.specularColorMap.toJSON(e).uuid),this.envMap&&this.envMap.isTexture&&(n.envMap=this.envMap.toJSON(e).uuid,this.combine!==void 0&&(n.combine=this.combine)),this.envMapRotation!==void 0&&(n.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(n.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(n.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(n.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(n.gradientMap=this.gradientMap.toJSON(e).uuid),this.transmission!==void 0&&(n.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(n.transmissionMap=this.transmissionMap.toJSON(e).uuid),this.thickness!==void 0&&(n.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(n.thicknessMap=this.thicknessMap.toJSON(e).uuid),this.attenuationDistance!==void 0&&(n.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(n.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(n.size=this.size),this.sizeAttenuation!==void 0&&(n.sizeAttenuation=this.sizeAttenuation),Array.isArray(this.clippingPlanes)&&this.clippingPlanes.length>0&&(n.clippingPlanes=this.clippingPlanes.map(s=>s.toJSON())),this.rotation!==void 0&&(n.rotation=this.rotation),this.depthPacking!==void 0&&(n.depthPacking=this.depthPacking),this.linewidth!==void 0&&(n.linewidth=this.linewidth),this.linecap!==void 0&&(n.linecap=this.linecap),this.linejoin!==void 0&&(n.linejoin=this.linejoin),this.dashSize!==void 0&&(n.dashSize=this.dashSize),this.gapSize!==void 0&&(n.gapSize=this.gapSize),this.scale!==void 0&&(n.scale=this.scale),this.wireframe!==void 0&&(n.wireframe=this.wireframe),this.wireframeLinewidth!==void 0&&(n.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!==void 0&&(n.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!==void 0&&(n.wireframeLinejoin=this.wireframeLinejoin),this.flatShading!==void 0&&(n.flatShading=this.flatShading),this.fog!==void 0&&(n.fog=this.fog),Object.keys(this.userData).length>0&&(n.userData=this.userData);function r(s){let o=[];for(let a in s){let l=s[a];delete l.metadata,o.push(l)}return o}if(t){let s=r(e.textures),o=r(e.images);s.length>0&&(n.textures=s),o.length>0&&(n.images=o)}return n}fromJSON(e,t){if(e.uuid!==void 0&&(this.uuid=e.uuid),e.name!==void 0&&(this.name=e.name),e.color!==void 0&&this.color!==void 0&&this.color.setHex(e.color),e.roughness!==void 0&&(this.roughness=e.roughness),e.metalness!==void 0&&(this.metalness=e.metalness),e.sheen!==void 0&&(this.sheen=e.sheen),e.sheenColor!==void 0&&(this.sheenColor=new ht().setHex(e.sheenColor)),e.sheenRoughness!==void 0&&(this.sheenRoughness=e.sheenRoughness),e.emissive!==void 0&&this.emissive!==void 0&&this.emissive.setHex(e.emissive),e.specular!==void 0&&this.specular!==void 0&&this.specular.setHex(e.specular),e.specularIntensity!==void 0&&(this.specularIntensity=e.specularIntensity),e.specularColor!==void 0&&this.specularColor!==void 0&&this.specularColor.setHex(e.specularColor),e.shininess!==void 0&&(this.shininess=e.shininess),e.clearcoat!==void 0&&(this.clearcoat=e.clearcoat),e.clearcoatRoughness!==void 0&&(this.clearcoatRoughness=e.clearcoatRoughness),e.diffuseRoughness!==void 0&&(this.diffuseRoughness=e.diffuseRoughness),e.dispersion!==void 0&&(this.dispersion=e.dispersion),e.retroreflectivity!==void 0&&(this.retroreflectivity=e.retroreflectivity),e.iridescence!==void 0&&(this.iridescence=e.iridescence),e.iridescenceIOR!==void 0&&(this.iridescenceIOR=e.iridescenceIOR),e.iridescenceThicknessMinimum!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessMinimum),e.iridescenceThicknessMaximum!==void 0&&(this.iridescenceThicknessMaximum=e.iridescenceThicknessMaximum),e.iridescenceThicknessRange!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessRange[0],this.iridescenceThicknessMaximum=e.iridescenceThicknessRange[1]),e.transmission!==void 0&&(this.transmission=e.transmission),e.thickness!==void 0&&(this.thickness=e.thickness),e.attenuationDistance!==void 0&&(this.attenuationDistance=e.attenuationDistance),e.attenuationColor!==void 0&&this.attenuationColor!==void 0&&this.attenuationColor.setHex(e.attenuationColor),e.anisotropy!==void 0&&(this.anisotropy=e.anisotropy),e.anisotropyRotation!==void 0&&(this.anisotropyRotation=e.anisotropyRotation),e.fog!==void 0&&(this.fog=e.fog),e.flatShading!==void 0&&(this.flatShading=e.flatShading),e.blending!==void 0&&(this.blending=e.blending),e.combine!==void 0&&(this.combine=e.combine),e.side!==void 0&&(this.side=e.side),e.shadowSide!==void 0&&(this.shadowSide=e.shadowSide),e.opacity!==void 0&&(this.opacity=e.opacity),e.transparent!==void 0&&(this.transparent=e.transparent),e.alphaTest!==void 0&&(this.alphaTest=e.alphaTest),e.alphaHash!==void 0&&(this.alphaHash=e.alphaHash),e.depthFunc!==void 0&&(this.depthFunc=e.depthFunc),e.depthTest!==void 0&&(this.depthTest=e.depthTest),e.depthWrite!==void 0&&(this.depthWrite=e.depthWrite),e.colorWrite!==void 0&&(this.colorWrite=e.colorWrite),e.clippingPlanes!==void 0&&(this.clippingPlanes=e.clippingPlanes.map(n=>new ar().fromJSON(n))),e.clipIntersection!==void 0&&(this.clipIntersection=e.clipIntersection),e.clipShadows!==void 0&&(this.clipShadows=e.clipShadows),e.depthPacking!==void 0&&(this.depthPacking=e.depthPacking),e.blendSrc!==void 0&&(this.blendSrc=e.blendSrc),e.blendDst!==void 0&&(this.blendDst=e.blendDst),e.blendEquation!==void 0&&(this.blendEquation=e.blendEquation),e.blendSrcAlpha!==void 0&&(this.blendSrcAlpha=e.blendSrcAlpha),e.blendDstAlpha!==void 0&&(this.blendDstAlpha=e.blendDstAlpha),e.blendEquationAlpha!==void 0&&(this.blendEquationAlpha=e.blendEquationAlpha),e.blendColor!==void 0&&this.blendColor!==void 0&&this.blendColor.setHex(e.blendColor),e.blendAlpha!==void 0&&(this.blendAlpha=e.blendAlpha),e.stencilWriteMask!==void 0&&(this.stencilWriteMask=e.stencilWriteMask),e.stencilFunc!==void 0&&(this.stencilFunc=e.stencilFunc),e.stencilRef!==void 0&&(this.stencilRef=e.stencilRef),e.stencilFuncMask!==void 0&&(this.stencilFuncMask=e.stencilFuncMask),e.stencilFail!==void 0&&(this.stencilFail=e.stencilFail),e.stencilZFail!==void 0&&(this.stencilZFail=e.stencilZFail),e.stencilZPass!==void 0&&(this.stencilZPass=e.stencilZPass),e.stencilWrite!==void 0&&(this.stencilWrite=e.stencilWrite),e.wireframe!==void 0&&(this.wireframe=e.wireframe),e.wireframeLinewidth!==void 0&&(this.wireframeLinewidth=e.wireframeLinewidth),e.wireframeLinecap!==void 0&&(this.wireframeLinecap=e.wireframeLinecap),e.wireframeLinejoin!==void 0&&(this.wireframeLinejoin=e.wireframeLinejoin),e.rotation!==void 0&&(this.rotation=e.rotation),e.linewidth!==void 0&&(this.linewidth=e.linewidth),e.linecap!==void 0&&(this.linecap=e.linecap),e.linejoin!==void 0&&(this.linejoin=e.linejoin),e.dashSize!==void 0&&(this.dashSize=e.dashSize),e.gapSize!==void 0&&(this.gapSize=e.gapSize),e.scale!==void 0&&(this.scale=e.scale),e.polygonOffset!==void 0&&(this.polygonOffset=e.polygonOffset),e.polygonOffsetFactor!==void 0&&(this.polygonOffsetFactor=e.polygonOffsetFactor),e.polygonOffsetUnits!==void 0&&(this.polygonOffsetUnits=e.polygonOffsetUnits),e.dithering!==void 0&&(this.dithering=e.dithering),e.alphaToCoverage!==void 0&&(this.alphaToCoverage=e.alphaToCoverage),e.premultipliedAlpha!==void 0&&(this.premultipliedAlpha=e.premultipliedAlpha),e.forceSinglePass!==void 0&&(this.forceSinglePass=e.forceSinglePass),e.allowOverride!==void 0&&(this.allowOverride=e.allowOverride),e.visible!==void 0&&(this.visible=e.visible),e.toneMapped!==void 0&&(this.toneMapped=e.toneMapped),e.userData!==void 0&&(this.userData=e.userData),e.vertexColors!==void 0&&(typeof e.vertexColors=="number"?this.vertexColors=e.vertexColors>0:this.vertexColors=e.vertexColors),e.size!==void 0&&(this.size=e.size),e.sizeAttenuation!==void 0&&(this.sizeAttenuation=e.sizeAttenuation),e.map!==void 0&&(this.map=t[e.map]||null),e.matcap!==void 0&&(this.matcap=t[e.matcap]||null),e.alphaMap!==void 0&&(this.alphaMap=t[e.alphaMap]||null),e.bumpMap!==void 0&&(this.bumpMap=t[e.bumpMap]||null),e.bumpScale!==void 0&&(this.bumpScale=e.bumpScale),e.normalMap!==void 0&&(this.normalMap=t[e.normalMap]||null),e.normalMapType!==void 0&&(this.normalMapType=e.normalMapType),e.normalScale!==void 0){let n=e.normalScale;Array.isArray(n)===!1&&(n=[n,n]),this.normalScale=new xt().fromArray(n)}return e.displacementMap!==void 0&&(this.displacementMap=t[e.displacementMap]||null),e.displacementScale!==void 0&&(this.displacementScale=e.displacementScale),e.displacementBias!==void 0&&(this.displacementBias=e.displacementBias),e.roughnessMap!==void 0&&(this.roughnessMap=t[e.roughnessMap]||null),e.metalnessMap!==void 0&&(this.metalnessMap=t[e.metalnessMap]||null),e.emissiveMap!==void 0&&(this.emissiveMap=t[e.emissiveMap]||null),e.emissiveIntensity!==void 0&&(this.emissiveIntensity=e.emissiveIntensity),e.specularMap!==void 0&&(this.specularMap=t[e.specularMap]||null),e.specularIntensityMap!==void 0&&(this.specularIntensityMap=t[e.specularIntensityMap]||null),e.specularColorMap!==void 0&&(this.specularColorMap=t[e.specularColorMap]||null),e.envMap!==void 0&&(this.envMap=t[e.envMap]||null),e.envMapRotation!==void 0&&this.envMapRotation.fromArray(e.envMapRotation),e.envMapIntensity!==void 0&&(this.envMapIntensity=e.envMapIntensity),e.reflectivity!==void 0&&(this.reflectivity=e.reflectivity),e.refractionRatio!==void 0&&(this.refractionRatio=e.refractionRatio),e.lightMap!==void 0&&(this.lightMap=t[e.lightMap]||null),e.lightMapIntensity!==void 0&&(this.lightMapIntensity=e.lightMapIntensity),e.aoMap!==void 0&&(this.aoMap=t[e.aoMap]||null),e.aoMapIntensity!==void 0&&(this.aoMapIntensity=e.aoMapIntensity),e.gradientMap!==void 0&&(this.gradientMap=t[e.gradientMap]||null),e.clearcoatMap!==void 0&&(this.clearcoatMap=t[e.clearcoatMap]||null),e.clearcoatRoughnessMap!==void 0&&(this.clearcoatRoughnessMap=t[e.clearcoatRoughnessMap]||null),e.clearcoatNormalMap!==void 0&&(this.clearcoatNormalMap=t[e.clearcoatNormalMap]||null),e.clearcoatNormalScale!==void 0&&(this.clearcoatNormalScale=new xt().fromArray(e.clearcoatNormalScale)),e.diffuseRoughnessMap!==void 0&&(this.diffuseRoughnessMap=t[e.diffuseRoughnessMap]||null),e.iridescenceMap!==void 0&&(this.iridescenceMap=t[e.iridescenceMap]||null),e.iridescenceThicknessMap!==void 0&&(this.iridescenceThicknessMap=t[e.iridescenceThicknessMap]||null),e.transmissionMap!==void 0&&(this.transmissionMap=t[e.transmissionMap]||null),e.thicknessMap!==void 0&&(this.thicknessMap=t[e.thicknessMap]||null),e.anisotropyMap!==void 0&&(this.anisotropyMap=t[e.anisotropyMap]||null),e.sheenColorMap!==void 0&&(this.sheenColorMap=t[e.sheenColorMap]||null),e.sheenRoughnessMap!==void 0&&(this.sheenRoughnessMap=t[e.sheenRoughnessMap]||null),this}clone(){return new this.constructor().copy(this)}copy(e){this.name=e.name,this.blending=e.blending,this.side=e.side,this.vertexColors=e.vertexColors,this.opacity=e.opacity,this.transparent=e.transparent,this.blendSrc=e.blendSrc,this.blendDst=e.blendDst,this.blendEquation=e.blendEquation,this.blendSrcAlpha=e.blendSrcAlpha,this.blendDstAlpha=e.blendDstAlpha,this.blendEquationAlpha=e.blendEquationAlpha,this.blendColor.copy(e.blendColor),this.blendAlpha=e.blendAlpha,this.depthFunc=e.depthFunc,this.depthTest=e.depthTest,this.depthWrite=e.depthWrite,this.stencilWriteMask=e.stencilWriteMask,this.stencilFunc=e.stencilFunc,this.stencilRef=e.stencilRef,this.stencilFuncMask=e.stencilFuncMask,this.stencilFail=e.stencilFail,this.stencilZFail=e.stencilZFail,this.stencilZPass=e.stencilZPass,this.stencilWrite=e.stencilWrite;let t=e.clippingPlanes,n=null;if(t!==null){let r=t.length;n=new Array(r);for(let s=0;s!==r;++s)n[s]=t[s].clone()}return this.clippingPlanes=n,this.clipIntersection=e.clipIntersection,this.clipShadows=e.clipShadows,this.shadowSide=e.shadowSide,this.colorWrite=e.colorWrite,this.precision=e.precision,this.polygonOffset=e.polygonOffset,this.polygonOffsetFactor=e.polygonOffsetFactor,this.polygonOffsetUnits=e.polygonOffsetUnits,this.dithering=e.dithering,this.alphaTest=e.alphaTest,this.alphaHash=e.alphaHash,this.alphaToCoverage=e.alphaToCoverage,this.premultipliedAlpha=e.premultipliedAlpha,this.forceSinglePass=e.forceSinglePass,this.allowOverride=e.allowOverride,this.visible=e.visible,this.toneMapped=e.toneMapped,this.userData=JSON.parse(JSON.stringify(e.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(e){e===!0&&this.version++}};var $r=new J,vf=new J,mc=new J,gc=new J,ro=class{constructor(e=new J,t=new J(0,0,-1)){this.origin=e,this.direction=t}set(e,t){return this.origin.copy(e),this.direction.copy(t),this}copy(e){return this.origin.copy(e.origin),this.direction.copy(e.direction),this}at(e,t){return t.copy(this.origin).addScaledVector(this.direction,e)}lookAt(e){return this.direction.copy(e).sub(this.origin).normalize(),this}recast(e){return this.origin.copy(this.at(e,$r)),this}closestPointToPoint(e,t){t.subVectors(e,this.origin);let n=t.dot(this.direction);return n<0?t.copy(this.origin):t.copy(this.origin).addScaledVector(this.direction,n)}distanceToPoint(e){return Math.sqrt(this.distanceSqToPoint(e))}distanceSqToPoint(e){let t=$r.subVectors(e,this.origin).dot(this.direction);return t<0?this.origin.distanceToSquared(e):($r.copy(this.origin).addScaledVector(this.direction,t),$r.distanceToSquared(e))}distanceSqToSegment(e,t,n,r){vf.copy(e).add(t).multiplyScalar(.5),mc.copy(t).sub(e).normalize(),gc.copy(this.origin).sub(vf);let s=e.distanceTo(t)*.5,o=-this.direction.dot(mc),a=gc.dot(this.direction),l=-gc.dot(mc),c=gc.lengthSq(),u=Math.abs(1-o*o),h,f,d,m;if(u>0)if(h=o*l-a,f=o*a-l,m=s*u,h>=0)if(f>=-m)if(f<=m){let b=1/u;h*=b,f*=b,d=h*(h+o*f+2*a)+f*(o*h+f+2*l)+c}else f=s,h=Math.max(0,-(o*f+a)),d=-h*h+f*(f+2*l)+c;else f=-s,h=Math.max(0,-(o*f+a)),d=-h*h+f*(f+2*l)+c;else f<=-m?(h=Math.max(0,-(-o*s+a)),f=h>0?-s:Math.min(Math.max(-s,-l),s),d=-h*h+f*(f+2*l)+c):f<=m?(h=0,f=Math.min(Math.max(-s,-l),s),d=f*(f+2*l)+c):(h=Math.max(0,-(o*s+a)),f=h>0?s:Math.min(Math.max(-s,-l),s),d=-h*h+f*(f+2*l)+c);else f=o>0?-s:s,h=Math.max(0,-(o*f+a)),d=-h*h+f*(f+2*l)+c;return n&&n.copy(this.origin).addScaledVector(this.direction,h),r&&r.copy(vf).addScaledVector(mc,f),d}intersectSphere(e,t){if(e.radius<0)return null;$r.subVectors(e.center,this.origin);let n=$r.dot(this.direction),r=$r.dot($r)-n*n,s=e.radius*e.radius;if(r>s)return null;let o=Math.sqrt(s-r),a=n-o,l=n+o;return l<0?null:a<0?this.at(l,t):this.at(a,t)}intersectsSphere(e){return e.radius<0?!1:this.distanceSqToPoint(e.center)<=e.radius*e.radius}distanceToPlane(e){let t=e.normal.dot(this.direction);if(t===0)return e.distanceToPoint(this.origin)===0?0:null;let n=-(this.origin.dot(e.normal)+e.constant)/t;return n>=0?n:null}intersectPlane(e,t){let n=this.distanceToPlane(e);return n===null?null:this.at(n,t)}intersectsPlane(e){let t=e.distanceToPoint(this.origin);return t===0||e.normal.dot(this.direction)*t<0}intersectBox(e,t){let n,r,s,o,a,l,c=1/this.direction.x,u=1/this.direction.y,h=1/this.direction.z,f=this.origin;return c>=0?(n=(e.min.x-f.x)*c,r=(e.max.x-f.x)*c):(n=(e.max.x-f.x)*c,r=(e.min.x-f.x)*c),u>=0?(s=(e.min.y-f.y)*u,o=(e.max.y-f.y)*u):(s=(e.max.y-f.y)*u,o=(e.min.y-f.y)*u),n>o||s>r||((s>n||isNaN(n))&&(n=s),(o<r||isNaN(r))&&(r=o),h>=0?(a=(e.min.z-f.z)*h,l=(e.max.z-f.z)*h):(a=(e.max.z-f.z)*h,l=(e.min.z-f.z)*h),n>l||a>r)||((a>n||n!==n)&&(n=a),(l<r||r!==r)&&(r=l),r<0)?null:this.at(n>=0?n:r,t)}intersectsBox(e){return this.intersectBox(e,$r)!==null}intersectTriangle(e,t,n,r,s){let o=this.origin,a=this.direction,l=a.x,c=a.y,u=a.z,h=e.x-o.x,f=e.y-o.y,d=e.z-o.z,m=t.x-o.x,b=t.y-o.y,g=t.z-o.z,_=n.x-o.x,S=n.y-o.y,T=n.z-o.z,M=Math.abs(l),P=Math.abs(c),R=Math.abs(u),y,A,V,z,D,q,Y,U,W,K,$,xe;if(M>=P&&M>=R?(V=l,q=h,W=m,xe=_,l>=0?(y=c,A=u,z=f,D=d,Y=b,U=g,K=S,$=T):(y=u,A=c,z=d,D=f,Y=g,U=b,K=T,$=S)):P>=R?(V=c,q=f,W=b,xe=S,c>=0?(y=u,A=l,z=d,D=h,Y=g,U=m,K=T,$=_):(y=l,A=u,z=h,D=d,Y=m,U=g,K=_,$=T)):(V=u,q=d,W=g,xe=T,u>=0?(y=l,A=c,z=h,D=f,Y=m,U=b,K=_,$=S):(y=c,A=l,z=f,D=h,Y=b,U=m,K=S,$=_)),V===0)return null;let ne=y/V,re=A/V,de=1/V,ge=z-ne*q,pe=D-re*q,se=Y-ne*W,Ee=U-re*W,Pe=K-ne*xe,Oe=$-re*xe,ye=Pe*Ee-Oe*se,Ke=ge*Oe-pe*Pe,ft=se*pe-Ee*ge;if(r){if(ye<0||Ke<0||ft<0)return null}else if((ye<0||Ke<0||ft<0)&&(ye>0||Ke>0||ft>0))return null;let et=ye+Ke+ft;if(et===0)return null;let St=de*(ye*q+Ke*W+ft*xe);return(et>0?St<0:St>0)?null:this.at(St/et,s)}applyMatrix4(e){return this.origin.applyMatrix4(e),this.direction.transformDirection(e),this}equals(e){return e.origin.equals(this.origin)&&e.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},Er=class extends Kn{constructor(e){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new ht(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Ar,this.combine=ru,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.fog=e.fog,this}},jm=new it,Js=new ro,_c=new vi,Qm=new J,xc=new J,vc=new J,yc=new J,yf=new J,bc=new J,e0=new J,wc=new J,In=class extends wn{constructor(e=new _n,t=new Er){super(),this.isMesh=!0,this.type="Mesh",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}updateMorphTargets(){let t=this.geometry.morphAttributes,n=Object.keys(t);if(n.length>0){let r=t[n[0]];if(r!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let s=0,o=r.length;s<o;s++){let a=r[s].name||String(s);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=s}}}}getVertexPosition(e,t){let n=this.geometry,r=n.attributes.position,s=n.morphAttributes.position,o=n.morphTargetsRelative;t.fromBufferAttribute(r,e);let a=this.morphTargetInfluences;if(s&&a){bc.set(0,0,0);for(let l=0,c=s.length;l<c;l++){let u=a[l],h=s[l];u!==0&&(yf.fromBufferAttribute(h,e),o?bc.addScaledVector(yf,u):bc.addScaledVector(yf.sub(t),u))}t.add(bc)}return t}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let n=this.geometry,r=this.material,s=this.matrixWorld;r!==void 0&&(n.boundingSphere===null&&n.computeBoundingSphere(),_c.copy(n.boundingSphere),_c.applyMatrix4(s),Js.copy(e.ray).recast(e.near),!(_c.containsPoint(Js.origin)===!1&&(Js.intersectSphere(_c,Qm)===null||Js.origin.distanceToSquared(Qm)>(e.far-e.near)**2))&&(jm.copy(s).invert(),Js.copy(e.ray).applyMatrix4(jm),!(n.boundingBox!==null&&Js.intersectsBox(n.boundingBox)===!1)&&this._computeIntersections(e,t,Js)))}_computeIntersections(e,t,n){let r,s=this.geometry,o=this.material,a=s.index,l=s.attributes.position,c=s.attributes.uv,u=s.attributes.uv1,h=s.attributes.normal,f=s.groups,d=s.drawRange;if(a!==null)if(Array.isArray(o))for(let m=0,b=f.length;m<b;m++){let g=f[m],_=o[g.materialIndex],S=Math.max(g.start,d.start),T=Math.min(a.count,Math.min(g.start+g.count,d.start+d.count));for(let M=S,P=T;M<P;M+=3){let R=a.getX(M),y=a.getX(M+1),A=a.getX(M+2);r=Sc(this,_,e,n,c,u,h,R,y,A),r&&(r.faceIndex=Math.floor(M/3),r.face.materialIndex=g.materialIndex,t.push(r))}}else{let m=Math.max(0,d.start),b=Math.min(a.count,d.start+d.count);for(let g=m,_=b;g<_;g+=3){let S=a.getX(g),T=a.getX(g+1),M=a.getX(g+2);r=Sc(this,o,e,n,c,u,h,S,T,M),r&&(r.faceIndex=Math.floor(g/3),t.push(r))}}else if(l!==void 0)if(Array.isArray(o))for(let m=0,b=f.length;m<b;m++){let g=f[m],_=o[g.materialIndex],S=Math.max(g.start,d.start),T=Math.min(l.count,Math.min(g.start+g.count,d.start+d.count));for(let M=S,P=T;M<P;M+=3){let R=M,y=M+1,A=M+2;r=Sc(this,_,e,n,c,u,h,R,y,A),r&&(r.faceIndex=Math.floor(M/3),r.face.materialIndex=g.materialIndex,t.push(r))}}else{let m=Math.max(0,d.start),b=Math.min(l.count,d.start+d.count);for(let g=m,_=b;g<_;g+=3){let S=g,T=g+1,M=g+2;r=Sc(this,o,e,n,c,u,h,S,T,M),r&&(r.faceIndex=Math.floor(g/3),t.push(r))}}}};function cy(i,e,t,n,r,s,o,a){let l;if(e.side===mi?l=n.intersectTriangle(o,s,r,!0,a):l=n.intersectTriangle(r,s,o,e.side===Pr,a),l===null)return null;wc.copy(a),wc.applyMatrix4(i.matrixWorld);let c=t.ray.origin.distanceTo(wc);return c<t.near||c>t.far?null:{distance:c,point:wc.clone(),object:i}}function Sc(i,e,t,n,r,s,o,a,l,c){i.getVertexPosition(a,xc),i.getVertexPosition(l,vc),i.getVertexPosition(c,yc);let u=cy(i,e,t,n,xc,vc,yc,e0);if(u){let h=new J;Ls.getBarycoord(e0,xc,vc,yc,h),r&&(u.uv=Ls.getInterpolatedAttribute(r,a,l,c,h,new xt)),s&&(u.uv1=Ls.getInterpolatedAttribute(s,a,l,c,h,new xt)),o&&(u.normal=Ls.getInterpolatedAttribute(o,a,l,c,h,new J),u.normal.dot(n.direction)>0&&u.normal.multiplyScalar(-1));let f={a,b:l,c,normal:new J,materialIndex:0};Ls.getNormal(xc,vc,yc,f.normal),u.face=f,u.barycoord=h}return u}var Ka=new Ot,t0=new Ot,n0=new Ot,uy=new Ot,i0=new it,Mc=new J,bf=new vi,r0=new it,wf=new ro,cl=class extends In{constructor(e,t){super(e,t),this.isSkinnedMesh=!0,this.type="SkinnedMesh",this.bindMode=Af,this.bindMatrix=new it,this.bindMatrixInverse=new it,this.boundingBox=null,this.boundingSphere=null}computeBoundingBox(){let e=this.geometry;this.boundingBox===null&&(this.boundingBox=new Ni),this.boundingBox.makeEmpty();let t=e.getAttribute("position");for(let n=0;n<t.count;n++)this.getVertexPosition(n,Mc),this.boundingBox.expandByPoint(Mc)}computeBoundingSphere(){let e=this.geometry;this.boundingSphere===null&&(this.boundingSphere=new vi),this.boundingSphere.makeEmpty();let t=e.getAttribute("position");for(let n=0;n<t.count;n++)this.getVertexPosition(n,Mc),this.boundingSphere.expandByPoint(Mc)}copy(e,t){return super.copy(e,t),this.bindMode=e.bindMode,this.bindMatrix.copy(e.bindMatrix),this.bindMatrixInverse.copy(e.bindMatrixInverse),this.skeleton=e.skeleton,this.boundingBox=e.boundingBox!==null?e.boundingBox.clone():null,this.boundingSphere=e.boundingSphere!==null?e.boundingSphere.clone():null,this}raycast(e,t){let n=this.material,r=this.matrixWorld;n!==void 0&&(this.boundingSphere===null&&this.computeBoundingSphere(),bf.copy(this.boundingSphere),bf.applyMatrix4(r),e.ray.intersectsSphere(bf)!==!1&&(r0.copy(r).invert(),wf.copy(e.ray).applyMatrix4(r0),!(this.boundingBox!==null&&wf.intersectsBox(this.boundingBox)===!1)&&this._computeIntersections(e,t,wf)))}getVertexPosition(e,t){return super.getVertexPosition(e,t),this.applyBoneTransform(e,t),t}bind(e,t){this.skeleton=e,t===void 0&&(this.updateMatrixWorld(!0),this.skeleton.calculateInverses(),t=this.matrixWorld),this.bindMatrix.copy(t),this.bindMatrixInverse.copy(t).invert()}pose(){this.skeleton.pose()}normalizeSkinWeights(){let e=new Ot,t=this.geometry.attributes.skinWeight;for(let n=0,r=t.count;n<r;n++){e.fromBufferAttribute(t,n);let s=1/e.manhattanLength();s!==1/0?e.multiplyScalar(s):e.set(1,0,0,0),t.setXYZW(n,e.x,e.y,e.z,e.w)}}updateMatrixWorld(e){super.updateMatrixWorld(e),this.bindMode===Af?this.bindMatrixInverse.copy(this.matrixWorld).invert():this.bindMode===Y0?this.bindMatrixInverse.copy(this.bindMatrix).invert():nt("SkinnedMesh: Unrecognized bindMode: "+this.bindMode)}applyBoneTransform(e,t){let n=this.skeleton,r=this.geometry;t0.fromBufferAttribute(r.attributes.skinIndex,e),n0.fromBufferAttribute(r.attributes.skinWeight,e),t.isVector4?(Ka.copy(t),t.set(0,0,0,0)):(Ka.set(t.x,t.y,t.z,1),t.set(0,0,0)),Ka.applyMatrix4(this.bindMatrix);for(let s=0;s<4;s++){let o=n0.getComponent(s);if(o!==0){let a=t0.getComponent(s);i0.multiplyMatrices(n.bones[a].matrixWorld,n.boneInverses[a]),t.addScaledVector(uy.copy(Ka).applyMatrix4(i0),o)}}return t.isVector4&&(t.w=Ka.w),t.applyMatrix4(this.bindMatrixInverse)}},ra=class extends wn{constructor(){super(),this.isBone=!0,this.type="Bone"}},oi=class extends $n{constructor(e=null,t=1,n=1,r,s,o,a,l,c=Ut,u=Ut,h,f){super(null,o,a,l,c,u,r,s,h,f),this.isDataTexture=!0,this.image={data:e,width:t,height:n},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}},s0=new it,hy=new it,ul=class i{constructor(e=[],t=[]){this.uuid=Nr(),this.bones=e.slice(0),this.boneInverses=t,this.boneMatrices=null,this.previousBoneMatrices=null,this.boneTexture=null,this.previousBoneTexture=null,this.init()}init(){let e=this.bones,t=this.boneInverses;if(this.boneMatrices=new Float32Array(e.length*16),t.length===0)this.calculateInverses();else if(e.length!==t.length){nt("Skeleton: Number of inverse bone matrices does not match amount of bones."),this.boneInverses=[];for(let n=0,r=this.bones.length;n<r;n++)this.boneInverses.push(new it)}}calculateInverses(){this.boneInverses.length=0;for(let e=0,t=this.bones.length;e<t;e++){let n=new it;this.bones[e]&&n.copy(this.bones[e].matrixWorld).invert(),this.boneInverses.push(n)}}pose(){for(let e=0,t=this.bones.length;e<t;e++){let n=this.bones[e];n&&n.matrixWorld.copy(this.boneInverses[e]).invert()}for(let e=0,t=this.bones.length;e<t;e++){let n=this.bones[e];n&&(n.parent&&n.parent.isBone?(n.matrix.copy(n.parent.matrixWorld).invert(),n.matrix.multiply(n.matrixWorld)):n.matrix.copy(n.matrixWorld),n.matrix.decompose(n.position,n.quaternion,n.scale))}}update(){let e=this.bones,t=this.boneInverses,n=this.boneMatrices,r=this.boneTexture;for(let s=0,o=e.length;s<o;s++){let a=e[s]?e[s].matrixWorld:hy;s0.multiplyMatrices(a,t[s]),s0.toArray(n,s*16)}r!==null&&(r.needsUpdate=!0)}clone(){return new i(this.bones,this.boneInverses)}computeBoneTexture(){let e=Math.sqrt(this.bones.length*4);e=Math.ceil(e/4)*4,e=Math.max(e,4);let t=new Float32Array(e*e*4);t.set(this.boneMatrices);let n=new oi(t,e,e,jt,Nt);return n.needsUpdate=!0,this.boneMatrices=t,this.boneTexture=n,this}getBoneByName(e){for(let t=0,n=this.bones.length;t<n;t++){let r=this.bones[t];if(r.name===e)return r}}dispose(){this.boneTexture!==null&&(this.boneTexture.dispose(),this.boneTexture=null),this.previousBoneTexture!==null&&(this.previousBoneTexture.dispose(),this.previousBoneTexture=null)}fromJSON(e,t){this.uuid=e.uuid;for(let n=0,r=e.bones.length;n<r;n++){let s=e.bones[n],o=t[s];o===void 0&&(nt("Skeleton: No bone found with UUID:",s),o=new ra),this.bones.push(o),this.boneInverses.push(new it().fromArray(e.boneInverses[n]))}return this.init(),this}toJSON(){let e={metadata:{version:4.7,type:"Skeleton",generator:"Skeleton.toJSON"},bones:[],boneInverses:[]};e.uuid=this.uuid;let t=this.bones,n=this.boneInverses;for(let r=0,s=t.length;r<s;r++){let o=t[r];e.bones.push(o.uuid);let a=n[r];e.boneInverses.push(a.toArray())}return e}},Qr=class extends an{constructor(e,t,n,r=1){super(e,t,n),this.isInstancedBufferAttribute=!0,this.meshPerAttribute=r}copy(e){return super.copy(e),this.meshPerAttribute=e.meshPerAttribute,this}toJSON(){let e=super.toJSON();return e.meshPerAttribute=this.meshPerAttribute,e.isInstancedBufferAttribute=!0,e}},Wo=new it,o0=new it,Tc=[],a0=new Ni,fy=new it,Ja=new In,ja=new vi,hl=class extends In{constructor(e,t,n){super(e,t),this.isInstancedMesh=!0,this.instanceMatrix=new Qr(new Float32Array(n*16),16),this.instanceColor=null,this.morphTexture=null,this.count=n,this.boundingBox=null,this.boundingSphere=null;for(let r=0;r<n;r++)this.setMatrixAt(r,fy)}computeBoundingBox(){let e=this.geometry,t=this.count;this.boundingBox===null&&(this.boundingBox=new Ni),e.boundingBox===null&&e.computeBoundingBox(),this.boundingBox.makeEmpty();for(let n=0;n<t;n++)this.getMatrixAt(n,Wo),a0.copy(e.boundingBox).applyMatrix4(Wo),this.boundingBox.union(a0)}computeBoundingSphere(){let e=this.geometry,t=this.count;this.boundingSphere===null&&(this.boundingSphere=new vi),e.boundingSphere===null&&e.computeBoundingSphere(),this.boundingSphere.makeEmpty();for(let n=0;n<t;n++)this.getMatrixAt(n,Wo),ja.copy(e.boundingSphere).applyMatrix4(Wo),this.boundingSphere.union(ja)}copy(e,t){return super.copy(e,t),this.instanceMatrix.copy(e.instanceMatrix),this.morphTexture=e.morphTexture!==null?e.morphTexture.clone():null,this.instanceColor=e.instanceColor!==null?e.instanceColor.clone():null,this.count=e.count,this.boundingBox=e.boundingBox!==null?e.boundingBox.clone():null,this.boundingSphere=e.boundingSphere!==null?e.boundingSphere.clone():null,this}getColorAt(e,t){return this.instanceColor===null?t.setRGB(1,1,1):t.fromArray(this.instanceColor.array,e*3)}getMatrixAt(e,t){return t.fromArray(this.instanceMatrix.array,e*16)}getMorphAt(e,t){let n=t.morphTargetInfluences,r=this.morphTexture.source.data.data,s=n.length+1,o=e*s+1;for(let a=0;a<n.length;a++)n[a]=r[o+a]}raycast(e,t){let n=this.matrixWorld,r=this.count;if(Ja.geometry=this.geometry,Ja.material=this.material,Ja.material!==void 0&&(this.boundingSphere===null&&this.computeBoundingSphere(),ja.copy(this.boundingSphere),ja.applyMatrix4(n),e.ray.intersectsSphere(ja)!==!1))for(let s=0;s<r;s++){this.getMatrixAt(s,Wo),o0.multiplyMatrices(n,Wo),Ja.matrixWorld=o0,Ja.raycast(e,Tc);for(let o=0,a=Tc.length;o<a;o++){let l=Tc[o];l.instanceId=s,l.object=this,t.push(l)}Tc.length=0}}setColorAt(e,t){return this.instanceColor===null&&(this.instanceColor=new Qr(new Float32Array(this.instanceMatrix.count*3).fill(1),3)),t.toArray(this.instanceColor.array,e*3),this}setMatrixAt(e,t){return t.toArray(this.instanceMatrix.array,e*16),this}setMorphAt(e,t){let n=t.morphTargetInfluences,r=n.length+1;this.morphTexture===null&&(this.morphTexture=new oi(new Float32Array(r*this.count),r,this.count,ls,Nt));let s=this.morphTexture.source.data.data,o=0;for(let c=0;c<n.length;c++)o+=n[c];let a=this.geometry.morphTargetsRelative?1:1-o,l=r*e;return s[l]=a,s.set(n,l+1),this}updateMorphTargets(){}dispose(){super.dispose(),this.instanceMatrix.dispose(),this.instanceColor!==null&&this.instanceColor.dispose(),this.morphTexture!==null&&(this.morphTexture.dispose(),this.morphTexture=null)}},js=new vi,dy=new xt(.5,.5),Ac=new J,Ds=class{constructor(e=new ar,t=new ar,n=new ar,r=new ar,s=new ar,o=new ar){this.planes=[e,t,n,r,s,o]}set(e,t,n,r,s,o){let a=this.planes;return a[0].copy(e),a[1].copy(t),a[2].copy(n),a[3].copy(r),a[4].copy(s),a[5].copy(o),this}copy(e){let t=this.planes;for(let n=0;n<6;n++)t[n].copy(e.planes[n]);return this}setFromProjectionMatrix(e,t=Wi,n=!1){let r=this.planes,s=e.elements,o=s[0],a=s[1],l=s[2],c=s[3],u=s[4],h=s[5],f=s[6],d=s[7],m=s[8],b=s[9],g=s[10],_=s[11],S=s[12],T=s[13],M=s[14],P=s[15];if(r[0].setComponents(c-o,d-u,_-m,P-S).normalize(),r[1].setComponents(c+o,d+u,_+m,P+S).normalize(),r[2].setComponents(c+a,d+h,_+b,P+T).normalize(),r[3].setComponents(c-a,d-h,_-b,P-T).normalize(),n)r[4].setComponents(l,f,g,M).normalize(),r[5].setComponents(c-l,d-f,_-g,P-M).normalize();else if(r[4].setComponents(c-l,d-f,_-g,P-M).normalize(),t===Wi)r[5].setComponents(c+l,d+f,_+g,P+M).normalize();else if(t===Jo)r[5].setComponents(l,f,g,M).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+t);return this}intersectsObject(e){if(e.boundingSphere!==void 0)e.boundingSphere===null&&e.computeBoundingSphere(),js.copy(e.boundingSphere).applyMatrix4(e.matrixWorld);else{let t=e.geometry;t.boundingSphere===null&&t.computeBoundingSphere(),js.copy(t.boundingSphere).applyMatrix4(e.matrixWorld)}return this.intersectsSphere(js)}intersectsSprite(e){js.center.set(0,0,0);let t=dy.distanceTo(e.center);return js.radius=.7071067811865476+t,js.applyMatrix4(e.matrixWorld),this.intersectsSphere(js)}intersectsSphere(e){let t=this.planes,n=e.center,r=-e.radius;for(let s=0;s<6;s++)if(t[s].distanceToPoint(n)<r)return!1;return!0}intersectsBox(e){let t=this.planes;for(let n=0;n<6;n++){let r=t[n];if(Ac.x=r.normal.x>0?e.max.x:e.min.x,Ac.y=r.normal.y>0?e.max.y:e.min.y,Ac.z=r.normal.z>0?e.max.z:e.min.z,r.distanceToPoint(Ac)<0)return!1}return!0}containsPoint(e){let t=this.planes;for(let n=0;n<6;n++)if(t[n].distanceToPoint(e)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}},l0=new it,Xc=class i{constructor(){this.coordinateSystem=Wi,this._frustums=[],this._count=0}setFromArrayCamera(e){let t=e.cameras,n=this._frustums;for(let r=0;r<t.length;r++){let s=t[r];l0.multiplyMatrices(s.projectionMatrix,s.matrixWorldInverse),n[r]===void 0&&(n[r]=new Ds),n[r].setFromProjectionMatrix(l0,s.coordinateSystem,s.reversedDepth)}return this._count=t.length,this}getFrustum(e){return this._frustums[e]}intersectsObject(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsObject(e))return!0;return!1}intersectsSprite(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsSprite(e))return!0;return!1}intersectsSphere(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsSphere(e))return!0;return!1}intersectsBox(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsBox(e))return!0;return!1}containsPoint(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].containsPoint(e))return!0;return!1}copy(e){this.coordinateSystem=e.coordinateSystem;let t=this._frustums,n=e._frustums;for(let r=0;r<e._count;r++)t[r]===void 0&&(t[r]=new Ds),t[r].copy(n[r]);return this._count=e._count,this}clone(){return new i().copy(this)}};var Rr=class extends Kn{constructor(e){super(),this.isLineBasicMaterial=!0,this.type="LineBasicMaterial",this.color=new ht(16777215),this.map=null,this.linewidth=1,this.linecap="round",this.linejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.linewidth=e.linewidth,this.linecap=e.linecap,this.linejoin=e.linejoin,this.fog=e.fog,this}},qc=new J,Yc=new J,c0=new it,Qa=new ro,Ec=new vi,Sf=new J,u0=new J,so=class extends wn{constructor(e=new _n,t=new Rr){super(),this.isLine=!0,this.type="Line",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}computeLineDistances(){let e=this.geometry;if(e.index===null){let t=e.attributes.position,n=[0];for(let r=1,s=t.count;r<s;r++)qc.fromBufferAttribute(t,r-1),Yc.fromBufferAttribute(t,r),n[r]=n[r-1],n[r]+=qc.distanceTo(Yc);e.setAttribute("lineDistance",new Cn(n,1))}else nt("Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let n=this.geometry,r=this.matrixWorld,s=e.params.Line.threshold,o=n.drawRange;if(n.boundingSphere===null&&n.computeBoundingSphere(),Ec.copy(n.boundingSphere),Ec.applyMatrix4(r),Ec.radius+=s,e.ray.intersectsSphere(Ec)===!1)return;c0.copy(r).invert(),Qa.copy(e.ray).applyMatrix4(c0);let a=s/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=this.isLineSegments?2:1,u=n.index,f=n.attributes.position;if(u!==null){let d=Math.max(0,o.start),m=Math.min(u.count,o.start+o.count);for(let b=d,g=m-1;b<g;b+=c){let _=u.getX(b),S=u.getX(b+1),T=Rc(this,e,Qa,l,_,S,b);T&&t.push(T)}if(this.isLineLoop){let b=u.getX(m-1),g=u.getX(d),_=Rc(this,e,Qa,l,b,g,m-1);_&&t.push(_)}}else{let d=Math.max(0,o.start),m=Math.min(f.count,o.start+o.count);for(let b=d,g=m-1;b<g;b+=c){let _=Rc(this,e,Qa,l,b,b+1,b);_&&t.push(_)}if(this.isLineLoop){let b=Rc(this,e,Qa,l,m-1,d,m-1);b&&t.push(b)}}}updateMorphTargets(){let t=this.geometry.morphAttributes,n=Object.keys(t);if(n.length>0){let r=t[n[0]];if(r!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let s=0,o=r.length;s<o;s++){let a=r[s].name||String(s);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=s}}}}};function Rc(i,e,t,n,r,s,o){let a=i.geometry.attributes.position;if(qc.fromBufferAttribute(a,r),Yc.fromBufferAttribute(a,s),t.distanceSqToSegment(qc,Yc,Sf,u0)>n)return;Sf.applyMatrix4(i.matrixWorld);let c=e.ray.origin.distanceTo(Sf);if(!(c<e.near||c>e.far))return{distance:c,point:u0.clone().applyMatrix4(i.matrixWorld),index:o,face:null,faceIndex:null,barycoord:null,object:i}}var h0=new J,f0=new J,Fs=class extends so{constructor(e,t){super(e,t),this.isLineSegments=!0,this.type="LineSegments"}computeLineDistances(){let e=this.geometry;if(e.index===null){let t=e.attributes.position,n=[];for(let r=0,s=t.count;r<s;r+=2)h0.fromBufferAttribute(t,r),f0.fromBufferAttribute(t,r+1),n[r]=r===0?0:n[r-1],n[r+1]=n[r]+h0.distanceTo(f0);e.setAttribute("lineDistance",new Cn(n,1))}else nt("LineSegments.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}},fl=class extends so{constructor(e,t){super(e,t),this.isLineLoop=!0,this.type="LineLoop"}},lr=class extends Kn{constructor(e){super(),this.isPointsMaterial=!0,this.type="PointsMaterial",this.color=new ht(16777215),this.map=null,this.alphaMap=null,this.size=1,this.sizeAttenuation=!0,this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.alphaMap=e.alphaMap,this.size=e.size,this.sizeAttenuation=e.sizeAttenuation,this.fog=e.fog,this}},d0=new it,Pf=new ro,Cc=new vi,Ic=new J,es=class extends wn{constructor(e=new _n,t=new lr){super(),this.isPoints=!0,this.type="Points",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let n=this.geometry,r=this.matrixWorld,s=e.params.Points.threshold,o=n.drawRange;if(n.boundingSphere===null&&n.computeBoundingSphere(),Cc.copy(n.boundingSphere),Cc.applyMatrix4(r),Cc.radius+=s,e.ray.intersectsSphere(Cc)===!1)return;d0.copy(r).invert(),Pf.copy(e.ray).applyMatrix4(d0);let a=s/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=n.index,h=n.attributes.position;if(c!==null){let f=Math.max(0,o.start),d=Math.min(c.count,o.start+o.count);for(let m=f,b=d;m<b;m++){let g=c.getX(m);Ic.fromBufferAttribute(h,g),p0(Ic,g,l,r,e,t,this)}}else{let f=Math.max(0,o.start),d=Math.min(h.count,o.start+o.count);for(let m=f,b=d;m<b;m++)Ic.fromBufferAttribute(h,m),p0(Ic,m,l,r,e,t,this)}}updateMorphTargets(){let t=this.geometry.morphAttributes,n=Object.keys(t);if(n.length>0){let r=t[n[0]];if(r!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let s=0,o=r.length;s<o;s++){let a=r[s].name||String(s);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=s}}}}};function p0(i,e,t,n,r,s,o){let a=Pf.distanceSqToPoint(i);if(a<t){let l=new J;Pf.closestPointToPoint(i,l),l.applyMatrix4(n);let c=r.ray.origin.distanceTo(l);if(c<r.near||c>r.far)return;s.push({distance:c,distanceToRay:Math.sqrt(a),point:l,index:e,face:null,faceIndex:null,barycoord:null,object:o})}}var dl=class extends $n{constructor(e=[],t=fo,n,r,s,o,a,l,c,u){super(e,t,n,r,s,o,a,l,c,u),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(e){this.image=e}};var cr=class extends $n{constructor(e,t,n=ur,r,s,o,a=Ut,l=Ut,c,u=jr,h=1){if(u!==jr&&u!==as)throw new Error("THREE.DepthTexture: format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let f={width:e,height:t,depth:h};super(f,r,s,o,a,l,u,n,c),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(e){return super.copy(e),this.source=new ea(Object.assign({},e.image)),this.compareFunction=e.compareFunction,this}toJSON(e){let t=super.toJSON(e);return t.compareFunction=this.compareFunction,t}},pl=class extends cr{constructor(e,t=ur,n=fo,r,s,o=Ut,a=Ut,l,c=jr){let u={width:e,height:e,depth:1},h=[u,u,u,u,u,u];super(e,e,t,n,r,s,o,a,l,c),this.image=h,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(e){this.image=e}},ml=class extends $n{constructor(e=null){super(),this.sourceTexture=e,this.isExternalTexture=!0}copy(e){return super.copy(e),this.sourceTexture=e.sourceTexture,this}},sa=class i extends _n{constructor(e=1,t=1,n=1,r=1,s=1,o=1){super(),this.type="BoxGeometry",this.parameters={width:e,height:t,depth:n,widthSegments:r,heightSegments:s,depthSegments:o};let a=this;r=Math.floor(r),s=Math.floor(s),o=Math.floor(o);let l=[],c=[],u=[],h=[],f=0,d=0;m("z","y","x",-1,-1,n,t,e,o,s,0),m("z","y","x",1,-1,n,t,-e,o,s,1),m("x","z","y",1,1,e,n,t,r,o,2),m("x","z","y",1,-1,e,n,-t,r,o,3),m("x","y","z",1,-1,e,t,n,r,s,4),m("x","y","z",-1,-1,e,t,-n,r,s,5),this.setIndex(l),this.setAttribute("position",new Cn(c,3)),this.setAttribute("normal",new Cn(u,3)),this.setAttribute("uv",new Cn(h,2));function m(b,g,_,S,T,M,P,R,y,A,V){let z=M/y,D=P/A,q=M/2,Y=P/2,U=R/2,W=y+1,K=A+1,$=0,xe=0,ne=new J;for(let re=0;re<K;re++){let de=re*D-Y;for(let ge=0;ge<W;ge++){let pe=ge*z-q;ne[b]=pe*S,ne[g]=de*T,ne[_]=U,c.push(ne.x,ne.y,ne.z),ne[b]=0,ne[g]=0,ne[_]=R>0?1:-1,u.push(ne.x,ne.y,ne.z),h.push(ge/y),h.push(1-re/A),$+=1}}for(let re=0;re<A;re++)for(let de=0;de<y;de++){let ge=f+de+W*re,pe=f+de+W*(re+1),se=f+(de+1)+W*(re+1),Ee=f+(de+1)+W*re;l.push(ge,pe,Ee),l.push(pe,se,Ee),xe+=6}a.addGroup(d,xe,V),d+=xe,f+=$}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.width,e.height,e.depth,e.widthSegments,e.heightSegments,e.depthSegments)}};var gl=class i extends _n{constructor(e=1,t=1,n=1,r=1){super(),this.type="PlaneGeometry",this.parameters={width:e,height:t,widthSegments:n,heightSegments:r};let s=e/2,o=t/2,a=Math.floor(n),l=Math.floor(r),c=a+1,u=l+1,h=e/a,f=t/l,d=[],m=[],b=[],g=[];for(let _=0;_<u;_++){let S=_*f-o;for(let T=0;T<c;T++){let M=T*h-s;m.push(M,-S,0),b.push(0,0,1),g.push(T/a),g.push(1-_/l)}}for(let _=0;_<l;_++)for(let S=0;S<a;S++){let T=S+c*_,M=S+c*(_+1),P=S+1+c*(_+1),R=S+1+c*_;d.push(T,M,R),d.push(M,P,R)}this.setIndex(d),this.setAttribute("position",new Cn(m,3)),this.setAttribute("normal",new Cn(b,3)),this.setAttribute("uv",new Cn(g,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.width,e.height,e.widthSegments,e.heightSegments)}};function go(i){let e={};for(let t in i){e[t]={};for(let n in i[t]){let r=i[t][n];if(m0(r))r.isRenderTargetTexture?(nt("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),e[t][n]=null):e[t][n]=r.clone();else if(Array.isArray(r))if(m0(r[0])){let s=[];for(let o=0,a=r.length;o<a;o++)s[o]=r[o].clone();e[t][n]=s}else e[t][n]=r.slice();else e[t][n]=r}}return e}function li(i){let e={};for(let t=0;t<i.length;t++){let n=go(i[t]);for(let r in n)e[r]=n[r]}return e}function m0(i){return i&&(i.isColor||i.isMatrix3||i.isMatrix4||i.isVector2||i.isVector3||i.isVector4||i.isTexture||i.isQuaternion)}function py(i){let e=[];for(let t=0;t<i.length;t++)e.push(i[t].clone());return e}function dd(i){let e=i.getRenderTarget();return e===null?i.outputColorSpace:e.isXRRenderTarget===!0?e.texture.colorSpace:Rt.workingColorSpace}var lg={clone:go,merge:li},my=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,gy=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,Cr=class extends Kn{constructor(e){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=my,this.fragmentShader=gy,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,e!==void 0&&this.setValues(e)}copy(e){return super.copy(e),this.fragmentShader=e.fragmentShader,this.vertexShader=e.vertexShader,this.uniforms=go(e.uniforms),this.uniformsGroups=py(e.uniformsGroups),this.defines=Object.assign({},e.defines),this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.fog=e.fog,this.lights=e.lights,this.clipping=e.clipping,this.extensions=Object.assign({},e.extensions),this.glslVersion=e.glslVersion,this.defaultAttributeValues=Object.assign({},e.defaultAttributeValues),this.index0AttributeName=e.index0AttributeName,this.uniformsNeedUpdate=e.uniformsNeedUpdate,this}toJSON(e){let t=super.toJSON(e);t.glslVersion=this.glslVersion,t.uniforms={};for(let r in this.uniforms){let o=this.uniforms[r].value;o&&o.isTexture?t.uniforms[r]={type:"t",value:o.toJSON(e).uuid}:o&&o.isColor?t.uniforms[r]={type:"c",value:o.getHex()}:o&&o.isVector2?t.uniforms[r]={type:"v2",value:o.toArray()}:o&&o.isVector3?t.uniforms[r]={type:"v3",value:o.toArray()}:o&&o.isVector4?t.uniforms[r]={type:"v4",value:o.toArray()}:o&&o.isMatrix3?t.uniforms[r]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?t.uniforms[r]={type:"m4",value:o.toArray()}:t.uniforms[r]={value:o}}Object.keys(this.defines).length>0&&(t.defines=this.defines),t.vertexShader=this.vertexShader,t.fragmentShader=this.fragmentShader,t.lights=this.lights,t.clipping=this.clipping;let n={};for(let r in this.extensions)this.extensions[r]===!0&&(n[r]=!0);return Object.keys(n).length>0&&(t.extensions=n),t}fromJSON(e,t){if(super.fromJSON(e,t),e.uniforms!==void 0)for(let n in e.uniforms){let r=e.uniforms[n];switch(this.uniforms[n]={},r.type){case"t":this.uniforms[n].value=t[r.value]||null;break;case"c":this.uniforms[n].value=new ht().setHex(r.value);break;case"v2":this.uniforms[n].value=new xt().fromArray(r.value);break;case"v3":this.uniforms[n].value=new J().fromArray(r.value);break;case"v4":this.uniforms[n].value=new Ot().fromArray(r.value);break;case"m3":this.uniforms[n].value=new dt().fromArray(r.value);break;case"m4":this.uniforms[n].value=new it().fromArray(r.value);break;default:this.uniforms[n].value=r.value}}if(e.defines!==void 0&&(this.defines=e.defines),e.vertexShader!==void 0&&(this.vertexShader=e.vertexShader),e.fragmentShader!==void 0&&(this.fragmentShader=e.fragmentShader),e.glslVersion!==void 0&&(this.glslVersion=e.glslVersion),e.extensions!==void 0)for(let n in e.extensions)this.extensions[n]=e.extensions[n];return e.lights!==void 0&&(this.lights=e.lights),e.clipping!==void 0&&(this.clipping=e.clipping),this}},oa=class extends Cr{constructor(e){super(e),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}},oo=class extends Kn{constructor(e){super(),this.isMeshStandardMaterial=!0,this.type="MeshStandardMaterial",this.defines={STANDARD:""},this.color=new ht(16777215),this.roughness=1,this.metalness=0,this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new ht(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=Nl,this.normalScale=new xt(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.roughnessMap=null,this.metalnessMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Ar,this.envMapIntensity=1,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.defines={STANDARD:""},this.color.copy(e.color),this.roughness=e.roughness,this.metalness=e.metalness,this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.emissive.copy(e.emissive),this.emissiveMap=e.emissiveMap,this.emissiveIntensity=e.emissiveIntensity,this.bumpMap=e.bumpMap,this.bumpScale=e.bumpScale,this.normalMap=e.normalMap,this.normalMapType=e.normalMapType,this.normalScale.copy(e.normalScale),this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.roughnessMap=e.roughnessMap,this.metalnessMap=e.metalnessMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.envMapIntensity=e.envMapIntensity,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.flatShading=e.flatShading,this.fog=e.fog,this}},pi=class extends oo{constructor(e){super(),this.isMeshPhysicalMaterial=!0,this.defines={STANDARD:"",PHYSICAL:""},this.type="MeshPhysicalMaterial",this.anisotropyRotation=0,this.anisotropyMap=null,this.clearcoatMap=null,this.clearcoatRoughness=0,this.clearcoatRoughnessMap=null,this.clearcoatNormalScale=new xt(1,1),this.clearcoatNormalMap=null,this.diffuseRoughnessMap=null,this.ior=1.5,Object.defineProperty(this,"reflectivity",{get:function(){return It(2.5*(this.ior-1)/(this.ior+1),0,1)},set:function(t){this.ior=(1+.4*t)/(1-.4*t)}}),this.iridescenceMap=null,this.iridescenceIOR=1.3,this.iridescenceThicknessMinimum=100,this.iridescenceThicknessMaximum=400,this.iridescenceThicknessMap=null,this.sheenColor=new ht(0),this.sheenColorMap=null,this.sheenRoughness=1,this.sheenRoughnessMap=null,this.transmissionMap=null,this.thickness=0,this.thicknessMap=null,this.attenuationDistance=1/0,this.attenuationColor=new ht(1,1,1),this.specularIntensity=1,this.specularIntensityMap=null,this.specularColor=new ht(1,1,1),this.specularColorMap=null,this._anisotropy=0,this._clearcoat=0,this._diffuseRoughness=0,this._dispersion=0,this._iridescence=0,this._retroreflectivity=0,this._sheen=0,this._transmission=0,this.setValues(e)}get anisotropy(){return this._anisotropy}set anisotropy(e){this._anisotropy>0!=e>0&&this.version++,this._anisotropy=e}get clearcoat(){return this._clearcoat}set clearcoat(e){this._clearcoat>0!=e>0&&this.version++,this._clearcoat=e}get diffuseRoughness(){return this._diffuseRoughness}set diffuseRoughness(e){this._diffuseRoughness>0!=e>0&&this.version++,this._diffuseRoughness=e}get iridescence(){return this._iridescence}set iridescence(e){this._iridescence>0!=e>0&&this.version++,this._iridescence=e}get dispersion(){return this._dispersion}set dispersion(e){this._dispersion>0!=e>0&&this.version++,this._dispersion=e}get retroreflectivity(){return this._retroreflectivity}set retroreflectivity(e){this._retroreflectivity>0!=e>0&&this.version++,this._retroreflectivity=e}get sheen(){return this._sheen}set sheen(e){this._sheen>0!=e>0&&this.version++,this._sheen=e}get transmission(){return this._transmission}set transmission(e){this._transmission>0!=e>0&&this.version++,this._transmission=e}get iridescenceThicknessRange(){return Qs('MeshPhysicalMaterial: The "iridescenceThicknessRange" property has been replaced by "iridescenceThicknessMinimum" and "iridescenceThicknessMaximum".'),[this.iridescenceThicknessMinimum,this.iridescenceThicknessMaximum]}set iridescenceThicknessRange(e){Qs('MeshPhysicalMaterial: The "iridescenceThicknessRange" property has been replaced by "iridescenceThicknessMinimum" and "iridescenceThicknessMaximum".'),this.iridescenceThicknessMinimum=e[0],this.iridescenceThicknessMaximum=e[1]}copy(e){return super.copy(e),this.defines={STANDARD:"",PHYSICAL:""},this.anisotropy=e.anisotropy,this.anisotropyRotation=e.anisotropyRotation,this.anisotropyMap=e.anisotropyMap,this.clearcoat=e.clearcoat,this.clearcoatMap=e.clearcoatMap,this.clearcoatRoughness=e.clearcoatRoughness,this.clearcoatRoughnessMap=e.clearcoatRoughnessMap,this.clearcoatNormalMap=e.clearcoatNormalMap,this.clearcoatNormalScale.copy(e.clearcoatNormalScale),this.diffuseRoughness=e.diffuseRoughness,this.diffuseRoughnessMap=e.diffuseRoughnessMap,this.dispersion=e.dispersion,this.ior=e.ior,this.iridescence=e.iridescence,this.iridescenceMap=e.iridescenceMap,this.iridescenceIOR=e.iridescenceIOR,this.iridescenceThicknessMinimum=e.iridescenceThicknessMinimum,this.iridescenceThicknessMaximum=e.iridescenceThicknessMaximum,this.iridescenceThicknessMap=e.iridescenceThicknessMap,this.retroreflectivity=e.retroreflectivity,this.sheen=e.sheen,this.sheenColor.copy(e.sheenColor),this.sheenColorMap=e.sheenColorMap,this.sheenRoughness=e.sheenRoughness,this.sheenRoughnessMap=e.sheenRoughnessMap,this.transmission=e.transmission,this.transmissionMap=e.transmissionMap,this.thickness=e.thickness,this.thicknessMap=e.thicknessMap,this.attenuationDistance=e.attenuationDistance,this.attenuationColor.copy(e.attenuationColor),this.specularIntensity=e.specularIntensity,this.specularIntensityMap=e.specularIntensityMap,this.specularColor.copy(e.specularColor),this.specularColorMap=e.specularColorMap,this}},_l=class extends Kn{constructor(e){super(),this.isMeshPhongMaterial=!0,this.type="MeshPhongMaterial",this.color=new ht(16777215),this.specular=new ht(1118481),this.shininess=30,this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new ht(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=Nl,this.normalScale=new xt(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Ar,this.combine=ru,this.reflectivity=1,this.envMapIntensity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.specular.copy(e.specular),this.shininess=e.shininess,this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.emissive.copy(e.emissive),this.emissiveMap=e.emissiveMap,this.emissiveIntensity=e.emissiveIntensity,this.bumpMap=e.bumpMap,this.bumpScale=e.bumpScale,this.normalMap=e.normalMap,this.normalMapType=e.normalMapType,this.normalScale.copy(e.normalScale),this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.envMapIntensity=e.envMapIntensity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.flatShading=e.flatShading,this.fog=e.fog,this}};var $c=class extends Kn{constructor(e){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=Z0,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(e)}copy(e){return super.copy(e),this.depthPacking=e.depthPacking,this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this}},Zc=class extends Kn{constructor(e){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(e)}copy(e){return super.copy(e),this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this}};function Ps(i,e){return!i||i.constructor===e?i:typeof e.BYTES_PER_ELEMENT=="number"?new e(i):Array.prototype.slice.call(i)}function el(i){return i!==void 0&&i.inTangents!==void 0&&i.outTangents!==void 0}function _y(i){function e(r,s){return i[r]-i[s]}let t=i.length,n=new Array(t);for(let r=0;r!==t;++r)n[r]=r;return n.sort(e),n}function g0(i,e,t){let n=i.length,r=new i.constructor(n);for(let s=0,o=0;o!==n;++s){let a=t[s]*e;for(let l=0;l!==e;++l)r[o++]=i[a+l]}return r}function xy(i,e,t,n){let r=1,s=i[0];for(;s!==void 0&&s[n]===void 0;)s=i[r++];if(s===void 0)return;let o=s[n];if(o!==void 0)if(Array.isArray(o))do o=s[n],o!==void 0&&(e.push(s.time),t.push(...o)),s=i[r++];while(s!==void 0);else if(o.toArray!==void 0)do o=s[n],o!==void 0&&(e.push(s.time),o.toArray(t,t.length)),s=i[r++];while(s!==void 0);else do o=s[n],o!==void 0&&(e.push(s.time),t.push(o)),s=i[r++];while(s!==void 0)}var Ir=class{constructor(e,t,n,r){this.parameterPositions=e,this._cachedIndex=0,this.resultBuffer=r!==void 0?r:new t.constructor(n),this.sampleValues=t,this.valueSize=n,this.settings=null,this.DefaultSettings_={}}evaluate(e){let t=this.parameterPositions,n=this._cachedIndex,r=t[n],s=t[n-1];n:{e:{let o;t:{i:if(!(e<r)){for(let a=n+2;;){if(r===void 0){if(e<s)break i;return n=t.length,this._cachedIndex=n,this.copySampleValue_(n-1)}if(n===a)break;if(s=r,r=t[++n],e<r)break e}o=t.length;break t}if(!(e>=s)){let a=t[1];e<a&&(n=2,s=a);for(let l=n-2;;){if(s===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(n===l)break;if(r=s,s=t[--n-1],e>=s)break e}o=n,n=0;break t}break n}for(;n<o;){let a=n+o>>>1;e<t[a]?o=a:n=a+1}if(r=t[n],s=t[n-1],s===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(r===void 0)return n=t.length,this._cachedIndex=n,this.copySampleValue_(n-1)}this._cachedIndex=n,this.intervalChanged_(n,s,r)}return this.interpolate_(n,s,e,r)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(e){let t=this.resultBuffer,n=this.sampleValues,r=this.valueSize,s=e*r;for(let o=0;o!==r;++o)t[o]=n[s+o];return t}interpolate_(){throw new Error("THREE.Interpolant: Call to abstract method.")}intervalChanged_(){}},Kc=class extends Ir{constructor(e,t,n,r){super(e,t,n,r),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:Rf,endingEnd:Rf}}intervalChanged_(e,t,n){let r=this.parameterPositions,s=e-2,o=e+1,a=r[s],l=r[o];if(a===void 0)switch(this.getSettings_().endingStart){case Cf:s=e,a=2*t-n;break;case If:s=r.length-2,a=t+r[s]-r[s+1];break;default:s=e,a=n}if(l===void 0)switch(this.getSettings_().endingEnd){case Cf:o=e,l=2*n-t;break;case If:o=1,l=n+r[1]-r[0];break;default:o=e-1,l=t}let c=(n-t)*.5,u=this.valueSize;this._weightPrev=c/(t-a),this._weightNext=c/(l-n),this._offsetPrev=s*u,this._offsetNext=o*u}interpolate_(e,t,n,r){let s=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,u=this._offsetPrev,h=this._offsetNext,f=this._weightPrev,d=this._weightNext,m=(n-t)/(r-t),b=m*m,g=b*m,_=-f*g+2*f*b-f*m,S=(1+f)*g+(-1.5-2*f)*b+(-.5+f)*m+1,T=(-1-d)*g+(1.5+d)*b+.5*m,M=d*g-d*b;for(let P=0;P!==a;++P)s[P]=_*o[u+P]+S*o[c+P]+T*o[l+P]+M*o[h+P];return s}},Jc=class extends Ir{constructor(e,t,n,r){super(e,t,n,r)}interpolate_(e,t,n,r){let s=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,u=(n-t)/(r-t),h=1-u;for(let f=0;f!==a;++f)s[f]=o[c+f]*h+o[l+f]*u;return s}},jc=class extends Ir{constructor(e,t,n,r){super(e,t,n,r)}interpolate_(e){return this.copySampleValue_(e-1)}},Qc=class extends Ir{interpolate_(e,t,n,r){let s=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,u=this.inTangents,h=this.outTangents;if(!u||!h){let m=(n-t)/(r-t),b=1-m;for(let g=0;g!==a;++g)s[g]=o[c+g]*b+o[l+g]*m;return s}let f=a*2,d=e-1;for(let m=0;m!==a;++m){let b=o[c+m],g=o[l+m],_=d*f+m*2,S=h[_],T=h[_+1],M=e*f+m*2,P=u[M],R=u[M+1],y=yy(n,t,S,P,r);s[m]=cg(y,b,T,R,g)}return s}};function cg(i,e,t,n,r){let s=1-i;return s*s*s*e+3*s*s*i*t+3*s*i*i*n+i*i*i*r}function vy(i,e,t,n,r){let s=1-i;return 3*s*s*(t-e)+6*s*i*(n-t)+3*i*i*(r-n)}function yy(i,e,t,n,r){let s=(i-e)/(r-e);for(let o=0;o<8;o++){let a=cg(s,e,t,n,r)-i;if(Math.abs(a)<1e-10)break;let l=vy(s,e,t,n,r);if(Math.abs(l)<1e-10)break;s=Math.max(0,Math.min(1,s-a/l))}return s}var yi=class{constructor(e,t,n,r){if(e===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(t===void 0||t.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+e);this.name=e,this.times=Ps(t,this.TimeBufferType),this.values=Ps(n,this.ValueBufferType),this.setInterpolation(r||this.DefaultInterpolation)}static toJSON(e){let t=e.constructor,n;if(t.toJSON!==this.toJSON)n=t.toJSON(e);else{n={name:e.name,times:Ps(e.times,Array),values:Ps(e.values,Array)};let r=e.getInterpolation();r!==e.DefaultInterpolation&&(n.interpolation=r),el(e.settings)&&(n.settings={inTangents:Ps(e.settings.inTangents,Array),outTangents:Ps(e.settings.outTangents,Array)})}return n.type=e.ValueTypeName,n}InterpolantFactoryMethodDiscrete(e){return new jc(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodLinear(e){return new Jc(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodSmooth(e){return new Kc(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodBezier(e){let t=new Qc(this.times,this.values,this.getValueSize(),e);return this.settings&&(t.inTangents=this.settings.inTangents,t.outTangents=this.settings.outTangents),t}setInterpolation(e){let t;switch(e){case eo:t=this.InterpolantFactoryMethodDiscrete;break;case to:t=this.InterpolantFactoryMethodLinear;break;case Nc:t=this.InterpolantFactoryMethodSmooth;break;case Ef:t=this.InterpolantFactoryMethodBezier;break}if(t===void 0){let n="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(e!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(n);return nt("KeyframeTrack:",n),this}return this.createInterpolant=t,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return eo;case this.InterpolantFactoryMethodLinear:return to;case this.InterpolantFactoryMethodSmooth:return Nc;case this.InterpolantFactoryMethodBezier:return Ef}}getValueSize(){return this.values.length/this.times.length}shift(e){if(e!==0){let t=this.times;for(let n=0,r=t.length;n!==r;++n)t[n]+=e;el(this.settings)&&(_0(this.settings.inTangents,e),_0(this.settings.outTangents,e))}return this}scale(e){if(e!==1){let t=this.times;for(let n=0,r=t.length;n!==r;++n)t[n]*=e;el(this.settings)&&(x0(this.settings.inTangents,e),x0(this.settings.outTangents,e))}return this}trim(e,t){let n=this.times,r=n.length,s=0,o=r-1;for(;s!==r&&n[s]<e;)++s;for(;o!==-1&&n[o]>t;)--o;if(++o,s!==0||o!==r){s>=o&&(o=Math.max(o,1),s=o-1);let a=this.getValueSize();this.times=n.slice(s,o),this.values=this.values.slice(s*a,o*a)}return this}validate(){let e=!0,t=this.getValueSize();t-Math.floor(t)!==0&&(_t("KeyframeTrack: Invalid value size in track.",this),e=!1);let n=this.times,r=this.values,s=n.length;s===0&&(_t("KeyframeTrack: Track is empty.",this),e=!1);let o=null;for(let a=0;a!==s;a++){let l=n[a];if(typeof l=="number"&&isNaN(l)){_t("KeyframeTrack: Time is not a valid number.",this,a,l),e=!1;break}if(o!==null&&o>l){_t("KeyframeTrack: Out of order keys.",this,a,l,o),e=!1;break}o=l}if(r!==void 0&&R1(r))for(let a=0,l=r.length;a!==l;++a){let c=r[a];if(isNaN(c)){_t("KeyframeTrack: Value is not a valid number.",this,a,c),e=!1;break}}return e}optimize(){let e=this.times.slice(),t=this.values.slice(),n=this.getValueSize(),r=this.getInterpolation()===Nc,s=e.length-1,o=1;for(let a=1;a<s;++a){let l=!1,c=e[a],u=e[a+1];if(c!==u&&(a!==1||c!==e[0]))if(r)l=!0;else{let h=a*n,f=h-n,d=h+n;for(let m=0;m!==n;++m){let b=t[h+m];if(b!==t[f+m]||b!==t[d+m]){l=!0;break}}}if(l){if(a!==o){e[o]=e[a];let h=a*n,f=o*n;for(let d=0;d!==n;++d)t[f+d]=t[h+d]}++o}}if(s>0){e[o]=e[s];for(let a=s*n,l=o*n,c=0;c!==n;++c)t[l+c]=t[a+c];++o}return o!==e.length?(this.times=e.slice(0,o),this.values=t.slice(0,o*n)):(this.times=e,this.values=t),this}clone(){let e=this.times.slice(),t=this.values.slice(),n=this.constructor,r=new n(this.name,e,t);return r.createInterpolant=this.createInterpolant,el(this.settings)&&(r.settings={inTangents:this.settings.inTangents.slice(),outTangents:this.settings.outTangents.slice()}),r}};function _0(i,e){for(let t=0,n=i.length;t!==n;t+=2)i[t]+=e}function x0(i,e){for(let t=0,n=i.length;t!==n;t+=2)i[t]*=e}yi.prototype.ValueTypeName="";yi.prototype.TimeBufferType=Float32Array;yi.prototype.ValueBufferType=Float32Array;yi.prototype.DefaultInterpolation=to;var ts=class extends yi{constructor(e,t,n){super(e,t,n)}};ts.prototype.ValueTypeName="bool";ts.prototype.ValueBufferType=Array;ts.prototype.DefaultInterpolation=eo;ts.prototype.InterpolantFactoryMethodLinear=void 0;ts.prototype.InterpolantFactoryMethodSmooth=void 0;var xl=class extends yi{constructor(e,t,n,r){super(e,t,n,r)}};xl.prototype.ValueTypeName="color";var ns=class extends yi{constructor(e,t,n,r){super(e,t,n,r)}};ns.prototype.ValueTypeName="number";var eu=class extends Ir{constructor(e,t,n,r){super(e,t,n,r)}interpolate_(e,t,n,r){let s=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=(n-t)/(r-t),c=e*a;for(let u=c+a;c!==u;c+=4)Li.slerpFlat(s,0,o,c-a,o,c,l);return s}},is=class extends yi{constructor(e,t,n,r){super(e,t,n,r)}InterpolantFactoryMethodLinear(e){return new eu(this.times,this.values,this.getValueSize(),e)}};is.prototype.ValueTypeName="quaternion";is.prototype.InterpolantFactoryMethodSmooth=void 0;var rs=class extends yi{constructor(e,t,n){super(e,t,n)}};rs.prototype.ValueTypeName="string";rs.prototype.ValueBufferType=Array;rs.prototype.DefaultInterpolation=eo;rs.prototype.InterpolantFactoryMethodLinear=void 0;rs.prototype.InterpolantFactoryMethodSmooth=void 0;var Us=class extends yi{constructor(e,t,n,r){super(e,t,n,r)}};Us.prototype.ValueTypeName="vector";var vl=class{constructor(e="",t=-1,n=[],r=$0){this.name=e,this.tracks=n,this.duration=t,this.blendMode=r,this.uuid=Nr(),this.userData={},this.duration<0&&this.resetDuration()}static parse(e){let t=[],n=e.tracks,r=1/(e.fps||1);for(let o=0,a=n.length;o!==a;++o)t.push(wy(n[o]).scale(r));let s=new this(e.name,e.duration,t,e.blendMode);return s.uuid=e.uuid,s.userData=JSON.parse(e.userData||"{}"),s}static toJSON(e){let t=[],n=e.tracks,r={name:e.name,duration:e.duration,tracks:t,uuid:e.uuid,blendMode:e.blendMode,userData:JSON.stringify(e.userData)};for(let s=0,o=n.length;s!==o;++s)t.push(yi.toJSON(n[s]));return r}static CreateFromMorphTargetSequence(e,t,n,r){let s=t.length,o=[];for(let a=0;a<s;a++){let l=[],c=[];l.push((a+s-1)%s,a,(a+1)%s),c.push(0,1,0);let u=_y(l);l=g0(l,1,u),c=g0(c,1,u),!r&&l[0]===0&&(l.push(s),c.push(c[0])),o.push(new ns(".morphTargetInfluences["+t[a].name+"]",l,c).scale(1/n))}return new this(e,-1,o)}static findByName(e,t){let n=e;if(!Array.isArray(e)){let r=e;n=r.geometry&&r.geometry.animations||r.animations}for(let r=0;r<n.length;r++)if(n[r].name===t)return n[r];return null}static CreateClipsFromMorphTargetSequences(e,t,n){let r={},s=/^([\w-]*?)([\d]+)$/;for(let a=0,l=e.length;a<l;a++){let c=e[a],u=c.name.match(s);if(u&&u.length>1){let h=u[1],f=r[h];f||(r[h]=f=[]),f.push(c)}}let o=[];for(let a in r)o.push(this.CreateFromMorphTargetSequence(a,r[a],t,n));return o}resetDuration(){let e=this.tracks,t=0;for(let n=0,r=e.length;n!==r;++n){let s=this.tracks[n];t=Math.max(t,s.times[s.times.length-1])}return this.duration=t,this}trim(){for(let e=0;e<this.tracks.length;e++)this.tracks[e].trim(0,this.duration);return this}validate(){let e=!0;for(let t=0;t<this.tracks.length;t++)e=e&&this.tracks[t].validate();return e}optimize(){for(let e=0;e<this.tracks.length;e++)this.tracks[e].optimize();return this}clone(){let e=[];for(let n=0;n<this.tracks.length;n++)e.push(this.tracks[n].clone());let t=new this.constructor(this.name,this.duration,e,this.blendMode);return t.userData=JSON.parse(JSON.stringify(this.userData)),t}toJSON(){return this.constructor.toJSON(this)}};function by(i){switch(i.toLowerCase()){case"scalar":case"double":case"float":case"number":case"integer":return ns;case"vector":case"vector2":case"vector3":case"vector4":return Us;case"color":return xl;case"quaternion":return is;case"bool":case"boolean":return ts;case"string":return rs}throw new Error("THREE.KeyframeTrack: Unsupported typeName: "+i)}function wy(i){if(i.type===void 0)throw new Error("THREE.KeyframeTrack: track type undefined, can not parse");let e=by(i.type);if(i.times===void 0){let n=[],r=[];xy(i.keys,n,r,"value"),i.times=n,i.values=r}let t;return e.parse!==void 0?t=e.parse(i):t=new e(i.name,i.times,i.values,i.interpolation),el(i.settings)&&(t.settings={inTangents:Ps(i.settings.inTangents,Float32Array),outTangents:Ps(i.settings.outTangents,Float32Array)}),t}var Mr={enabled:!1,files:{},add:function(i,e){this.enabled!==!1&&(v0(i)||(this.files[i]=e))},get:function(i){if(this.enabled!==!1&&!v0(i))return this.files[i]},remove:function(i){delete this.files[i]},clear:function(){this.files={}}};function v0(i){try{let e=i.slice(i.indexOf(":")+1);return new URL(e).protocol==="blob:"}catch{return!1}}var tu=class{constructor(e,t,n){let r=this,s=!1,o=0,a=0,l,c=[];this.onStart=void 0,this.onLoad=e,this.onProgress=t,this.onError=n,this._abortController=null,this.itemStart=function(u){a++,s===!1&&r.onStart!==void 0&&r.onStart(u,o,a),s=!0},this.itemEnd=function(u){o++,r.onProgress!==void 0&&r.onProgress(u,o,a),o===a&&(s=!1,r.onLoad!==void 0&&r.onLoad())},this.itemError=function(u){r.onError!==void 0&&r.onError(u)},this.resolveURL=function(u){return u=u.normalize("NFC"),l?l(u):u},this.setURLModifier=function(u){return l=u,this},this.addHandler=function(u,h){return c.push(u,h),this},this.removeHandler=function(u){let h=c.indexOf(u);return h!==-1&&c.splice(h,2),this},this.getHandler=function(u){for(let h=0,f=c.length;h<f;h+=2){let d=c[h],m=c[h+1];if(d.global&&(d.lastIndex=0),d.test(u))return m}return null},this.abort=function(){return this.abortController.abort(),this._abortController=null,this}}get abortController(){return this._abortController||(this._abortController=new AbortController),this._abortController}},ug=new tu,Di=class{constructor(e){this.manager=e!==void 0?e:ug,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={},this.priority="auto",this.cache="default",typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}load(){}loadAsync(e,t){let n=this;return new Promise(function(r,s){n.load(e,r,t,s)})}parse(){}setCrossOrigin(e){return this.crossOrigin=e,this}setWithCredentials(e){return this.withCredentials=e,this}setPath(e){return this.path=e,this}setResourcePath(e){return this.resourcePath=e,this}setRequestHeader(e){return this.requestHeader=e,this}setPriority(e){return this.priority=e,this}setCache(e){return this.cache=e,this}abort(){return this}};Di.DEFAULT_MATERIAL_NAME="__DEFAULT";var Zr={},Lf=class extends Error{constructor(e,t){super(e),this.response=t}},ss=class extends Di{constructor(e){super(e),this.mimeType="",this.responseType="",this._abortController=new AbortController}load(e,t,n,r){e===void 0&&(e=""),this.path!==void 0&&(e=this.path+e),e=this.manager.resolveURL(e);let s=Mr.get(`file:${e}`);if(s!==void 0){this.manager.itemStart(e),setTimeout(()=>{t&&t(s),this.manager.itemEnd(e)},0);return}if(Zr[e]!==void 0){Zr[e].push({onLoad:t,onProgress:n,onError:r});return}Zr[e]=[],Zr[e].push({onLoad:t,onProgress:n,onError:r});let o=new Request(e,{headers:new Headers(this.requestHeader),credentials:this.withCredentials?"include":"same-origin",priority:this.priority,cache:this.cache,signal:typeof AbortSignal.any=="function"?AbortSignal.any([this._abortController.signal,this.manager.abortController.signal]):this._abortController.signal}),a=this.mimeType,l=this.responseType;fetch(o).then(c=>{if(c.status===200||c.status===0){if(c.status===0&&nt("FileLoader: HTTP Status 0 received."),typeof ReadableStream>"u"||c.body===void 0||c.body.getReader===void 0)return c;let u=Zr[e],h=c.body.getReader(),f=c.headers.get("X-File-Size")||c.headers.get("Content-Length"),d=f?parseInt(f):0,m=d!==0,b=0,g=new ReadableStream({start(_){S();function S(){h.read().then(({done:T,value:M})=>{if(T)_.close();else{b+=M.byteLength;let P=new ProgressEvent("progress",{lengthComputable:m,loaded:b,total:d});for(let R=0,y=u.length;R<y;R++){let A=u[R];A.onProgress&&A.onProgress(P)}_.enqueue(M),S()}},T=>{_.error(T)})}}});return new Response(g)}else throw new Lf(`fetch for "${c.url}" responded with ${c.status}: ${c.statusText}`,c)}).then(c=>{switch(l){case"arraybuffer":return c.arrayBuffer();case"blob":return c.blob();case"document":return c.text().then(u=>new DOMParser().parseFromString(u,a));case"json":return c.json();default:if(a==="")return c.text();{let h=/charset="?([^;"\s]*)"?/i.exec(a),f=h&&h[1]?h[1].toLowerCase():void 0,d=new TextDecoder(f);return c.arrayBuffer().then(m=>d.decode(m))}}}).then(c=>{Mr.add(`file:${e}`,c);let u=Zr[e];delete Zr[e];for(let h=0,f=u.length;h<f;h++){let d=u[h];d.onLoad&&d.onLoad(c)}}).catch(c=>{let u=Zr[e];if(u===void 0)throw this.manager.itemError(e),c;delete Zr[e];for(let h=0,f=u.length;h<f;h++){let d=u[h];d.onError&&d.onError(c)}this.manager.itemError(e)}).finally(()=>{this.manager.itemEnd(e)}),this.manager.itemStart(e)}setResponseType(e){return this.responseType=e,this}setMimeType(e){return this.mimeType=e,this}abort(){return this._abortController.abort(),this._abortController=new AbortController,this}};var Xo=new WeakMap,nu=class extends Di{constructor(e){super(e)}load(e,t,n,r){this.path!==void 0&&(e=this.path+e),e=this.manager.resolveURL(e);let s=this,o=Mr.get(`image:${e}`);if(o!==void 0){if(o.complete===!0)s.manager.itemStart(e),setTimeout(function(){t&&t(o),s.manager.itemEnd(e)},0);else{let h=Xo.get(o);h===void 0&&(h=[],Xo.set(o,h)),h.push({onLoad:t,onError:r})}return o}let a=jo("img");function l(){u(),t&&t(this);let h=Xo.get(this)||[];for(let f=0;f<h.length;f++){let d=h[f];d.onLoad&&d.onLoad(this)}Xo.delete(this),s.manager.itemEnd(e)}function c(h){u(),r&&r(h),Mr.remove(`image:${e}`);let f=Xo.get(this)||[];for(let d=0;d<f.length;d++){let m=f[d];m.onError&&m.onError(h)}Xo.delete(this),s.manager.itemError(e),s.manager.itemEnd(e)}function u(){a.removeEventListener("load",l,!1),a.removeEventListener("error",c,!1)}return a.addEventListener("load",l,!1),a.addEventListener("error",c,!1),e.slice(0,5)!=="data:"&&this.crossOrigin!==void 0&&(a.crossOrigin=this.crossOrigin),Mr.add(`image:${e}`,a),s.manager.itemStart(e),a.fetchPriority=this.priority,a.src=e,a}};var ao=class extends Di{constructor(e){super(e)}load(e,t,n,r){let s=this,o=new oi,a=new ss(this.manager);return a.setPriority(this.priority),a.setCache(this.cache),a.setResponseType("arraybuffer"),a.setRequestHeader(this.requestHeader),a.setPath(this.path),a.setWithCredentials(s.withCredentials),a.load(e,function(l){let c;try{c=s.parse(l)}catch(u){r!==void 0?r(u):_t(u);return}s._applyTexData(o,c),t&&t(o,c)},n,r),o}createDataTexture(e){let t=new oi;return this._applyTexData(t,this.parse(e)),t}_applyTexData(e,t){t.image!==void 0?e.image=t.image:t.data!==void 0&&(e.image.width=t.width,e.image.height=t.height,e.image.data=t.data),e.wrapS=t.wrapS!==void 0?t.wrapS:si,e.wrapT=t.wrapT!==void 0?t.wrapT:si,e.magFilter=t.magFilter!==void 0?t.magFilter:qt,e.minFilter=t.minFilter!==void 0?t.minFilter:qt,e.anisotropy=t.anisotropy!==void 0?t.anisotropy:1,t.colorSpace!==void 0&&(e.colorSpace=t.colorSpace),t.flipY!==void 0&&(e.flipY=t.flipY),t.format!==void 0&&(e.format=t.format),t.type!==void 0&&(e.type=t.type),t.mipmaps!==void 0&&(e.mipmaps=t.mipmaps,e.minFilter=Fi),t.mipmapCount===1&&(e.minFilter=qt),t.generateMipmaps!==void 0&&(e.generateMipmaps=t.generateMipmaps),e.needsUpdate=!0}},yl=class extends Di{constructor(e){super(e)}load(e,t,n,r){let s=new $n,o=new nu(this.manager);return o.setPriority(this.priority),o.setCache(this.cache),o.setCrossOrigin(this.crossOrigin),o.setPath(this.path),o.load(e,function(a){s.image=a,s.needsUpdate=!0,t!==void 0&&t(s)},n,r),s}},aa=class extends wn{static registerNode(e){this.prototype._lightNode=e}constructor(e,t=1){super(),this.isLight=!0,this.type="Light",this.color=new ht(e),this.intensity=t}copy(e,t){return super.copy(e,t),this.color.copy(e.color),this.intensity=e.intensity,this}toJSON(e){let t=super.toJSON(e);return t.object.color=this.color.getHex(),t.object.intensity=this.intensity,t}};var Mf=new it,y0=new J,b0=new J,la=class{constructor(e){this.camera=e,this.intensity=1,this.bias=0,this.biasNode=null,this.normalBias=0,this.radius=1,this.blurSamples=8,this.mapSize=new xt(512,512),this.mapType=bi,this.map=null,this.mapPass=null,this.matrix=new it,this.autoUpdate=!0,this.needsUpdate=!1,this._frustum=new Ds,this._frameExtents=new xt(1,1),this._viewportCount=1,this._viewports=[new Ot(0,0,1,1)]}getViewportCount(){return this._viewportCount}getCamera(){return this.camera}getFrustum(){return this._frustum}updateMatrices(e){let t=this.camera;y0.setFromMatrixPosition(e.matrixWorld),t.position.copy(y0),b0.setFromMatrixPosition(e.target.matrixWorld),t.lookAt(b0),t.updateMatrixWorld(),this._updateMatrix(t,this.matrix,this._frustum)}_updateMatrix(e,t,n,r){Mf.multiplyMatrices(e.projectionMatrix,e.matrixWorldInverse),n.setFromProjectionMatrix(Mf,e.coordinateSystem,e.reversedDepth);let s=this._frameExtents,o=r?r.z/s.x:1,a=r?r.w/s.y:1,l=r?r.x/s.x:0,c=r?r.y/s.y:0;e.coordinateSystem===Jo||e.reversedDepth?t.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+c,0,0,1,0,0,0,0,1):t.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+c,0,0,.5,.5,0,0,0,1),t.multiply(Mf)}getViewport(e){return this._viewports[e]}getFrameExtents(){return this._frameExtents}dispose(){this.map&&this.map.dispose(),this.mapPass&&this.mapPass.dispose()}copy(e){return this.camera=e.camera.clone(),this.intensity=e.intensity,this.bias=e.bias,this.radius=e.radius,this.autoUpdate=e.autoUpdate,this.needsUpdate=e.needsUpdate,this.normalBias=e.normalBias,this.blurSamples=e.blurSamples,this.mapSize.copy(e.mapSize),this.mapType=e.mapType,this.biasNode=e.biasNode,this}clone(){return new this.constructor().copy(this)}toJSON(){let e={};return e.intensity=this.intensity,e.bias=this.bias,e.normalBias=this.normalBias,e.radius=this.radius,e.blurSamples=this.blurSamples,e.mapSize=this.mapSize.toArray(),e.mapType=this.mapType,e.camera=this.camera.toJSON(!1).object,delete e.camera.matrix,e}},Pc=new J,Lc=new Li,Sr=new J,lo=class extends wn{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new it,this.projectionMatrix=new it,this.projectionMatrixInverse=new it,this.coordinateSystem=Wi,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(e,t){return super.copy(e,t),this.matrixWorldInverse.copy(e.matrixWorldInverse),this.projectionMatrix.copy(e.projectionMatrix),this.projectionMatrixInverse.copy(e.projectionMatrixInverse),this.coordinateSystem=e.coordinateSystem,this}getWorldDirection(e){return super.getWorldDirection(e).negate()}updateMatrixWorld(e){super.updateMatrixWorld(e),this.matrixWorld.decompose(Pc,Lc,Sr),Sr.x===1&&Sr.y===1&&Sr.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(Pc,Lc,Sr.set(1,1,1)).invert()}updateWorldMatrix(e,t,n=!1){super.updateWorldMatrix(e,t,n),this.matrixWorld.decompose(Pc,Lc,Sr),Sr.x===1&&Sr.y===1&&Sr.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(Pc,Lc,Sr.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}},Is=new J,w0=new xt,S0=new xt,ei=class extends lo{constructor(e=50,t=1,n=.1,r=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=e,this.zoom=1,this.near=n,this.far=r,this.focus=10,this.aspect=t,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.fov=e.fov,this.zoom=e.zoom,this.near=e.near,this.far=e.far,this.focus=e.focus,this.aspect=e.aspect,this.view=e.view===null?null:Object.assign({},e.view),this.filmGauge=e.filmGauge,this.filmOffset=e.filmOffset,this}setFocalLength(e){let t=.5*this.getFilmHeight()/e;this.fov=no*2*Math.atan(t),this.updateProjectionMatrix()}getFocalLength(){let e=Math.tan(tl*.5*this.fov);return .5*this.getFilmHeight()/e}getEffectiveFOV(){return no*2*Math.atan(Math.tan(tl*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(e,t,n){Is.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),t.set(Is.x,Is.y).multiplyScalar(-e/Is.z),Is.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),n.set(Is.x,Is.y).multiplyScalar(-e/Is.z)}getViewSize(e,t){return this.getViewBounds(e,w0,S0),t.subVectors(S0,w0)}setViewOffset(e,t,n,r,s,o){this.aspect=e/t,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=n,this.view.offsetY=r,this.view.width=s,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=this.near,t=e*Math.tan(tl*.5*this.fov)/this.zoom,n=2*t,r=this.aspect*n,s=-.5*r,o=this.view;if(this.view!==null&&this.view.enabled){let l=o.fullWidth,c=o.fullHeight;s+=o.offsetX*r/l,t-=o.offsetY*n/c,r*=o.width/l,n*=o.height/c}let a=this.filmOffset;a!==0&&(s+=e*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(s,s+r,t,t-n,e,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.fov=this.fov,t.object.zoom=this.zoom,t.object.near=this.near,t.object.far=this.far,t.object.focus=this.focus,t.object.aspect=this.aspect,this.view!==null&&(t.object.view=Object.assign({},this.view)),t.object.filmGauge=this.filmGauge,t.object.filmOffset=this.filmOffset,t}},Nf=class extends la{constructor(){super(new ei(50,1,.5,500)),this.isSpotLightShadow=!0,this.focus=1,this.aspect=1}updateMatrices(e){let t=this.camera,n=no*2*e.angle*this.focus,r=this.mapSize.width/this.mapSize.height*this.aspect,s=e.distance||t.far;(n!==t.fov||r!==t.aspect||s!==t.far)&&(t.fov=n,t.aspect=r,t.far=s,t.updateProjectionMatrix()),super.updateMatrices(e)}copy(e){return super.copy(e),this.focus=e.focus,this.aspect=e.aspect,this}toJSON(){let e=super.toJSON();return e.focus=this.focus,e.aspect=this.aspect,e}},bl=class extends aa{constructor(e,t,n=0,r=Math.PI/3,s=0,o=2){super(e,t),this.isSpotLight=!0,this.type="SpotLight",this.position.copy(wn.DEFAULT_UP),this.updateMatrix(),this.target=new wn,this.distance=n,this.angle=r,this.penumbra=s,this.decay=o,this.map=null,this.shadow=new Nf}get power(){return this.intensity*Math.PI}set power(e){this.intensity=e/Math.PI}dispose(){super.dispose(),this.shadow.dispose()}copy(e,t){return super.copy(e,t),this.distance=e.distance,this.angle=e.angle,this.penumbra=e.penumbra,this.decay=e.decay,this.target=e.target.clone(),this.map=e.map,this.shadow=e.shadow.clone(),this}toJSON(e){let t=super.toJSON(e);return t.object.distance=this.distance,t.object.angle=this.angle,t.object.decay=this.decay,t.object.penumbra=this.penumbra,t.object.target=this.target.uuid,this.map&&this.map.isTexture&&(t.object.map=this.map.toJSON(e).uuid),t.object.shadow=this.shadow.toJSON(),t}},Df=class extends la{constructor(){super(new ei(90,1,.5,500)),this.isPointLightShadow=!0}},wl=class extends aa{constructor(e,t,n=0,r=2){super(e,t),this.isPointLight=!0,this.type="PointLight",this.distance=n,this.decay=r,this.shadow=new Df}get power(){return this.intensity*4*Math.PI}set power(e){this.intensity=e/(4*Math.PI)}dispose(){super.dispose(),this.shadow.dispose()}copy(e,t){return super.copy(e,t),this.distance=e.distance,this.decay=e.decay,this.shadow=e.shadow.clone(),this}toJSON(e){let t=super.toJSON(e);return t.object.distance=this.distance,t.object.decay=this.decay,t.object.shadow=this.shadow.toJSON(),t}},co=class extends lo{constructor(e=-1,t=1,n=1,r=-1,s=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=e,this.right=t,this.top=n,this.bottom=r,this.near=s,this.far=o,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.left=e.left,this.right=e.right,this.top=e.top,this.bottom=e.bottom,this.near=e.near,this.far=e.far,this.zoom=e.zoom,this.view=e.view===null?null:Object.assign({},e.view),this}setViewOffset(e,t,n,r,s,o){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=n,this.view.offsetY=r,this.view.width=s,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=(this.right-this.left)/(2*this.zoom),t=(this.top-this.bottom)/(2*this.zoom),n=(this.right+this.left)/2,r=(this.top+this.bottom)/2,s=n-e,o=n+e,a=r+t,l=r-t;if(this.view!==null&&this.view.enabled){let c=(this.right-this.left)/this.view.fullWidth/this.zoom,u=(this.top-this.bottom)/this.view.fullHeight/this.zoom;s+=c*this.view.offsetX,o=s+c*this.view.width,a-=u*this.view.offsetY,l=a-u*this.view.height}this.projectionMatrix.makeOrthographic(s,o,a,l,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.zoom=this.zoom,t.object.left=this.left,t.object.right=this.right,t.object.top=this.top,t.object.bottom=this.bottom,t.object.near=this.near,t.object.far=this.far,this.view!==null&&(t.object.view=Object.assign({},this.view)),t}},Ff=class extends la{constructor(){super(new co(-5,5,5,-5,.5,500)),this.isDirectionalLightShadow=!0}},Sl=class extends aa{constructor(e,t){super(e,t),this.isDirectionalLight=!0,this.type="DirectionalLight",this.position.copy(wn.DEFAULT_UP),this.updateMatrix(),this.target=new wn,this.shadow=new Ff}dispose(){super.dispose(),this.shadow.dispose()}copy(e){return super.copy(e),this.target=e.target.clone(),this.shadow=e.shadow.clone(),this}toJSON(e){let t=super.toJSON(e);return t.object.shadow=this.shadow.toJSON(),t.object.target=this.target.uuid,t}};var os=class{static extractUrlBase(e){let t=e.lastIndexOf("/");return t===-1?"./":e.slice(0,t+1)}static resolveURL(e,t){return typeof e!="string"||e===""?"":(/^https?:\/\//i.test(t)&&/^\//.test(e)&&(t=t.replace(/(^https?:\/\/[^\/]+).*/i,"$1")),/^(https?:)?\/\//i.test(e)||/^data:.*,.*$/i.test(e)||/^blob:.*$/i.test(e)?e:t+e)}};var Tf=new WeakMap,Ml=class extends Di{constructor(e){super(e),this.isImageBitmapLoader=!0,typeof createImageBitmap>"u"&&nt("ImageBitmapLoader: createImageBitmap() not supported."),typeof fetch>"u"&&nt("ImageBitmapLoader: fetch() not supported."),this.options={premultiplyAlpha:"none"},this._abortController=new AbortController}setOptions(e){return this.options=e,this}load(e,t,n,r){e===void 0&&(e=""),this.path!==void 0&&(e=this.path+e),e=this.manager.resolveURL(e);let s=this,o=Mr.get(`image-bitmap:${e}`);if(o!==void 0){if(s.manager.itemStart(e),o.then){o.then(c=>{Tf.has(o)===!0?(r&&r(Tf.get(o)),s.manager.itemError(e),s.manager.itemEnd(e)):(t&&t(c),s.manager.itemEnd(e))});return}setTimeout(function(){t&&t(o),s.manager.itemEnd(e)},0);return}let a={};a.credentials=this.withCredentials||this.crossOrigin!=="anonymous"?"include":"same-origin",a.headers=this.requestHeader,a.priority=this.priority,a.cache=this.cache,a.signal=typeof AbortSignal.any=="function"?AbortSignal.any([this._abortController.signal,this.manager.abortController.signal]):this._abortController.signal;let l=fetch(e,a).then(function(c){return c.blob()}).then(function(c){return createImageBitmap(c,Object.assign({},s.options,{colorSpaceConversion:"none"}))}).then(function(c){return Mr.add(`image-bitmap:${e}`,c),t&&t(c),s.manager.itemEnd(e),c}).catch(function(c){r&&r(c),Tf.set(l,c),Mr.remove(`image-bitmap:${e}`),s.manager.itemError(e),s.manager.itemEnd(e)});Mr.add(`image-bitmap:${e}`,l),s.manager.itemStart(e)}abort(){return this._abortController.abort(),this._abortController=new AbortController,this}};var qo=-90,Yo=1,ca=class extends wn{constructor(e,t,n){super(),this.type="CubeCamera",this.renderTarget=n,this.coordinateSystem=null,this.activeMipmapLevel=0;let r=new ei(qo,Yo,e,t);r.layers=this.layers,this.add(r);let s=new ei(qo,Yo,e,t);s.layers=this.layers,this.add(s);let o=new ei(qo,Yo,e,t);o.layers=this.layers,this.add(o);let a=new ei(qo,Yo,e,t);a.layers=this.layers,this.add(a);let l=new ei(qo,Yo,e,t);l.layers=this.layers,this.add(l);let c=new ei(qo,Yo,e,t);c.layers=this.layers,this.add(c)}updateCoordinateSystem(){let e=this.coordinateSystem,t=this.children.concat(),[n,r,s,o,a,l]=t;for(let c of t)this.remove(c);if(e===Wi)n.up.set(0,1,0),n.lookAt(1,0,0),r.up.set(0,1,0),r.lookAt(-1,0,0),s.up.set(0,0,-1),s.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),l.up.set(0,1,0),l.lookAt(0,0,-1);else if(e===Jo)n.up.set(0,-1,0),n.lookAt(-1,0,0),r.up.set(0,-1,0),r.lookAt(1,0,0),s.up.set(0,0,1),s.lookAt(0,1,0),o.up.set(0,0,-1),o.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),l.up.set(0,-1,0),l.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+e);for(let c of t)this.add(c),c.updateMatrixWorld()}update(e,t){this.parent===null&&this.updateMatrixWorld();let{renderTarget:n,activeMipmapLevel:r}=this;this.coordinateSystem!==e.coordinateSystem&&(this.coordinateSystem=e.coordinateSystem,this.updateCoordinateSystem());let[s,o,a,l,c,u]=this.children,h=e.getRenderTarget(),f=e.getActiveCubeFace(),d=e.getActiveMipmapLevel(),m=e.xr.enabled;e.xr.enabled=!1;let b=n.texture.mipmapsAutoUpdate;n.texture.mipmapsAutoUpdate=!1;let g=!1;e.isWebGLRenderer===!0?g=e.state.buffers.depth.getReversed():g=e.reversedDepthBuffer,e.setRenderTarget(n,0,r),g&&e.autoClear===!1&&e.clearDepth(),e.render(t,s),e.setRenderTarget(n,1,r),g&&e.autoClear===!1&&e.clearDepth(),e.render(t,o),e.setRenderTarget(n,2,r),g&&e.autoClear===!1&&e.clearDepth(),e.render(t,a),e.setRenderTarget(n,3,r),g&&e.autoClear===!1&&e.clearDepth(),e.render(t,l),e.setRenderTarget(n,4,r),g&&e.autoClear===!1&&e.clearDepth(),e.render(t,c),n.texture.mipmapsAutoUpdate=b,e.setRenderTarget(n,5,r),g&&e.autoClear===!1&&e.clearDepth(),e.render(t,u),e.setRenderTarget(h,f,d),e.xr.enabled=m,n.texture.needsPMREMUpdate=!0}},iu=class extends ei{constructor(e=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=e,this.perCameraFrustumCulled=!1}};var pd="\\[\\]\\.:\\/",Sy=new RegExp("["+pd+"]","g"),md="[^"+pd+"]",My="[^"+pd.replace("\\.","")+"]",Ty=/((?:WC+[\/:])*)/.source.replace("WC",md),Ay=/(WCOD+)?/.source.replace("WCOD",My),Ey=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",md),Ry=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",md),Cy=new RegExp("^"+Ty+Ay+Ey+Ry+"$"),Iy=["material","materials","bones","map"],Uf=class{constructor(e,t,n){let r=n||rn.parseTrackName(t);this._targetGroup=e,this._bindings=e.subscribe_(t,r)}getValue(e,t){this.bind();let n=this._targetGroup.nCachedObjects_,r=this._bindings[n];r!==void 0&&r.getValue(e,t)}setValue(e,t){let n=this._bindings;for(let r=this._targetGroup.nCachedObjects_,s=n.length;r!==s;++r)n[r].setValue(e,t)}bind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,n=e.length;t!==n;++t)e[t].bind()}unbind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,n=e.length;t!==n;++t)e[t].unbind()}},rn=class i{constructor(e,t,n){this.path=t,this.parsedPath=n||i.parseTrackName(t),this.node=i.findNode(e,this.parsedPath.nodeName),this.rootNode=e,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(e,t,n){return e&&e.isAnimationObjectGroup?new i.Composite(e,t,n):new i(e,t,n)}static sanitizeNodeName(e){return e.replace(/\s/g,"_").replace(Sy,"")}static parseTrackName(e){let t=Cy.exec(e);if(t===null)throw new Error("THREE.PropertyBinding: Cannot parse trackName: "+e);let n={nodeName:t[2],objectName:t[3],objectIndex:t[4],propertyName:t[5],propertyIndex:t[6]},r=n.nodeName&&n.nodeName.lastIndexOf(".");if(r!==void 0&&r!==-1){let s=n.nodeName.substring(r+1);Iy.indexOf(s)!==-1&&(n.nodeName=n.nodeName.substring(0,r),n.objectName=s)}if(n.propertyName===null||n.propertyName.length===0)throw new Error("THREE.PropertyBinding: can not parse propertyName from trackName: "+e);return n}static findNode(e,t){if(t===void 0||t===""||t==="."||t===-1||t===e.name||t===e.uuid)return e;if(e.skeleton){let n=e.skeleton.getBoneByName(t);if(n!==void 0)return n}if(e.children){let n=function(s){for(let o=0;o<s.length;o++){let a=s[o];if(a.name===t||a.uuid===t)return a;let l=n(a.children);if(l)return l}return null},r=n(e.children);if(r)return r}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(e,t){e[t]=this.targetObject[this.propertyName]}_getValue_array(e,t){let n=this.resolvedProperty;for(let r=0,s=n.length;r!==s;++r)e[t++]=n[r]}_getValue_arrayElement(e,t){e[t]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(e,t){this.resolvedProperty.toArray(e,t)}_setValue_direct(e,t){this.targetObject[this.propertyName]=e[t]}_setValue_direct_setNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(e,t){let n=this.resolvedProperty;for(let r=0,s=n.length;r!==s;++r)n[r]=e[t++]}_setValue_array_setNeedsUpdate(e,t){let n=this.resolvedProperty;for(let r=0,s=n.length;r!==s;++r)n[r]=e[t++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(e,t){let n=this.resolvedProperty;for(let r=0,s=n.length;r!==s;++r)n[r]=e[t++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(e,t){this.resolvedProperty[this.propertyIndex]=e[t]}_setValue_arrayElement_setNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(e,t){this.resolvedProperty.fromArray(e,t)}_setValue_fromArray_setNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(e,t){this.bind(),this.getValue(e,t)}_setValue_unbound(e,t){this.bind(),this.setValue(e,t)}bind(){let e=this.node,t=this.parsedPath,n=t.objectName,r=t.propertyName,s=t.propertyIndex;if(e||(e=i.findNode(this.rootNode,t.nodeName),this.node=e),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!e){nt("PropertyBinding: No target node found for track: "+this.path+".");return}if(n){let c=t.objectIndex;switch(n){case"materials":if(!e.material){_t("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.materials){_t("PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}e=e.material.materials;break;case"bones":if(!e.skeleton){_t("PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}e=e.skeleton.bones;for(let u=0;u<e.length;u++)if(e[u].name===c){c=u;break}break;case"map":if("map"in e){e=e.map;break}if(!e.material){_t("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.map){_t("PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}e=e.material.map;break;default:if(e[n]===void 0){_t("PropertyBinding: Can not bind to objectName of node undefined.",this);return}e=e[n]}if(c!==void 0){if(e[c]===void 0){_t("PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,e);return}e=e[c]}}let o=e[r];if(o===void 0){let c=t.nodeName;_t("PropertyBinding: Trying to update property for track: "+c+"."+r+" but it wasn't found.",e);return}let a=this.Versioning.None;this.targetObject=e,e.isMaterial===!0?a=this.Versioning.NeedsUpdate:e.isObject3D===!0&&(a=this.Versioning.MatrixWorldNeedsUpdate);let l=this.BindingType.Direct;if(s!==void 0){if(r==="morphTargetInfluences"){if(!e.geometry){_t("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!e.geometry.morphAttributes){_t("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}e.morphTargetDictionary[s]!==void 0&&(s=e.morphTargetDictionary[s])}l=this.BindingType.ArrayElement,this.resolvedProperty=o,this.propertyIndex=s}else o.fromArray!==void 0&&o.toArray!==void 0?(l=this.BindingType.HasFromToArray,this.resolvedProperty=o):Array.isArray(o)?(l=this.BindingType.EntireArray,this.resolvedProperty=o):this.propertyName=r;this.getValue=this.GetterByBindingType[l],this.setValue=this.SetterByBindingTypeAndVersioning[l][a]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};rn.Composite=Uf;rn.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};rn.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};rn.prototype.GetterByBindingType=[rn.prototype._getValue_direct,rn.prototype._getValue_array,rn.prototype._getValue_arrayElement,rn.prototype._getValue_toArray];rn.prototype.SetterByBindingTypeAndVersioning=[[rn.prototype._setValue_direct,rn.prototype._setValue_direct_setNeedsUpdate,rn.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[rn.prototype._setValue_array,rn.prototype._setValue_array_setNeedsUpdate,rn.prototype._setValue_array_setMatrixWorldNeedsUpdate],[rn.prototype._setValue_arrayElement,rn.prototype._setValue_arrayElement_setNeedsUpdate,rn.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[rn.prototype._setValue_fromArray,rn.prototype._setValue_fromArray_setNeedsUpdate,rn.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var VE=new Float32Array(1);var Of=class{static{this.prototype.isMatrix2=!0}constructor(e,t,n,r){this.elements=[1,0,0,1],e!==void 0&&this.set(e,t,n,r)}identity(){return this.set(1,0,0,1),this}fromArray(e,t=0){for(let n=0;n<4;n++)this.elements[n]=e[n+t];return this}set(e,t,n,r){let s=this.elements;return s[0]=e,s[2]=t,s[1]=n,s[3]=r,this}};function gd(i,e,t,n){let r=Py(n);switch(t){case nd:return i*e;case ls:return i*e/r.components*r.byteLength;case hu:return i*e/r.components*r.byteLength;case ai:return i*e*2/r.components*r.byteLength;case fu:return i*e*2/r.components*r.byteLength;case id:return i*e*3/r.components*r.byteLength;case jt:return i*e*4/r.components*r.byteLength;case du:return i*e*4/r.components*r.byteLength;case Al:case El:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*8;case Rl:case Cl:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*16;case mu:case _u:return Math.max(i,16)*Math.max(e,8)/4;case pu:case gu:return Math.max(i,8)*Math.max(e,8)/2;case xu:case vu:case bu:case wu:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*8;case yu:case Il:case Su:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*16;case Mu:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*16;case Tu:return Math.floor((i+4)/5)*Math.floor((e+3)/4)*16;case Au:return Math.floor((i+4)/5)*Math.floor((e+4)/5)*16;case Eu:return Math.floor((i+5)/6)*Math.floor((e+4)/5)*16;case Ru:return Math.floor((i+5)/6)*Math.floor((e+5)/6)*16;case Cu:return Math.floor((i+7)/8)*Math.floor((e+4)/5)*16;case Iu:return Math.floor((i+7)/8)*Math.floor((e+5)/6)*16;case Pu:return Math.floor((i+7)/8)*Math.floor((e+7)/8)*16;case Lu:return Math.floor((i+9)/10)*Math.floor((e+4)/5)*16;case Nu:return Math.floor((i+9)/10)*Math.floor((e+5)/6)*16;case Du:return Math.floor((i+9)/10)*Math.floor((e+7)/8)*16;case Fu:return Math.floor((i+9)/10)*Math.floor((e+9)/10)*16;case Uu:return Math.floor((i+11)/12)*Math.floor((e+9)/10)*16;case Ou:return Math.floor((i+11)/12)*Math.floor((e+11)/12)*16;case Bu:case zu:case ku:return Math.ceil(i/4)*Math.ceil(e/4)*16;case Vu:case Hu:return Math.ceil(i/4)*Math.ceil(e/4)*8;case Pl:case Gu:return Math.ceil(i/4)*Math.ceil(e/4)*16}throw new Error(`Unable to determine texture byte length for ${t} format.`)}function Py(i){switch(i){case bi:case jf:return{byteLength:1,components:1};case pa:case Qf:case tn:return{byteLength:2,components:1};case cu:case uu:return{byteLength:2,components:4};case ur:case lu:case Nt:return{byteLength:4,components:1};case ed:case td:return{byteLength:4,components:3}}throw new Error(`THREE.TextureUtils: Unknown texture type ${i}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"187"}}));typeof window<"u"&&(window.__THREE__?nt("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="187");function Lg(){let i=null,e=!1,t=null,n=null;function r(s,o){n=i.requestAnimationFrame(r),t(s,o)}return{start:function(){e!==!0&&t!==null&&i!==null&&(n=i.requestAnimationFrame(r),e=!0)},stop:function(){i!==null&&i.cancelAnimationFrame(n),e=!1},setAnimationLoop:function(s){t=s},setContext:function(s){i=s}}}function Ny(i){let e=new WeakMap;function t(a,l){let c=a.array,u=a.usage,h=c.byteLength,f=i.createBuffer();i.bindBuffer(l,f),i.bufferData(l,c,u),a.onUploadCallback();let d;if(c instanceof Float32Array)d=i.FLOAT;else if(typeof Float16Array<"u"&&c instanceof Float16Array)d=i.HALF_FLOAT;else if(c instanceof Uint16Array)a.isFloat16BufferAttribute?d=i.HALF_FLOAT:d=i.UNSIGNED_SHORT;else if(c instanceof Int16Array)d=i.SHORT;else if(c instanceof Uint32Array)d=i.UNSIGNED_INT;else if(c instanceof Int32Array)d=i.INT;else if(c instanceof Int8Array)d=i.BYTE;else if(c instanceof Uint8Array)d=i.UNSIGNED_BYTE;else if(c instanceof Uint8ClampedArray)d=i.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+c);return{buffer:f,type:d,bytesPerElement:c.BYTES_PER_ELEMENT,version:a.version,size:h}}function n(a,l,c){let u=l.array,h=l.updateRanges;if(i.bindBuffer(c,a),h.length===0)i.bufferSubData(c,0,u);else{h.sort((d,m)=>d.start-m.start);let f=0;for(let d=1;d<h.length;d++){let m=h[f],b=h[d];b.start<=m.start+m.count+1?m.count=Math.max(m.count,b.start+b.count-m.start):(++f,h[f]=b)}h.length=f+1;for(let d=0,m=h.length;d<m;d++){let b=h[d];i.bufferSubData(c,b.start*u.BYTES_PER_ELEMENT,u,b.start,b.count)}l.clearUpdateRanges()}l.onUploadCallback()}function r(a){return a.isInterleavedBufferAttribute&&(a=a.data),e.get(a)}function s(a){a.isInterleavedBufferAttribute&&(a=a.data);let l=e.get(a);l&&(i.deleteBuffer(l.buffer),e.delete(a))}function o(a,l){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){let u=e.get(a);(!u||u.version<a.version)&&e.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}let c=e.get(a);if(c===void 0)e.set(a,t(a,l));else if(c.version<a.version){if(c.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");n(c.buffer,a,l),c.version=a.version}}return{get:r,remove:s,update:o}}var Dy=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,Fy=`#ifdef USE_ALPHAHASH
	const float ALPHA_HASH_SCALE = 0.05;
	float hash2D( vec2 value ) {
		return fract( 1.0e4 * sin( 17.0 * value.x + 0.1 * value.y ) * ( 0.1 + abs( sin( 13.0 * value.y + value.x ) ) ) );
	}
	float hash3D( vec3 value ) {
		return hash2D( vec2( hash2D( value.xy ), value.z ) );
	}
	float getAlphaHashThreshold( vec3 position ) {
		float maxDeriv = max(
			length( dFdx( position.xyz ) ),
			length( dFdy( position.xyz ) )
		);
		float pixScale = 1.0 / ( ALPHA_HASH_SCALE * maxDeriv );
		vec2 pixScales = vec2(
			exp2( floor( log2( pixScale ) ) ),
			exp2( ceil( log2( pixScale ) ) )
		);
		vec2 alpha = vec2(
			hash3D( floor( pixScales.x * position.xyz ) ),
			hash3D( floor( pixScales.y * position.xyz ) )
		);
		float lerpFactor = fract( log2( pixScale ) );
		float x = ( 1.0 - lerpFactor ) * alpha.x + lerpFactor * alpha.y;
		float a = min( lerpFactor, 1.0 - lerpFactor );
		vec3 cases = vec3(
			x * x / ( 2.0 * a * ( 1.0 - a ) ),
			( x - 0.5 * a ) / ( 1.0 - a ),
			1.0 - ( ( 1.0 - x ) * ( 1.0 - x ) / ( 2.0 * a * ( 1.0 - a ) ) )
		);
		float threshold = ( x < ( 1.0 - a ) )
			? ( ( x < a ) ? cases.x : cases.y )
			: cases.z;
		return clamp( threshold , 1.0e-6, 1.0 );
	}
#endif`,Uy=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,Oy=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,By=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,zy=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,ky=`#ifdef USE_AOMAP
	float ambientOcclusion = ( texture2D( aoMap, vAoMapUv ).r - 1.0 ) * aoMapIntensity + 1.0;
	reflectedLight.indirectDiffuse *= ambientOcclusion;
	#if defined( USE_CLEARCOAT ) 
		clearcoatSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_SHEEN ) 
		sheenSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_ENVMAP ) && defined( STANDARD )
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		reflectedLight.indirectSpecular *= computeSpecularOcclusion( dotNV, ambientOcclusion, material.roughness );
	#endif
#endif`,Vy=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,Hy=`#ifdef USE_BATCHING
	#if ! defined( GL_ANGLE_multi_draw )
	#define gl_DrawID _gl_DrawID
	uniform int _gl_DrawID;
	#endif
	uniform highp sampler2D batchingTexture;
	uniform highp usampler2D batchingIdTexture;
	mat4 getBatchingMatrix( const in float i ) {
		int size = textureSize( batchingTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( batchingTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( batchingTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( batchingTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( batchingTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
	float getIndirectIndex( const in int i ) {
		int size = textureSize( batchingIdTexture, 0 ).x;
		int x = i % size;
		int y = i / size;
		return float( texelFetch( batchingIdTexture, ivec2( x, y ), 0 ).r );
	}
#endif
#ifdef USE_BATCHING_COLOR
	uniform sampler2D batchingColorTexture;
	vec4 getBatchingColor( const in float i ) {
		int size = textureSize( batchingColorTexture, 0 ).x;
		int j = int( i );
		int x = j % size;
		int y = j / size;
		return texelFetch( batchingColorTexture, ivec2( x, y ), 0 );
	}
#endif`,Gy=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,Wy=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,Xy=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,qy=`float G_BlinnPhong_Implicit( ) {
	return 0.25;
}
float D_BlinnPhong( const in float shininess, const in float dotNH ) {
	return RECIPROCAL_PI * ( shininess * 0.5 + 1.0 ) * pow( dotNH, shininess );
}
vec3 BRDF_BlinnPhong( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 specularColor, const in float shininess ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( specularColor, 1.0, dotVH );
	float G = G_BlinnPhong_Implicit( );
	float D = D_BlinnPhong( shininess, dotNH );
	return F * ( G * D );
} // validated`,Yy=`#ifdef USE_IRIDESCENCE
	const mat3 XYZ_TO_REC709 = mat3(
		 3.2404542, -0.9692660,  0.0556434,
		-1.5371385,  1.8760108, -0.2040259,
		-0.4985314,  0.0415560,  1.0572252
	);
	vec3 Fresnel0ToIor( vec3 fresnel0 ) {
		vec3 sqrtF0 = sqrt( fresnel0 );
		return ( vec3( 1.0 ) + sqrtF0 ) / ( vec3( 1.0 ) - sqrtF0 );
	}
	vec3 IorToFresnel0( vec3 transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - vec3( incidentIor ) ) / ( transmittedIor + vec3( incidentIor ) ) );
	}
	float IorToFresnel0( float transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - incidentIor ) / ( transmittedIor + incidentIor ));
	}
	vec3 evalSensitivity( float OPD, vec3 shift ) {
		float phase = 2.0 * PI * OPD * 1.0e-9;
		vec3 val = vec3( 5.4856e-13, 4.4201e-13, 5.2481e-13 );
		vec3 pos = vec3( 1.6810e+06, 1.7953e+06, 2.2084e+06 );
		vec3 var = vec3( 4.3278e+09, 9.3046e+09, 6.6121e+09 );
		vec3 xyz = val * sqrt( 2.0 * PI * var ) * cos( pos * phase + shift ) * exp( - pow2( phase ) * var );
		xyz.x += 9.7470e-14 * sqrt( 2.0 * PI * 4.5282e+09 ) * cos( 2.2399e+06 * phase + shift[ 0 ] ) * exp( - 4.5282e+09 * pow2( phase ) );
		xyz /= 1.0685e-7;
		vec3 rgb = XYZ_TO_REC709 * xyz;
		return rgb;
	}
	vec3 evalIridescence( float outsideIOR, float eta2, float cosTheta1, float thinFilmThickness, vec3 baseF0 ) {
		vec3 I;
		float iridescenceIOR = mix( outsideIOR, eta2, smoothstep( 0.0, 0.03, thinFilmThickness ) );
		float sinTheta2Sq = pow2( outsideIOR / iridescenceIOR ) * ( 1.0 - pow2( cosTheta1 ) );
		float cosTheta2Sq = 1.0 - sinTheta2Sq;
		if ( cosTheta2Sq < 0.0 ) {
			return vec3( 1.0 );
		}
		float cosTheta2 = sqrt( cosTheta2Sq );
		float R0 = IorToFresnel0( iridescenceIOR, outsideIOR );
		float R12 = F_Schlick( R0, 1.0, cosTheta1 );
		float T121 = 1.0 - R12;
		float phi12 = 0.0;
		if ( iridescenceIOR < outsideIOR ) phi12 = PI;
		float phi21 = PI - phi12;
		vec3 baseIOR = Fresnel0ToIor( clamp( baseF0, 0.0, 0.9999 ) );		vec3 R1 = IorToFresnel0( baseIOR, iridescenceIOR );
		vec3 R23 = F_Schlick( R1, 1.0, cosTheta2 );
		vec3 phi23 = vec3( 0.0 );
		if ( baseIOR[ 0 ] < iridescenceIOR ) phi23[ 0 ] = PI;
		if ( baseIOR[ 1 ] < iridescenceIOR ) phi23[ 1 ] = PI;
		if ( baseIOR[ 2 ] < iridescenceIOR ) phi23[ 2 ] = PI;
		float OPD = 2.0 * iridescenceIOR * thinFilmThickness * cosTheta2;
		vec3 phi = vec3( phi21 ) + phi23;
		vec3 R123 = clamp( R12 * R23, 1e-5, 0.9999 );
		vec3 r123 = sqrt( R123 );
		vec3 Rs = pow2( T121 ) * R23 / ( vec3( 1.0 ) - R123 );
		vec3 C0 = R12 + Rs;
		I = C0;
		vec3 Cm = Rs - T121;
		for ( int m = 1; m <= 2; ++ m ) {
			Cm *= r123;
			vec3 Sm = 2.0 * evalSensitivity( float( m ) * OPD, float( m ) * phi );
			I += Cm * Sm;
		}
		return max( I, vec3( 0.0 ) );
	}
#endif`,$y=`#ifdef USE_BUMPMAP
	uniform sampler2D bumpMap;
	uniform float bumpScale;
	vec2 dHdxy_fwd() {
		vec2 dSTdx = dFdx( vBumpMapUv );
		vec2 dSTdy = dFdy( vBumpMapUv );
		float Hll = bumpScale * texture2D( bumpMap, vBumpMapUv ).x;
		float dBx = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdx ).x - Hll;
		float dBy = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdy ).x - Hll;
		return vec2( dBx, dBy );
	}
	vec3 perturbNormalArb( vec3 surf_pos, vec3 surf_norm, vec2 dHdxy, float faceDirection ) {
		vec3 vSigmaX = normalize( dFdx( surf_pos.xyz ) );
		vec3 vSigmaY = normalize( dFdy( surf_pos.xyz ) );
		vec3 vN = surf_norm;
		vec3 R1 = cross( vSigmaY, vN );
		vec3 R2 = cross( vN, vSigmaX );
		float fDet = dot( vSigmaX, R1 ) * faceDirection;
		vec3 vGrad = sign( fDet ) * ( dHdxy.x * R1 + dHdxy.y * R2 );
		return normalize( abs( fDet ) * surf_norm - vGrad );
	}
#endif`,Zy=`#if NUM_CLIPPING_PLANES > 0
	vec4 plane;
	#ifdef ALPHA_TO_COVERAGE
		float distanceToPlane, distanceGradient;
		float clipOpacity = 1.0;
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
			distanceGradient = fwidth( distanceToPlane ) / 2.0;
			clipOpacity *= smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			if ( clipOpacity == 0.0 ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			float unionClipOpacity = 1.0;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
				distanceGradient = fwidth( distanceToPlane ) / 2.0;
				unionClipOpacity *= 1.0 - smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			}
			#pragma unroll_loop_end
			clipOpacity *= 1.0 - unionClipOpacity;
		#endif
		diffuseColor.a *= clipOpacity;
		if ( diffuseColor.a == 0.0 ) discard;
	#else
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			if ( dot( vClipPosition, plane.xyz ) > plane.w ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			bool clipped = true;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				clipped = ( dot( vClipPosition, plane.xyz ) > plane.w ) && clipped;
			}
			#pragma unroll_loop_end
			if ( clipped ) discard;
		#endif
	#endif
#endif`,Ky=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,Jy=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,jy=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,Qy=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#endif`,eb=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#endif`,tb=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec4 vColor;
#endif`,nb=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	vColor = vec4( 1.0 );
#endif
#ifdef USE_COLOR_ALPHA
	vColor *= color;
#elif defined( USE_COLOR )
	vColor.rgb *= color;
#endif
#ifdef USE_INSTANCING_COLOR
	vColor.rgb *= instanceColor.rgb;
#endif
#ifdef USE_BATCHING_COLOR
	vColor *= getBatchingColor( getIndirectIndex( gl_DrawID ) );
#endif`,ib=`#define PI 3.141592653589793
#define PI2 6.283185307179586
#define PI_HALF 1.5707963267948966
#define RECIPROCAL_PI 0.3183098861837907
#define RECIPROCAL_PI2 0.15915494309189535
#define EPSILON 1e-6
#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
#define whiteComplement( a ) ( 1.0 - saturate( a ) )
float pow2( const in float x ) { return x*x; }
vec3 pow2( const in vec3 x ) { return x*x; }
float pow3( const in float x ) { return x*x*x; }
float pow4( const in float x ) { float x2 = x*x; return x2*x2; }
float max3( const in vec3 v ) { return max( max( v.x, v.y ), v.z ); }
float average( const in vec3 v ) { return dot( v, vec3( 0.3333333 ) ); }
highp float rand( const in vec2 uv ) {
	const highp float a = 12.9898, b = 78.233, c = 43758.5453;
	highp float dt = dot( uv.xy, vec2( a,b ) ), sn = mod( dt, PI );
	return fract( sin( sn ) * c );
}
#ifdef HIGH_PRECISION
	float precisionSafeLength( vec3 v ) { return length( v ); }
#else
	float precisionSafeLength( vec3 v ) {
		float maxComponent = max3( abs( v ) );
		return length( v / maxComponent ) * maxComponent;
	}
#endif
struct IncidentLight {
	vec3 color;
	vec3 direction;
	bool visible;
};
struct ReflectedLight {
	vec3 directDiffuse;
	vec3 directSpecular;
	vec3 indirectDiffuse;
	vec3 indirectSpecular;
};
#ifdef USE_ALPHAHASH
	varying vec3 vPosition;
#endif
vec3 transformDirection( in vec3 dir, in mat4 matrix ) {
	return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );
}
#define inverseTransformDirection transformDirectionByInverseViewMatrix
vec3 transformNormalByInverseViewMatrix( in vec3 normal, in mat4 viewMatrix ) {
	return normalize( ( vec4( normal, 0.0 ) * viewMatrix ).xyz );
}
vec3 transformDirectionByInverseViewMatrix( in vec3 dir, in mat4 viewMatrix ) {
	return normalize( ( vec4( dir, 0.0 ) * viewMatrix ).xyz );
}
bool isPerspectiveMatrix( mat4 m ) {
	return m[ 2 ][ 3 ] == - 1.0;
}
vec2 equirectUv( in vec3 dir ) {
	float u = atan( dir.z, dir.x ) * RECIPROCAL_PI2 + 0.5;
	float v = asin( clamp( dir.y, - 1.0, 1.0 ) ) * RECIPROCAL_PI + 0.5;
	return vec2( u, v );
}
vec3 BRDF_Lambert( const in vec3 diffuseColor ) {
	return RECIPROCAL_PI * diffuseColor;
}
vec3 F_Schlick( const in vec3 f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
}
float F_Schlick( const in float f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
} // validated`,rb=`vec3 transformedNormal = objectNormal;
#ifdef USE_TANGENT
	vec3 transformedTangent = objectTangent;
#endif
#ifdef USE_BATCHING
	mat3 bm = mat3( batchingMatrix );
	transformedNormal /= vec3( dot( bm[ 0 ], bm[ 0 ] ), dot( bm[ 1 ], bm[ 1 ] ), dot( bm[ 2 ], bm[ 2 ] ) );
	transformedNormal = bm * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = bm * transformedTangent;
	#endif
#endif
#ifdef USE_INSTANCING
	mat3 im = mat3( instanceMatrix );
	transformedNormal /= vec3( dot( im[ 0 ], im[ 0 ] ), dot( im[ 1 ], im[ 1 ] ), dot( im[ 2 ], im[ 2 ] ) );
	transformedNormal = im * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = im * transformedTangent;
	#endif
#endif
transformedNormal = normalMatrix * transformedNormal;
#ifdef FLIP_SIDED
	transformedNormal = - transformedNormal;
#endif
#ifdef USE_TANGENT
	transformedTangent = ( modelViewMatrix * vec4( transformedTangent, 0.0 ) ).xyz;
#endif`,sb=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,ob=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,ab=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,lb=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,cb="gl_FragColor = linearToOutputTexel( gl_FragColor );",ub=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,hb=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vec3 cameraToFrag;
		if ( isOrthographic ) {
			cameraToFrag = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToFrag = normalize( vWorldPosition - cameraPosition );
		}
		vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vec3 reflectVec = reflect( cameraToFrag, worldNormal );
		#else
			vec3 reflectVec = refract( cameraToFrag, worldNormal, refractionRatio );
		#endif
	#else
		vec3 reflectVec = vReflect;
	#endif
	#ifdef ENVMAP_TYPE_CUBE
		vec4 envColor = textureCube( envMap, envMapRotation * reflectVec );
		#ifdef ENVMAP_BLENDING_MULTIPLY
			outgoingLight = mix( outgoingLight, outgoingLight * envColor.xyz, specularStrength * reflectivity );
		#elif defined( ENVMAP_BLENDING_MIX )
			outgoingLight = mix( outgoingLight, envColor.xyz, specularStrength * reflectivity );
		#elif defined( ENVMAP_BLENDING_ADD )
			outgoingLight += envColor.xyz * specularStrength * reflectivity;
		#endif
	#endif
#endif`,fb=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform mat3 envMapRotation;
	uniform samplerCube envMap;
	#ifdef ENVMAP_TYPE_PMREM
		float roughnessToMip( const in float roughness ) {
			float r = clamp( roughness, 0.0, 1.0 );
			return ENVMAP_MAX_LOD * r * ( 2.0 - r );
		}
	#endif
#endif`,db=`#ifdef USE_ENVMAP
	uniform float reflectivity;
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		varying vec3 vWorldPosition;
		uniform float refractionRatio;
	#else
		varying vec3 vReflect;
	#endif
#endif`,pb=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,mb=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vWorldPosition = worldPosition.xyz;
	#else
		vec3 cameraToVertex;
		if ( isOrthographic ) {
			cameraToVertex = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToVertex = normalize( worldPosition.xyz - cameraPosition );
		}
		vec3 worldNormal = transformNormalByInverseViewMatrix( transformedNormal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vReflect = reflect( cameraToVertex, worldNormal );
		#else
			vReflect = refract( cameraToVertex, worldNormal, refractionRatio );
		#endif
	#endif
#endif`,gb=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,_b=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,xb=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,vb=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,yb=`#ifdef USE_GRADIENTMAP
	uniform sampler2D gradientMap;
#endif
vec3 getGradientIrradiance( vec3 normal, vec3 lightDirection ) {
	float dotNL = dot( normal, lightDirection );
	vec2 coord = vec2( dotNL * 0.5 + 0.5, 0.0 );
	#ifdef USE_GRADIENTMAP
		return vec3( texture2D( gradientMap, coord ).r );
	#else
		vec2 fw = fwidth( coord ) * 0.5;
		return mix( vec3( 0.7 ), vec3( 1.0 ), smoothstep( 0.7 - fw.x, 0.7 + fw.x, coord.x ) );
	#endif
}`,bb=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,wb=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,Sb=`varying vec3 vViewPosition;
struct LambertMaterial {
	vec3 diffuseColor;
	float specularStrength;
};
void RE_Direct_Lambert( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Lambert( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Lambert
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,Mb=`uniform bool receiveShadow;
uniform vec3 ambientLightColor;
#if defined( USE_LIGHT_PROBES )
	uniform vec3 lightProbe[ 9 ];
#endif
vec3 shGetIrradianceAt( in vec3 normal, in vec3 shCoefficients[ 9 ] ) {
	float x = normal.x, y = normal.y, z = normal.z;
	vec3 result = shCoefficients[ 0 ] * 0.886227;
	result += shCoefficients[ 1 ] * 2.0 * 0.511664 * y;
	result += shCoefficients[ 2 ] * 2.0 * 0.511664 * z;
	result += shCoefficients[ 3 ] * 2.0 * 0.511664 * x;
	result += shCoefficients[ 4 ] * 2.0 * 0.429043 * x * y;
	result += shCoefficients[ 5 ] * 2.0 * 0.429043 * y * z;
	result += shCoefficients[ 6 ] * ( 0.743125 * z * z - 0.247708 );
	result += shCoefficients[ 7 ] * 2.0 * 0.429043 * x * z;
	result += shCoefficients[ 8 ] * 0.429043 * ( x * x - y * y );
	return result;
}
vec3 getLightProbeIrradiance( const in vec3 lightProbe[ 9 ], const in vec3 normal ) {
	vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
	vec3 irradiance = shGetIrradianceAt( worldNormal, lightProbe );
	return irradiance;
}
vec3 getAmbientLightIrradiance( const in vec3 ambientLightColor ) {
	vec3 irradiance = ambientLightColor;
	return irradiance;
}
float getDistanceAttenuation( const in float lightDistance, const in float cutoffDistance, const in float decayExponent ) {
	float distanceFalloff = 1.0 / max( pow( lightDistance, decayExponent ), 0.01 );
	if ( cutoffDistance > 0.0 ) {
		distanceFalloff *= pow2( saturate( 1.0 - pow4( lightDistance / cutoffDistance ) ) );
	}
	return distanceFalloff;
}
float getSpotAttenuation( const in float coneCosine, const in float penumbraCosine, const in float angleCosine ) {
	return smoothstep( coneCosine, penumbraCosine, angleCosine );
}
#if NUM_SUN_LIGHTS > 0
	struct SunLight {
		vec3 direction;
		vec3 color;
	};
	uniform SunLight sunLights[ NUM_SUN_LIGHTS ];
	void getSunLightInfo( const in SunLight sunLight, out IncidentLight light ) {
		light.color = sunLight.color;
		light.direction = sunLight.direction;
		light.visible = true;
	}
#endif
#if NUM_DIR_LIGHTS > 0
	struct DirectionalLight {
		vec3 direction;
		vec3 color;
	};
	uniform DirectionalLight directionalLights[ NUM_DIR_LIGHTS ];
	void getDirectionalLightInfo( const in DirectionalLight directionalLight, out IncidentLight light ) {
		light.color = directionalLight.color;
		light.direction = directionalLight.direction;
		light.visible = true;
	}
#endif
#if NUM_POINT_LIGHTS > 0
	struct PointLight {
		vec3 position;
		vec3 color;
		float distance;
		float decay;
	};
	uniform PointLight pointLights[ NUM_POINT_LIGHTS ];
	void getPointLightInfo( const in PointLight pointLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = pointLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float lightDistance = length( lVector );
		light.color = pointLight.color;
		light.color *= getDistanceAttenuation( lightDistance, pointLight.distance, pointLight.decay );
		light.visible = ( light.color != vec3( 0.0 ) );
	}
#endif
#if NUM_SPOT_LIGHTS > 0
	struct SpotLight {
		vec3 position;
		vec3 direction;
		vec3 color;
		float distance;
		float decay;
		float coneCos;
		float penumbraCos;
	};
	uniform SpotLight spotLights[ NUM_SPOT_LIGHTS ];
	void getSpotLightInfo( const in SpotLight spotLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = spotLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float angleCos = dot( light.direction, spotLight.direction );
		float spotAttenuation = getSpotAttenuation( spotLight.coneCos, spotLight.penumbraCos, angleCos );
		if ( spotAttenuation > 0.0 ) {
			float lightDistance = length( lVector );
			light.color = spotLight.color * spotAttenuation;
			light.color *= getDistanceAttenuation( lightDistance, spotLight.distance, spotLight.decay );
			light.visible = ( light.color != vec3( 0.0 ) );
		} else {
			light.color = vec3( 0.0 );
			light.visible = false;
		}
	}
#endif
#if NUM_RECT_AREA_LIGHTS > 0
	struct RectAreaLight {
		vec3 color;
		vec3 position;
		vec3 halfWidth;
		vec3 halfHeight;
	};
	uniform sampler2D ltc_1;	uniform sampler2D ltc_2;
	uniform RectAreaLight rectAreaLights[ NUM_RECT_AREA_LIGHTS ];
#endif
#if NUM_HEMI_LIGHTS > 0
	struct HemisphereLight {
		vec3 direction;
		vec3 skyColor;
		vec3 groundColor;
	};
	uniform HemisphereLight hemisphereLights[ NUM_HEMI_LIGHTS ];
	vec3 getHemisphereLightIrradiance( const in HemisphereLight hemiLight, const in vec3 normal ) {
		float dotNL = dot( normal, hemiLight.direction );
		float hemiDiffuseWeight = 0.5 * dotNL + 0.5;
		vec3 irradiance = mix( hemiLight.groundColor, hemiLight.skyColor, hemiDiffuseWeight );
		return irradiance;
	}
#endif
#include <lightprobes_pars_fragment>`,Tb=`#ifdef USE_ENVMAP
	vec3 getIBLIrradiance( const in vec3 normal ) {
		#ifdef ENVMAP_TYPE_PMREM
			vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
			vec4 envMapColor = textureLod( envMap, envMapRotation * worldNormal, ENVMAP_MAX_LOD );
			return PI * envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	vec3 getIBLRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
		#ifdef ENVMAP_TYPE_PMREM
			vec3 reflectVec = reflect( - viewDir, normal );
			reflectVec = normalize( mix( reflectVec, normal, pow4( roughness ) ) );
			reflectVec = transformDirectionByInverseViewMatrix( reflectVec, viewMatrix );
			vec4 envMapColor = textureLod( envMap, envMapRotation * reflectVec, roughnessToMip( roughness ) );
			return envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	#ifdef USE_RETROREFLECTION
		vec3 getIBLRetroRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
			#ifdef ENVMAP_TYPE_PMREM
				vec3 retroVec = normalize( mix( viewDir, normal, pow4( roughness ) ) );
				retroVec = transformDirectionByInverseViewMatrix( retroVec, viewMatrix );
				vec4 envMapColor = textureLod( envMap, envMapRotation * retroVec, roughnessToMip( roughness ) );
				return envMapColor.rgb * envMapIntensity;
			#else
				return vec3( 0.0 );
			#endif
		}
	#endif
	#ifdef USE_ANISOTROPY
		vec3 getIBLAnisotropyRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
			#ifdef ENVMAP_TYPE_PMREM
				vec3 bentNormal = cross( bitangent, viewDir );
				bentNormal = normalize( cross( bentNormal, bitangent ) );
				bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
				return getIBLRadiance( viewDir, bentNormal, roughness );
			#else
				return vec3( 0.0 );
			#endif
		}
		#ifdef USE_RETROREFLECTION
			vec3 getIBLAnisotropyRetroRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
				#ifdef ENVMAP_TYPE_PMREM
					vec3 bentNormal = cross( bitangent, viewDir );
					bentNormal = normalize( cross( bentNormal, bitangent ) );
					bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
					return getIBLRetroRadiance( viewDir, bentNormal, roughness );
				#else
					return vec3( 0.0 );
				#endif
			}
		#endif
	#endif
#endif`,Ab=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,Eb=`varying vec3 vViewPosition;
struct ToonMaterial {
	vec3 diffuseColor;
};
void RE_Direct_Toon( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	vec3 irradiance = getGradientIrradiance( geometryNormal, directLight.direction ) * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Toon( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Toon
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,Rb=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,Cb=`varying vec3 vViewPosition;
struct BlinnPhongMaterial {
	vec3 diffuseColor;
	vec3 specularColor;
	float specularShininess;
	float specularStrength;
};
void RE_Direct_BlinnPhong( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
	reflectedLight.directSpecular += irradiance * BRDF_BlinnPhong( directLight.direction, geometryViewDir, geometryNormal, material.specularColor, material.specularShininess ) * material.specularStrength;
}
void RE_IndirectDiffuse_BlinnPhong( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_BlinnPhong
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,Ib=`PhysicalMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.diffuseContribution = diffuseColor.rgb * ( 1.0 - metalnessFactor );
material.metalness = metalnessFactor;
vec3 dxy = max( abs( dFdx( nonPerturbedNormal ) ), abs( dFdy( nonPerturbedNormal ) ) );
float geometryRoughness = max( max( dxy.x, dxy.y ), dxy.z );
material.roughness = max( roughnessFactor, 0.045 );
material.roughness += geometryRoughness;
material.roughness = min( material.roughness, 1.0 );
#ifdef USE_DIFFUSE_ROUGHNESS
	float diffuseRoughnessFactor = diffuseRoughness;
	#ifdef USE_DIFFUSE_ROUGHNESSMAP
		diffuseRoughnessFactor *= texture2D( diffuseRoughnessMap, vDiffuseRoughnessMapUv ).r;
	#endif
	material.diffuseRoughness = saturate( diffuseRoughnessFactor );
#endif
#ifdef IOR
	material.ior = ior;
	#ifdef USE_SPECULAR
		float specularIntensityFactor = specularIntensity;
		vec3 specularColorFactor = specularColor;
		#ifdef USE_SPECULAR_COLORMAP
			specularColorFactor *= texture2D( specularColorMap, vSpecularColorMapUv ).rgb;
		#endif
		#ifdef USE_SPECULAR_INTENSITYMAP
			specularIntensityFactor *= texture2D( specularIntensityMap, vSpecularIntensityMapUv ).a;
		#endif
		material.specularF90 = mix( specularIntensityFactor, 1.0, metalnessFactor );
	#else
		float specularIntensityFactor = 1.0;
		vec3 specularColorFactor = vec3( 1.0 );
		material.specularF90 = 1.0;
	#endif
	material.specularColor = min( pow2( ( material.ior - 1.0 ) / ( material.ior + 1.0 ) ) * specularColorFactor, vec3( 1.0 ) ) * specularIntensityFactor;
	material.specularColorBlended = mix( material.specularColor, diffuseColor.rgb, metalnessFactor );
#else
	material.specularColor = vec3( 0.04 );
	material.specularColorBlended = mix( material.specularColor, diffuseColor.rgb, metalnessFactor );
	material.specularF90 = 1.0;
#endif
#ifdef USE_CLEARCOAT
	material.clearcoat = clearcoat;
	material.clearcoatRoughness = clearcoatRoughness;
	material.clearcoatF0 = vec3( 0.04 );
	material.clearcoatF90 = 1.0;
	#ifdef USE_CLEARCOATMAP
		material.clearcoat *= texture2D( clearcoatMap, vClearcoatMapUv ).x;
	#endif
	#ifdef USE_CLEARCOAT_ROUGHNESSMAP
		material.clearcoatRoughness *= texture2D( clearcoatRoughnessMap, vClearcoatRoughnessMapUv ).y;
	#endif
	material.clearcoat = saturate( material.clearcoat );	material.clearcoatRoughness = max( material.clearcoatRoughness, 0.045 );
	material.clearcoatRoughness += geometryRoughness;
	material.clearcoatRoughness = min( material.clearcoatRoughness, 1.0 );
#endif
#ifdef USE_DISPERSION
	material.dispersion = dispersion;
#endif
#ifdef USE_RETROREFLECTION
	material.retroreflectivity = retroreflectivity;
#endif
#ifdef USE_IRIDESCENCE
	material.iridescence = iridescence;
	material.iridescenceIOR = iridescenceIOR;
	#ifdef USE_IRIDESCENCEMAP
		material.iridescence *= texture2D( iridescenceMap, vIridescenceMapUv ).r;
	#endif
	#ifdef USE_IRIDESCENCE_THICKNESSMAP
		material.iridescenceThickness = (iridescenceThicknessMaximum - iridescenceThicknessMinimum) * texture2D( iridescenceThicknessMap, vIridescenceThicknessMapUv ).g + iridescenceThicknessMinimum;
	#else
		material.iridescenceThickness = iridescenceThicknessMaximum;
	#endif
#endif
#ifdef USE_SHEEN
	material.sheenColor = sheenColor;
	#ifdef USE_SHEEN_COLORMAP
		material.sheenColor *= texture2D( sheenColorMap, vSheenColorMapUv ).rgb;
	#endif
	material.sheenRoughness = clamp( sheenRoughness, 0.0001, 1.0 );
	#ifdef USE_SHEEN_ROUGHNESSMAP
		material.sheenRoughness *= texture2D( sheenRoughnessMap, vSheenRoughnessMapUv ).a;
	#endif
#endif
#ifdef USE_ANISOTROPY
	#ifdef USE_ANISOTROPYMAP
		mat2 anisotropyMat = mat2( anisotropyVector.x, anisotropyVector.y, - anisotropyVector.y, anisotropyVector.x );
		vec3 anisotropyPolar = texture2D( anisotropyMap, vAnisotropyMapUv ).rgb;
		vec2 anisotropyV = anisotropyMat * normalize( 2.0 * anisotropyPolar.rg - vec2( 1.0 ) ) * anisotropyPolar.b;
	#else
		vec2 anisotropyV = anisotropyVector;
	#endif
	material.anisotropy = length( anisotropyV );
	if( material.anisotropy == 0.0 ) {
		anisotropyV = vec2( 1.0, 0.0 );
	} else {
		anisotropyV /= material.anisotropy;
		material.anisotropy = saturate( material.anisotropy );
	}
	material.alphaT = mix( pow2( material.roughness ), 1.0, pow2( material.anisotropy ) );
	material.anisotropyT = tbn[ 0 ] * anisotropyV.x + tbn[ 1 ] * anisotropyV.y;
	material.anisotropyB = tbn[ 1 ] * anisotropyV.x - tbn[ 0 ] * anisotropyV.y;
#endif`,Pb=`uniform sampler2D dfgLUT;
struct PhysicalMaterial {
	vec3 diffuseColor;
	vec3 diffuseContribution;
	vec3 specularColor;
	vec3 specularColorBlended;
	float roughness;
	float metalness;
	float specularF90;
	float dispersion;
	vec2 dfg;
	vec3 multiScatteringCompensation;
	#ifdef USE_DIFFUSE_ROUGHNESS
		float diffuseRoughness;
	#endif
	#ifdef USE_RETROREFLECTION
		float retroreflectivity;
	#endif
	#ifdef USE_CLEARCOAT
		float clearcoat;
		float clearcoatRoughness;
		vec3 clearcoatF0;
		float clearcoatF90;
	#endif
	#ifdef USE_IRIDESCENCE
		float iridescence;
		float iridescenceIOR;
		float iridescenceThickness;
		vec3 iridescenceFresnel;
		vec3 iridescenceF0Dielectric;
		vec3 iridescenceF0Metallic;
	#endif
	#ifdef USE_SHEEN
		vec3 sheenColor;
		float sheenRoughness;
	#endif
	#ifdef IOR
		float ior;
	#endif
	#ifdef USE_TRANSMISSION
		float transmission;
		float transmissionAlpha;
		float thickness;
		float attenuationDistance;
		vec3 attenuationColor;
	#endif
	#ifdef USE_ANISOTROPY
		float anisotropy;
		float alphaT;
		vec3 anisotropyT;
		vec3 anisotropyB;
	#endif
};
vec3 clearcoatSpecularDirect = vec3( 0.0 );
vec3 clearcoatSpecularIndirect = vec3( 0.0 );
vec3 sheenSpecularDirect = vec3( 0.0 );
vec3 sheenSpecularIndirect = vec3(0.0 );
vec3 Schlick_to_F0( const in vec3 f, const in float f90, const in float dotVH ) {
    float x = clamp( 1.0 - dotVH, 0.0, 1.0 );
    float x2 = x * x;
    float x5 = clamp( x * x2 * x2, 0.0, 0.9999 );
    return ( f - vec3( f90 ) * x5 ) / ( 1.0 - x5 );
}
#ifdef USE_DIFFUSE_ROUGHNESS
	const float EON_EPSILON = 1e-7;
	float FON_DirectionalAlbedo( const in float mu, const in float roughness, const in float A ) {
		float muComp = 1.0 - mu;
		float gOverPi = muComp * ( 0.0571085289 + muComp * ( 0.491881867 + muComp * ( - 0.332181442 + muComp * 0.0714429953 ) ) );
		return A * ( 1.0 + roughness * gOverPi );
	}
	vec3 BRDF_EON( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 diffuseColor, const in float roughness ) {
		vec3 rho = saturate( diffuseColor );
		if ( roughness <= EON_EPSILON ) return BRDF_Lambert( rho );
		float dotNL = saturate( dot( normal, lightDir ) );
		float dotNV = saturate( dot( normal, viewDir ) );
		float s = dot( lightDir, viewDir ) - dotNL * dotNV;
		float sOverT = ( s > 0.0 ) ? s / max( max( dotNL, dotNV ), EON_EPSILON ) : s;
		float A = 1.0 / ( 1.0 + ( 0.5 - 2.0 / ( 3.0 * PI ) ) * roughness );
		vec3 singleScatter = rho * RECIPROCAL_PI * A * ( 1.0 + roughness * sOverT );
		float averageAlbedo = A * ( 1.0 + ( 2.0 / 3.0 - 28.0 / ( 15.0 * PI ) ) * roughness );
		float albedoV = FON_DirectionalAlbedo( dotNV, roughness, A );
		float albedoL = FON_DirectionalAlbedo( dotNL, roughness, A );
		vec3 rhoMultiScatter = rho * rho * averageAlbedo / max( vec3( EON_EPSILON ), vec3( 1.0 ) - rho * ( 1.0 - averageAlbedo ) );
		vec3 multiScatter = rhoMultiScatter * RECIPROCAL_PI
			* max( EON_EPSILON, 1.0 - albedoV )
			* max( EON_EPSILON, 1.0 - albedoL )
			/ max( EON_EPSILON, 1.0 - averageAlbedo );
		return singleScatter + multiScatter;
	}
	vec3 EON_DirectionalAlbedo( const in vec3 diffuseColor, const in float roughness, const in float dotNV ) {
		vec3 rho = saturate( diffuseColor );
		if ( roughness <= EON_EPSILON ) return rho;
		float A = 1.0 / ( 1.0 + ( 0.5 - 2.0 / ( 3.0 * PI ) ) * roughness );
		float directionalAlbedo = FON_DirectionalAlbedo( dotNV, roughness, A );
		float averageAlbedo = A * ( 1.0 + ( 2.0 / 3.0 - 28.0 / ( 15.0 * PI ) ) * roughness );
		vec3 rhoMultiScatter = rho * rho * averageAlbedo / max( vec3( EON_EPSILON ), vec3( 1.0 ) - rho * ( 1.0 - averageAlbedo ) );
		return rho * directionalAlbedo + rhoMultiScatter * ( 1.0 - directionalAlbedo );
	}
#endif
float V_GGX_SmithCorrelated( const in float alpha, const in float dotNL, const in float dotNV ) {
	float a2 = pow2( alpha );
	float gv = dotNL * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNV ) );
	float gl = dotNV * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNL ) );
	return 0.5 / max( gv + gl, EPSILON );
}
float D_GGX( const in float alpha, const in float dotNH ) {
	float a2 = pow2( alpha );
	float denom = pow2( dotNH ) * ( a2 - 1.0 ) + 1.0;
	return RECIPROCAL_PI * a2 / pow2( denom );
}
#ifdef USE_ANISOTROPY
	float V_GGX_SmithCorrelated_Anisotropic( const in float alphaT, const in float alphaB, const in float dotTV, const in float dotBV, const in float dotTL, const in float dotBL, const in float dotNV, const in float dotNL ) {
		float gv = dotNL * length( vec3( alphaT * dotTV, alphaB * dotBV, dotNV ) );
		float gl = dotNV * length( vec3( alphaT * dotTL, alphaB * dotBL, dotNL ) );
		return 0.5 / max( gv + gl, EPSILON );
	}
	float D_GGX_Anisotropic( const in float alphaT, const in float alphaB, const in float dotNH, const in float dotTH, const in float dotBH ) {
		float a2 = alphaT * alphaB;
		highp vec3 v = vec3( alphaB * dotTH, alphaT * dotBH, a2 * dotNH );
		highp float v2 = dot( v, v );
		float w2 = a2 / v2;
		return RECIPROCAL_PI * a2 * pow2 ( w2 );
	}
#endif
#ifdef USE_CLEARCOAT
	vec3 BRDF_GGX_Clearcoat( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material) {
		vec3 f0 = material.clearcoatF0;
		float f90 = material.clearcoatF90;
		float roughness = max( material.clearcoatRoughness, 0.045 );
		float alpha = pow2( roughness );
		vec3 halfDir = normalize( lightDir + viewDir );
		float dotNL = saturate( dot( normal, lightDir ) );
		float dotNV = saturate( dot( normal, viewDir ) );
		float dotNH = saturate( dot( normal, halfDir ) );
		float dotVH = saturate( dot( viewDir, halfDir ) );
		vec3 F = F_Schlick( f0, f90, dotVH );
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
		return F * ( V * D );
	}
#endif
vec3 BRDF_GGX( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material ) {
	vec3 f0 = material.specularColorBlended;
	float f90 = material.specularF90;
	float roughness = max( material.roughness, 0.045 );
	float alpha = pow2( roughness );
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( f0, f90, dotVH );
	#ifdef USE_IRIDESCENCE
		F = mix( F, material.iridescenceFresnel, material.iridescence );
	#endif
	#ifdef USE_ANISOTROPY
		float dotTL = dot( material.anisotropyT, lightDir );
		float dotTV = dot( material.anisotropyT, viewDir );
		float dotTH = dot( material.anisotropyT, halfDir );
		float dotBL = dot( material.anisotropyB, lightDir );
		float dotBV = dot( material.anisotropyB, viewDir );
		float dotBH = dot( material.anisotropyB, halfDir );
		float alphaT = max( material.alphaT, alpha );
		float V = V_GGX_SmithCorrelated_Anisotropic( alphaT, alpha, dotTV, dotBV, dotTL, dotBL, dotNV, dotNL );
		float D = D_GGX_Anisotropic( alphaT, alpha, dotNH, dotTH, dotBH );
	#else
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
	#endif
	return F * ( V * D );
}
vec2 LTC_Uv( const in vec3 N, const in vec3 V, const in float roughness ) {
	const float LUT_SIZE = 64.0;
	const float LUT_SCALE = ( LUT_SIZE - 1.0 ) / LUT_SIZE;
	const float LUT_BIAS = 0.5 / LUT_SIZE;
	float dotNV = saturate( dot( N, V ) );
	vec2 uv = vec2( roughness, sqrt( 1.0 - dotNV ) );
	uv = uv * LUT_SCALE + LUT_BIAS;
	return uv;
}
float LTC_ClippedSphereFormFactor( const in vec3 f ) {
	float l = length( f );
	return max( ( l * l + f.z ) / ( l + 1.0 ), 0.0 );
}
vec3 LTC_EdgeVectorFormFactor( const in vec3 v1, const in vec3 v2 ) {
	float x = dot( v1, v2 );
	float y = abs( x );
	float a = 0.8543985 + ( 0.4965155 + 0.0145206 * y ) * y;
	float b = 3.4175940 + ( 4.1616724 + y ) * y;
	float v = a / b;
	float theta_sintheta = ( x > 0.0 ) ? v : 0.5 * inversesqrt( max( 1.0 - x * x, 1e-7 ) ) - v;
	return cross( v1, v2 ) * theta_sintheta;
}
vec3 LTC_Evaluate( const in vec3 N, const in vec3 V, const in vec3 P, const in mat3 mInv, const in vec3 rectCoords[ 4 ] ) {
	vec3 v1 = rectCoords[ 1 ] - rectCoords[ 0 ];
	vec3 v2 = rectCoords[ 3 ] - rectCoords[ 0 ];
	vec3 lightNormal = cross( v1, v2 );
	if( dot( lightNormal, P - rectCoords[ 0 ] ) < 0.0 ) return vec3( 0.0 );
	vec3 T1, T2;
	T1 = normalize( V - N * dot( V, N ) );
	T2 = - cross( N, T1 );
	mat3 mat = mInv * transpose( mat3( T1, T2, N ) );
	vec3 coords[ 4 ];
	coords[ 0 ] = mat * ( rectCoords[ 0 ] - P );
	coords[ 1 ] = mat * ( rectCoords[ 1 ] - P );
	coords[ 2 ] = mat * ( rectCoords[ 2 ] - P );
	coords[ 3 ] = mat * ( rectCoords[ 3 ] - P );
	coords[ 0 ] = normalize( coords[ 0 ] );
	coords[ 1 ] = normalize( coords[ 1 ] );
	coords[ 2 ] = normalize( coords[ 2 ] );
	coords[ 3 ] = normalize( coords[ 3 ] );
	vec3 vectorFormFactor = vec3( 0.0 );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 0 ], coords[ 1 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 1 ], coords[ 2 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 2 ], coords[ 3 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 3 ], coords[ 0 ] );
	float result = LTC_ClippedSphereFormFactor( vectorFormFactor );
	return vec3( result );
}
#if defined( USE_SHEEN )
float D_Charlie( float roughness, float dotNH ) {
	float alpha = pow2( roughness );
	float invAlpha = 1.0 / alpha;
	float cos2h = dotNH * dotNH;
	float sin2h = max( 1.0 - cos2h, 0.0078125 );
	return ( 2.0 + invAlpha ) * pow( sin2h, invAlpha * 0.5 ) / ( 2.0 * PI );
}
float V_Neubelt( float dotNV, float dotNL ) {
	return saturate( 1.0 / ( 4.0 * ( dotNL + dotNV - dotNL * dotNV ) ) );
}
vec3 BRDF_Sheen( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, vec3 sheenColor, const in float sheenRoughness ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float D = D_Charlie( sheenRoughness, dotNH );
	float V = V_Neubelt( dotNV, dotNL );
	return sheenColor * ( D * V );
}
#endif
float IBLSheenBRDF( const in vec3 normal, const in vec3 viewDir, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	float r2 = roughness * roughness;
	float rInv = 1.0 / ( roughness + 0.1 );
	float a = -1.9362 + 1.0678 * roughness + 0.4573 * r2 - 0.8469 * rInv;
	float b = -0.6014 + 0.5538 * roughness - 0.4670 * r2 - 0.1255 * rInv;
	float DG = exp( a * dotNV + b );
	return saturate( DG );
}
vec3 EnvironmentBRDF( const in vec3 normal, const in vec3 viewDir, const in vec3 specularColor, const in float specularF90, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	vec2 fab = texture2D( dfgLUT, vec2( roughness, dotNV ) ).rg;
	return specularColor * fab.x + specularF90 * fab.y;
}
#ifdef USE_IRIDESCENCE
void computeMultiscatteringIridescence( const in vec2 fab, const in vec3 specularColor, const in float specularF90, const in float iridescence, const in vec3 iridescenceF0, inout vec3 singleScatter, inout vec3 multiScatter ) {
#else
void computeMultiscattering( const in vec2 fab, const in vec3 specularColor, const in float specularF90, inout vec3 singleScatter, inout vec3 multiScatter ) {
#endif
	#ifdef USE_IRIDESCENCE
		vec3 Fr = mix( specularColor, iridescenceF0, iridescence );
	#else
		vec3 Fr = specularColor;
	#endif
	vec3 FssEss = Fr * fab.x + specularF90 * fab.y;
	float Ess = fab.x + fab.y;
	float Ems = 1.0 - Ess;
	vec3 Favg = Fr + ( 1.0 - Fr ) * 0.047619;	vec3 Fms = FssEss * Favg / ( 1.0 - Ems * Favg );
	singleScatter += FssEss;
	multiScatter += Fms * Ems;
}
#if NUM_RECT_AREA_LIGHTS > 0
	void RE_Direct_RectArea_Physical( const in RectAreaLight rectAreaLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
		vec3 normal = geometryNormal;
		vec3 viewDir = geometryViewDir;
		vec3 position = geometryPosition;
		vec3 lightPos = rectAreaLight.position;
		vec3 halfWidth = rectAreaLight.halfWidth;
		vec3 halfHeight = rectAreaLight.halfHeight;
		vec3 lightColor = rectAreaLight.color;
		float roughness = material.roughness;
		vec3 rectCoords[ 4 ];
		rectCoords[ 0 ] = lightPos + halfWidth - halfHeight;		rectCoords[ 1 ] = lightPos - halfWidth - halfHeight;
		rectCoords[ 2 ] = lightPos - halfWidth + halfHeight;
		rectCoords[ 3 ] = lightPos + halfWidth + halfHeight;
		vec2 uv = LTC_Uv( normal, viewDir, roughness );
		vec4 t1 = texture2D( ltc_1, uv );
		vec4 t2 = texture2D( ltc_2, uv );
		mat3 mInv = mat3(
			vec3( t1.x, 0, t1.y ),
			vec3(    0, 1,    0 ),
			vec3( t1.z, 0, t1.w )
		);
		vec3 fresnel = ( material.specularColorBlended * t2.x + ( material.specularF90 - material.specularColorBlended ) * t2.y );
		reflectedLight.directSpecular += lightColor * fresnel * LTC_Evaluate( normal, viewDir, position, mInv, rectCoords );
		reflectedLight.directDiffuse += lightColor * material.diffuseContribution * LTC_Evaluate( normal, viewDir, position, mat3( 1.0 ), rectCoords );
		#ifdef USE_CLEARCOAT
			vec3 Ncc = geometryClearcoatNormal;
			vec2 uvClearcoat = LTC_Uv( Ncc, viewDir, material.clearcoatRoughness );
			vec4 t1Clearcoat = texture2D( ltc_1, uvClearcoat );
			vec4 t2Clearcoat = texture2D( ltc_2, uvClearcoat );
			mat3 mInvClearcoat = mat3(
				vec3( t1Clearcoat.x, 0, t1Clearcoat.y ),
				vec3(             0, 1,             0 ),
				vec3( t1Clearcoat.z, 0, t1Clearcoat.w )
			);
			vec3 fresnelClearcoat = material.clearcoatF0 * t2Clearcoat.x + ( material.clearcoatF90 - material.clearcoatF0 ) * t2Clearcoat.y;
			clearcoatSpecularDirect += lightColor * fresnelClearcoat * LTC_Evaluate( Ncc, viewDir, position, mInvClearcoat, rectCoords );
		#endif
	}
#endif
void RE_Direct_Physical( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	#ifdef USE_CLEARCOAT
		float dotNLcc = saturate( dot( geometryClearcoatNormal, directLight.direction ) );
		vec3 ccIrradiance = dotNLcc * directLight.color;
		clearcoatSpecularDirect += ccIrradiance * BRDF_GGX_Clearcoat( directLight.direction, geometryViewDir, geometryClearcoatNormal, material );
	#endif
	#ifdef USE_SHEEN
 
 		sheenSpecularDirect += irradiance * BRDF_Sheen( directLight.direction, geometryViewDir, geometryNormal, material.sheenColor, material.sheenRoughness );
 
 		float sheenAlbedoV = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
 		float sheenAlbedoL = IBLSheenBRDF( geometryNormal, directLight.direction, material.sheenRoughness );
 
 		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * max( sheenAlbedoV, sheenAlbedoL );
 
 		irradiance *= sheenEnergyComp;
 
 	#endif
	vec3 specularBRDF = BRDF_GGX( directLight.direction, geometryViewDir, geometryNormal, material );
	#ifdef USE_RETROREFLECTION
		vec3 retroViewDir = reflect( - geometryViewDir, geometryNormal );
		vec3 retroSpecularBRDF = BRDF_GGX( directLight.direction, retroViewDir, geometryNormal, material );
		specularBRDF = mix( specularBRDF, retroSpecularBRDF, saturate( material.retroreflectivity ) );
	#endif
	reflectedLight.directSpecular += irradiance * specularBRDF * material.multiScatteringCompensation;
	vec3 halfDir = normalize( directLight.direction + geometryViewDir );
	float dotVH = saturate( dot( geometryViewDir, halfDir ) );
	vec3 F = F_Schlick( material.specularColor, material.specularF90, dotVH );
	#ifdef USE_RETROREFLECTION
		vec3 retroHalfDir = normalize( directLight.direction + retroViewDir );
		float dotRetroVH = saturate( dot( retroViewDir, retroHalfDir ) );
		vec3 retroF = F_Schlick( material.specularColor, material.specularF90, dotRetroVH );
		F = mix( F, retroF, saturate( material.retroreflectivity ) );
	#endif
	#ifdef USE_DIFFUSE_ROUGHNESS
		vec3 diffuseBRDF = BRDF_EON( directLight.direction, geometryViewDir, geometryNormal, material.diffuseColor, material.diffuseRoughness ) * ( 1.0 - material.metalness );
	#else
		vec3 diffuseBRDF = BRDF_Lambert( material.diffuseContribution );
	#endif
	reflectedLight.directDiffuse += irradiance * diffuseBRDF * ( 1.0 - F );
}
void RE_IndirectDiffuse_Physical( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	vec3 singleScattering = vec3( 0.0 );
	vec3 multiScattering = vec3( 0.0 );
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( material.dfg, material.specularColor, material.specularF90, material.iridescence, material.iridescenceF0Dielectric, singleScattering, multiScattering );
	#else
		computeMultiscattering( material.dfg, material.specularColor, material.specularF90, singleScattering, multiScattering );
	#endif
	#ifdef USE_DIFFUSE_ROUGHNESS
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		vec3 diffuseAlbedo = EON_DirectionalAlbedo( material.diffuseColor, material.diffuseRoughness, dotNV ) * ( 1.0 - material.metalness );
		vec3 diffuse = irradiance * RECIPROCAL_PI * diffuseAlbedo * ( 1.0 - singleScattering - multiScattering );
	#else
		vec3 diffuse = irradiance * BRDF_Lambert( material.diffuseContribution ) * ( 1.0 - singleScattering - multiScattering );
	#endif
	#ifdef USE_SHEEN
		float sheenAlbedo = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
		sheenSpecularIndirect += irradiance * material.sheenColor * sheenAlbedo * RECIPROCAL_PI;
		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * sheenAlbedo;
		diffuse *= sheenEnergyComp;
	#endif
	reflectedLight.indirectDiffuse += diffuse;
}
void RE_IndirectSpecular_Physical( const in vec3 radiance, const in vec3 irradiance, const in vec3 clearcoatRadiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight) {
	#ifdef USE_CLEARCOAT
		clearcoatSpecularIndirect += clearcoatRadiance * EnvironmentBRDF( geometryClearcoatNormal, geometryViewDir, material.clearcoatF0, material.clearcoatF90, material.clearcoatRoughness );
	#endif
	#ifdef USE_SHEEN
		sheenSpecularIndirect += irradiance * material.sheenColor * IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness ) * RECIPROCAL_PI;
 	#endif
	vec3 singleScatteringDielectric = vec3( 0.0 );
	vec3 multiScatteringDielectric = vec3( 0.0 );
	vec3 singleScatteringMetallic = vec3( 0.0 );
	vec3 multiScatteringMetallic = vec3( 0.0 );
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( material.dfg, material.specularColor, material.specularF90, material.iridescence, material.iridescenceF0Dielectric, singleScatteringDielectric, multiScatteringDielectric );
		computeMultiscatteringIridescence( material.dfg, material.diffuseColor, material.specularF90, material.iridescence, material.iridescenceF0Metallic, singleScatteringMetallic, multiScatteringMetallic );
	#else
		computeMultiscattering( material.dfg, material.specularColor, material.specularF90, singleScatteringDielectric, multiScatteringDielectric );
		computeMultiscattering( material.dfg, material.diffuseColor, material.specularF90, singleScatteringMetallic, multiScatteringMetallic );
	#endif
	vec3 singleScattering = mix( singleScatteringDielectric, singleScatteringMetallic, material.metalness );
	vec3 multiScattering = mix( multiScatteringDielectric, multiScatteringMetallic, material.metalness );
	vec3 totalScatteringDielectric = singleScatteringDielectric + multiScatteringDielectric;
	#ifdef USE_DIFFUSE_ROUGHNESS
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		vec3 diffuse = EON_DirectionalAlbedo( material.diffuseColor, material.diffuseRoughness, dotNV ) * ( 1.0 - material.metalness ) * ( 1.0 - totalScatteringDielectric );
	#else
		vec3 diffuse = material.diffuseContribution * ( 1.0 - totalScatteringDielectric );
	#endif
	vec3 cosineWeightedIrradiance = irradiance * RECIPROCAL_PI;
	vec3 indirectSpecular = radiance * singleScattering;
	indirectSpecular += multiScattering * cosineWeightedIrradiance;
	vec3 indirectDiffuse = diffuse * cosineWeightedIrradiance;
	#ifdef USE_SHEEN
		float sheenAlbedo = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * sheenAlbedo;
		indirectSpecular *= sheenEnergyComp;
		indirectDiffuse *= sheenEnergyComp;
	#endif
	reflectedLight.indirectSpecular += indirectSpecular;
	reflectedLight.indirectDiffuse += indirectDiffuse;
}
#define RE_Direct				RE_Direct_Physical
#define RE_Direct_RectArea		RE_Direct_RectArea_Physical
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Physical
#define RE_IndirectSpecular		RE_IndirectSpecular_Physical
float computeSpecularOcclusion( const in float dotNV, const in float ambientOcclusion, const in float roughness ) {
	return saturate( pow( dotNV + ambientOcclusion, exp2( - 16.0 * roughness - 1.0 ) ) - 1.0 + ambientOcclusion );
}`,Lb=`
vec3 geometryPosition = - vViewPosition;
vec3 geometryNormal = normal;
vec3 geometryViewDir = ( isOrthographic ) ? vec3( 0, 0, 1 ) : normalize( vViewPosition );
vec3 geometryClearcoatNormal = vec3( 0.0 );
#ifdef USE_CLEARCOAT
	geometryClearcoatNormal = clearcoatNormal;
#endif
#ifdef USE_IRIDESCENCE
	float dotNVi = saturate( dot( normal, geometryViewDir ) );
	if ( material.iridescenceThickness == 0.0 ) {
		material.iridescence = 0.0;
	} else {
		material.iridescence = saturate( material.iridescence );
	}
	if ( material.iridescence > 0.0 ) {
		vec3 iridescenceFresnelDielectric = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.specularColor );
		vec3 iridescenceFresnelMetallic = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.diffuseColor );
		material.iridescenceFresnel = mix( iridescenceFresnelDielectric, iridescenceFresnelMetallic, material.metalness );
		material.iridescenceF0Dielectric = Schlick_to_F0( iridescenceFresnelDielectric, 1.0, dotNVi );
		material.iridescenceF0Metallic = Schlick_to_F0( iridescenceFresnelMetallic, 1.0, dotNVi );
	}
#endif
#ifdef STANDARD
	float dotNVms = saturate( dot( geometryNormal, geometryViewDir ) );
	material.dfg = texture2D( dfgLUT, vec2( material.roughness, dotNVms ) ).rg;
	#if ( NUM_SUN_LIGHTS > 0 || NUM_DIR_LIGHTS > 0 || NUM_POINT_LIGHTS > 0 || NUM_SPOT_LIGHTS > 0 )
		float EssMs = material.dfg.x + material.dfg.y;
		material.multiScatteringCompensation = 1.0 + material.specularColorBlended * ( 1.0 / EssMs - 1.0 );
	#endif
#endif
IncidentLight directLight;
#if ( NUM_POINT_LIGHTS > 0 ) && defined( RE_Direct )
	PointLight pointLight;
	#if defined( USE_SHADOWMAP ) && NUM_POINT_LIGHT_SHADOWS > 0
	PointLightShadow pointLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHTS; i ++ ) {
		pointLight = pointLights[ i ];
		getPointLightInfo( pointLight, geometryPosition, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_POINT_LIGHT_SHADOWS ) && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_BASIC ) )
		pointLightShadow = pointLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getPointShadow( pointShadowMap[ i ], pointLightShadow.shadowMapSize, pointLightShadow.shadowIntensity, pointLightShadow.shadowBias, pointLightShadow.shadowRadius, vPointShadowCoord[ i ], pointLightShadow.shadowCameraNear, pointLightShadow.shadowCameraFar ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_SPOT_LIGHTS > 0 ) && defined( RE_Direct )
	SpotLight spotLight;
	vec4 spotColor;
	vec3 spotLightCoord;
	bool inSpotLightMap;
	#if defined( USE_SHADOWMAP ) && NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHTS; i ++ ) {
		spotLight = spotLights[ i ];
		getSpotLightInfo( spotLight, geometryPosition, directLight );
		#if ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#define SPOT_LIGHT_MAP_INDEX UNROLLED_LOOP_INDEX
		#elif ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		#define SPOT_LIGHT_MAP_INDEX NUM_SPOT_LIGHT_MAPS
		#else
		#define SPOT_LIGHT_MAP_INDEX ( UNROLLED_LOOP_INDEX - NUM_SPOT_LIGHT_SHADOWS + NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#endif
		#if ( SPOT_LIGHT_MAP_INDEX < NUM_SPOT_LIGHT_MAPS )
			spotLightCoord = vSpotLightCoord[ i ].xyz / vSpotLightCoord[ i ].w;
			inSpotLightMap = all( lessThan( abs( spotLightCoord * 2. - 1. ), vec3( 1.0 ) ) );
			spotColor = texture2D( spotLightMap[ SPOT_LIGHT_MAP_INDEX ], spotLightCoord.xy );
			directLight.color = inSpotLightMap ? directLight.color * spotColor.rgb : directLight.color;
		#endif
		#undef SPOT_LIGHT_MAP_INDEX
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		spotLightShadow = spotLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( spotShadowMap[ i ], spotLightShadow.shadowMapSize, spotLightShadow.shadowIntensity, spotLightShadow.shadowBias, spotLightShadow.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_SUN_LIGHTS > 0 ) && defined( RE_Direct )
	SunLight sunLight;
	#if defined( USE_SHADOWMAP ) && NUM_SUN_LIGHT_SHADOWS > 0
	SunLightShadow sunLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SUN_LIGHTS; i ++ ) {
		sunLight = sunLights[ i ];
		getSunLightInfo( sunLight, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SUN_LIGHT_SHADOWS )
		sunLightShadow = sunLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getSunShadow( sunShadowMap[ i ], sunLightShadow, UNROLLED_LOOP_INDEX ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_DIR_LIGHTS > 0 ) && defined( RE_Direct )
	DirectionalLight directionalLight;
	#if defined( USE_SHADOWMAP ) && NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHTS; i ++ ) {
		directionalLight = directionalLights[ i ];
		getDirectionalLightInfo( directionalLight, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_DIR_LIGHT_SHADOWS )
		directionalLightShadow = directionalLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( directionalShadowMap[ i ], directionalLightShadow.shadowMapSize, directionalLightShadow.shadowIntensity, directionalLightShadow.shadowBias, directionalLightShadow.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_RECT_AREA_LIGHTS > 0 ) && defined( RE_Direct_RectArea )
	RectAreaLight rectAreaLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_RECT_AREA_LIGHTS; i ++ ) {
		rectAreaLight = rectAreaLights[ i ];
		RE_Direct_RectArea( rectAreaLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if defined( RE_IndirectDiffuse )
	vec3 iblIrradiance = vec3( 0.0 );
	vec3 irradiance = getAmbientLightIrradiance( ambientLightColor );
	#if defined( USE_LIGHT_PROBES )
		irradiance += getLightProbeIrradiance( lightProbe, geometryNormal );
	#endif
	#if ( NUM_HEMI_LIGHTS > 0 )
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_HEMI_LIGHTS; i ++ ) {
			irradiance += getHemisphereLightIrradiance( hemisphereLights[ i ], geometryNormal );
		}
		#pragma unroll_loop_end
	#endif
	#if NUM_LIGHT_PROBE_GRIDS > 0
		vec3 probeWorldPos = ( ( vec4( geometryPosition, 1.0 ) - viewMatrix[ 3 ] ) * viewMatrix ).xyz;
		vec3 probeWorldNormal = transformNormalByInverseViewMatrix( geometryNormal, viewMatrix );
		int probeGrid = - 1;
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_LIGHT_PROBE_GRIDS; i ++ ) {
			if ( isInsideLightProbeGrid( probeWorldPos, probeWorldNormal, probesMin[ i ], probesMax[ i ], probesResolution[ i ] ) ) probeGrid = UNROLLED_LOOP_INDEX;
		}
		#pragma unroll_loop_end
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_LIGHT_PROBE_GRIDS; i ++ ) {
			if ( probeGrid == UNROLLED_LOOP_INDEX ) irradiance += getLightProbeGridIrradiance( probesSH[ i ], probesMin[ i ], probesMax[ i ], probesResolution[ i ], probeWorldPos, probeWorldNormal );
		}
		#pragma unroll_loop_end
	#endif
#endif
#if defined( RE_IndirectSpecular )
	vec3 radiance = vec3( 0.0 );
	vec3 clearcoatRadiance = vec3( 0.0 );
#endif`,Nb=`#if defined( RE_IndirectDiffuse )
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		vec3 lightMapIrradiance = lightMapTexel.rgb * lightMapIntensity;
		irradiance += lightMapIrradiance;
	#endif
	#if defined( USE_ENVMAP ) && defined( ENVMAP_TYPE_PMREM )
		#if defined( STANDARD ) || defined( LAMBERT ) || defined( PHONG )
			iblIrradiance += getIBLIrradiance( geometryNormal );
		#endif
	#endif
#endif
#if defined( USE_ENVMAP ) && defined( RE_IndirectSpecular )
	#ifdef USE_ANISOTROPY
		vec3 iblRadiance = getIBLAnisotropyRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
	#else
		vec3 iblRadiance = getIBLRadiance( geometryViewDir, geometryNormal, material.roughness );
	#endif
	#ifdef USE_RETROREFLECTION
		#ifdef USE_ANISOTROPY
			vec3 retroIBLRadiance = getIBLAnisotropyRetroRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
		#else
			vec3 retroIBLRadiance = getIBLRetroRadiance( geometryViewDir, geometryNormal, material.roughness );
		#endif
		iblRadiance = mix( iblRadiance, retroIBLRadiance, saturate( material.retroreflectivity ) );
	#endif
	radiance += iblRadiance;
	#ifdef USE_CLEARCOAT
		clearcoatRadiance += getIBLRadiance( geometryViewDir, geometryClearcoatNormal, material.clearcoatRoughness );
	#endif
#endif`,Db=`#if defined( RE_IndirectDiffuse )
	#if defined( LAMBERT ) || defined( PHONG )
		irradiance += iblIrradiance;
	#endif
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,Fb=`#if NUM_LIGHT_PROBE_GRIDS > 0
uniform highp sampler3D probesSH[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesMin[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesMax[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesResolution[ NUM_LIGHT_PROBE_GRIDS ];
bool isInsideLightProbeGrid( vec3 worldPos, vec3 worldNormal, vec3 probesMin, vec3 probesMax, vec3 probesResolution ) {
	vec3 spacing = ( probesMax - probesMin ) / probesResolution;
	vec3 samplePos = worldPos + worldNormal * spacing * 0.5;
	vec3 margin = spacing * 0.01;
	return all( greaterThanEqual( samplePos, probesMin - margin ) ) && all( lessThanEqual( samplePos, probesMax + margin ) );
}
vec3 getLightProbeGridIrradiance( highp sampler3D probesSH, vec3 probesMin, vec3 probesMax, vec3 probesResolution, vec3 worldPos, vec3 worldNormal ) {
	vec3 res = probesResolution;
	vec3 gridRange = probesMax - probesMin;
	vec3 probeSpacing = gridRange / res;
	vec3 samplePos = worldPos + worldNormal * probeSpacing * 0.5;
	vec3 uvw = clamp( ( samplePos - probesMin ) / gridRange, 0.5 / res, 1.0 - 0.5 / res );
	float nz          = res.z;
	float paddedSlices = nz + 2.0;
	float atlasDepth  = 7.0 * paddedSlices;
	float uvZBase     = uvw.z * nz + 1.0;
	vec4 s0 = texture( probesSH, vec3( uvw.xy, ( uvZBase                       ) / atlasDepth ) );
	vec4 s1 = texture( probesSH, vec3( uvw.xy, ( uvZBase +       paddedSlices   ) / atlasDepth ) );
	vec4 s2 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 2.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s3 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 3.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s4 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 4.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s5 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 5.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s6 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 6.0 * paddedSlices   ) / atlasDepth ) );
	vec3 c0 = s0.xyz;
	vec3 c1 = vec3( s0.w, s1.xy );
	vec3 c2 = vec3( s1.zw, s2.x );
	vec3 c3 = s2.yzw;
	vec3 c4 = s3.xyz;
	vec3 c5 = vec3( s3.w, s4.xy );
	vec3 c6 = vec3( s4.zw, s5.x );
	vec3 c7 = s5.yzw;
	vec3 c8 = s6.xyz;
	float x = worldNormal.x, y = worldNormal.y, z = worldNormal.z;
	vec3 result = c0 * 0.886227;
	result += c1 * 2.0 * 0.511664 * y;
	result += c2 * 2.0 * 0.511664 * z;
	result += c3 * 2.0 * 0.511664 * x;
	result += c4 * 2.0 * 0.429043 * x * y;
	result += c5 * 2.0 * 0.429043 * y * z;
	result += c6 * ( 0.743125 * z * z - 0.247708 );
	result += c7 * 2.0 * 0.429043 * x * z;
	result += c8 * 0.429043 * ( x * x - y * y );
	return max( result, vec3( 0.0 ) );
}
#endif`,Ub=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,Ob=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,Bb=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,zb=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,kb=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,Vb=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,Hb=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
	#if defined( USE_POINTS_UV )
		vec2 uv = vUv;
	#else
		vec2 uv = ( uvTransform * vec3( gl_PointCoord.x, 1.0 - gl_PointCoord.y, 1 ) ).xy;
	#endif
#endif
#ifdef USE_MAP
	diffuseColor *= texture2D( map, uv );
#endif
#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, uv ).g;
#endif`,Gb=`#if defined( USE_POINTS_UV )
	varying vec2 vUv;
#else
	#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
		uniform mat3 uvTransform;
	#endif
#endif
#ifdef USE_MAP
	uniform sampler2D map;
#endif
#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,Wb=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,Xb=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,qb=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,Yb=`#if defined( USE_MORPHCOLORS )
	#if defined( USE_COLOR_ALPHA )
		vColor *= morphTargetBaseInfluence;
	#elif defined( USE_COLOR )
		vColor.rgb *= morphTargetBaseInfluence;
	#endif
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		#if defined( USE_COLOR_ALPHA )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor += getMorph( gl_VertexID, i, 2 ) * morphTargetInfluences[ i ];
		#elif defined( USE_COLOR )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor.rgb += getMorph( gl_VertexID, i, 2 ).rgb * morphTargetInfluences[ i ];
		#endif
	}
#endif`,$b=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,Zb=`#ifdef USE_MORPHTARGETS
	#ifndef USE_INSTANCING_MORPH
		uniform float morphTargetBaseInfluence;
		uniform float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	#endif
	uniform sampler2DArray morphTargetsTexture;
	uniform ivec2 morphTargetsTextureSize;
	vec4 getMorph( const in int vertexIndex, const in int morphTargetIndex, const in int offset ) {
		int texelIndex = vertexIndex * MORPHTARGETS_TEXTURE_STRIDE + offset;
		int y = texelIndex / morphTargetsTextureSize.x;
		int x = texelIndex - y * morphTargetsTextureSize.x;
		ivec3 morphUV = ivec3( x, y, morphTargetIndex );
		return texelFetch( morphTargetsTexture, morphUV, 0 );
	}
#endif`,Kb=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,Jb=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
#ifdef FLAT_SHADED
	vec3 fdx = dFdx( vViewPosition );
	vec3 fdy = dFdy( vViewPosition );
	vec3 normal = normalize( cross( fdx, fdy ) );
#else
	vec3 normal = normalize( vNormal );
	#ifdef DOUBLE_SIDED
		normal *= faceDirection;
	#endif
#endif
#if defined( USE_NORMALMAP_TANGENTSPACE ) || defined( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY )
	#ifdef USE_TANGENT
		mat3 tbn = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn = getTangentFrame( - vViewPosition, normal,
		#if defined( USE_NORMALMAP )
			vNormalMapUv
		#elif defined( USE_CLEARCOAT_NORMALMAP )
			vClearcoatNormalMapUv
		#else
			vUv
		#endif
		);
	#endif
	#ifdef DOUBLE_SIDED
		tbn[0] *= faceDirection;
		tbn[1] *= faceDirection;
	#endif
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	#ifdef USE_TANGENT
		mat3 tbn2 = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn2 = getTangentFrame( - vViewPosition, normal, vClearcoatNormalMapUv );
	#endif
	#ifdef DOUBLE_SIDED
		tbn2[0] *= faceDirection;
		tbn2[1] *= faceDirection;
	#endif
#endif
vec3 nonPerturbedNormal = normal;`,jb=`#ifdef USE_NORMALMAP_OBJECTSPACE
	normal = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	#ifdef FLIP_SIDED
		normal = - normal;
	#endif
	#ifdef DOUBLE_SIDED
		normal = normal * faceDirection;
	#endif
	normal = normalize( normalMatrix * normal );
#elif defined( USE_NORMALMAP_TANGENTSPACE )
	vec3 mapN = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	#if defined( USE_PACKED_NORMALMAP )
		mapN = vec3( mapN.xy, sqrt( saturate( 1.0 - dot( mapN.xy, mapN.xy ) ) ) );
	#endif
	mapN.xy *= normalScale;
	normal = normalize( tbn * mapN );
#elif defined( USE_BUMPMAP )
	normal = perturbNormalArb( - vViewPosition, normal, dHdxy_fwd(), faceDirection );
#endif`,Qb=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,ew=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,tw=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
		#ifdef FLIP_SIDED
			vBitangent = - vBitangent;
		#endif
	#endif
#endif`,nw=`#ifdef USE_NORMALMAP
	uniform sampler2D normalMap;
	uniform vec2 normalScale;
#endif
#ifdef USE_NORMALMAP_OBJECTSPACE
	uniform mat3 normalMatrix;
#endif
#if ! defined ( USE_TANGENT ) && ( defined ( USE_NORMALMAP_TANGENTSPACE ) || defined ( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY ) )
	mat3 getTangentFrame( vec3 eye_pos, vec3 surf_norm, vec2 uv ) {
		vec3 q0 = dFdx( eye_pos.xyz );
		vec3 q1 = dFdy( eye_pos.xyz );
		vec2 st0 = dFdx( uv.st );
		vec2 st1 = dFdy( uv.st );
		vec3 N = surf_norm;
		vec3 q1perp = cross( q1, N );
		vec3 q0perp = cross( N, q0 );
		vec3 T = q1perp * st0.x + q0perp * st1.x;
		vec3 B = q1perp * st0.y + q0perp * st1.y;
		float det = max( dot( T, T ), dot( B, B ) );
		float scale = ( det == 0.0 ) ? 0.0 : inversesqrt( det );
		return mat3( T * scale, B * scale, N );
	}
#endif`,iw=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,rw=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,sw=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,ow=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,aw=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,lw=`vec3 packNormalToRGB( const in vec3 normal ) {
	return normalize( normal ) * 0.5 + 0.5;
}
vec3 unpackRGBToNormal( const in vec3 rgb ) {
	return 2.0 * rgb.xyz - 1.0;
}
const float PackUpscale = 256. / 255.;const float UnpackDownscale = 255. / 256.;const float ShiftRight8 = 1. / 256.;
const float Inv255 = 1. / 255.;
const vec4 PackFactors = vec4( 1.0, 256.0, 256.0 * 256.0, 256.0 * 256.0 * 256.0 );
const vec2 UnpackFactors2 = vec2( UnpackDownscale, 1.0 / PackFactors.g );
const vec3 UnpackFactors3 = vec3( UnpackDownscale / PackFactors.rg, 1.0 / PackFactors.b );
const vec4 UnpackFactors4 = vec4( UnpackDownscale / PackFactors.rgb, 1.0 / PackFactors.a );
vec4 packDepthToRGBA( const in float v ) {
	if( v <= 0.0 )
		return vec4( 0., 0., 0., 0. );
	if( v >= 1.0 )
		return vec4( 1., 1., 1., 1. );
	float vuf;
	float af = modf( v * PackFactors.a, vuf );
	float bf = modf( vuf * ShiftRight8, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec4( vuf * Inv255, gf * PackUpscale, bf * PackUpscale, af );
}
vec3 packDepthToRGB( const in float v ) {
	if( v <= 0.0 )
		return vec3( 0., 0., 0. );
	if( v >= 1.0 )
		return vec3( 1., 1., 1. );
	float vuf;
	float bf = modf( v * PackFactors.b, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec3( vuf * Inv255, gf * PackUpscale, bf );
}
vec2 packDepthToRG( const in float v ) {
	if( v <= 0.0 )
		return vec2( 0., 0. );
	if( v >= 1.0 )
		return vec2( 1., 1. );
	float vuf;
	float gf = modf( v * 256., vuf );
	return vec2( vuf * Inv255, gf );
}
float unpackRGBAToDepth( const in vec4 v ) {
	return dot( v, UnpackFactors4 );
}
float unpackRGBToDepth( const in vec3 v ) {
	return dot( v, UnpackFactors3 );
}
float unpackRGToDepth( const in vec2 v ) {
	return v.r * UnpackFactors2.r + v.g * UnpackFactors2.g;
}
vec4 pack2HalfToRGBA( const in vec2 v ) {
	vec4 r = vec4( v.x, fract( v.x * 255.0 ), v.y, fract( v.y * 255.0 ) );
	return vec4( r.x - r.y / 255.0, r.y, r.z - r.w / 255.0, r.w );
}
vec2 unpackRGBATo2Half( const in vec4 v ) {
	return vec2( v.x + ( v.y / 255.0 ), v.z + ( v.w / 255.0 ) );
}
float viewZToOrthographicDepth( const in float viewZ, const in float near, const in float far ) {
	return ( viewZ + near ) / ( near - far );
}
float orthographicDepthToViewZ( const in float depth, const in float near, const in float far ) {
	#ifdef USE_REVERSED_DEPTH_BUFFER
	
		return depth * ( far - near ) - far;
	#else
		return depth * ( near - far ) - near;
	#endif
}
float viewZToPerspectiveDepth( const in float viewZ, const in float near, const in float far ) {
	return ( ( near + viewZ ) * far ) / ( ( far - near ) * viewZ );
}
float perspectiveDepthToViewZ( const in float depth, const in float near, const in float far ) {
	
	#ifdef USE_REVERSED_DEPTH_BUFFER
		return ( near * far ) / ( ( near - far ) * depth - near );
	#else
		return ( near * far ) / ( ( far - near ) * depth - far );
	#endif
}`,cw=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,uw=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,hw=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,fw=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,dw=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,pw=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,mw=`#if NUM_SPOT_LIGHT_COORDS > 0
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#if NUM_SPOT_LIGHT_MAPS > 0
	uniform sampler2D spotLightMap[ NUM_SPOT_LIGHT_MAPS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
		#define SUN_LIGHT_CASCADES 2
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow sunShadowMap[ NUM_SUN_LIGHT_SHADOWS ];
		#else
			uniform sampler2D sunShadowMap[ NUM_SUN_LIGHT_SHADOWS ];
		#endif
		uniform mat4 sunShadowMatrix[ NUM_SUN_LIGHT_SHADOWS * SUN_LIGHT_CASCADES ];
		uniform vec4 sunShadowCascade[ NUM_SUN_LIGHT_SHADOWS * SUN_LIGHT_CASCADES ];
		varying vec4 vSunShadowWorldPosition;
		varying vec3 vSunShadowWorldNormal;
		struct SunLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SunLightShadow sunLightShadows[ NUM_SUN_LIGHT_SHADOWS ];
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		#else
			uniform sampler2D directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		#endif
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		#else
			uniform sampler2D spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		#endif
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform samplerCubeShadow pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		#elif defined( SHADOWMAP_TYPE_BASIC )
			uniform samplerCube pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		#endif
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
	#if defined( SHADOWMAP_TYPE_PCF )
		float interleavedGradientNoise( vec2 position ) {
			return fract( 52.9829189 * fract( dot( position, vec2( 0.06711056, 0.00583715 ) ) ) );
		}
		vec2 vogelDiskSample( int sampleIndex, int samplesCount, float phi ) {
			const float goldenAngle = 2.399963229728653;
			float r = sqrt( ( float( sampleIndex ) + 0.5 ) / float( samplesCount ) );
			float theta = float( sampleIndex ) * goldenAngle + phi;
			return vec2( cos( theta ), sin( theta ) ) * r;
		}
	#endif
	#if defined( SHADOWMAP_TYPE_PCF )
		float getShadow( sampler2DShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				vec2 texelSize = vec2( 1.0 ) / shadowMapSize;
				vec2 radius = shadowRadius * texelSize;
				float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;
				shadow = (
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 0, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 1, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 2, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 3, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 4, 5, phi ) * radius, shadowCoord.z ) )
				) * 0.2;
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#elif defined( SHADOWMAP_TYPE_VSM )
		float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				vec2 distribution = texture2D( shadowMap, shadowCoord.xy ).rg;
				float mean = distribution.x;
				float variance = distribution.y * distribution.y;
				#ifdef USE_REVERSED_DEPTH_BUFFER
					float hard_shadow = step( mean, shadowCoord.z );
				#else
					float hard_shadow = step( shadowCoord.z, mean );
				#endif
				
				if ( hard_shadow == 1.0 ) {
					shadow = 1.0;
				} else {
					variance = max( variance, 0.0000001 );
					float d = shadowCoord.z - mean;
					float p_max = variance / ( variance + d * d );
					p_max = clamp( ( p_max - 0.3 ) / 0.65, 0.0, 1.0 );
					shadow = max( hard_shadow, p_max );
				}
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#else
		float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				float depth = texture2D( shadowMap, shadowCoord.xy ).r;
				#ifdef USE_REVERSED_DEPTH_BUFFER
					shadow = step( depth, shadowCoord.z );
				#else
					shadow = step( shadowCoord.z, depth );
				#endif
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#endif
	#if NUM_SUN_LIGHT_SHADOWS > 0
		float getSunShadow(
			#if defined( SHADOWMAP_TYPE_PCF )
				sampler2DShadow shadowMap,
			#else
				sampler2D shadowMap,
			#endif
			SunLightShadow sunLightShadow,
			int shadowIndex
		) {
			vec4 shadowWorldPosition = vec4( vSunShadowWorldPosition.xyz + vSunShadowWorldNormal * sunLightShadow.shadowNormalBias, 1.0 );
			float viewDepth = vSunShadowWorldPosition.w;
			int cascadeOffset = shadowIndex * SUN_LIGHT_CASCADES;
			float shadow = 1.0;
			for ( int i = SUN_LIGHT_CASCADES - 1; i >= 0; i -- ) {
				vec4 cascade = sunShadowCascade[ cascadeOffset + i ];
				if ( viewDepth >= cascade.x && viewDepth < cascade.y ) {
					float cascadeShadow = getShadow(
						shadowMap,
						sunLightShadow.shadowMapSize,
						sunLightShadow.shadowIntensity,
						sunLightShadow.shadowBias,
						sunLightShadow.shadowRadius,
						sunShadowMatrix[ cascadeOffset + i ] * shadowWorldPosition
					);
					shadow = mix( cascadeShadow, shadow, smoothstep( cascade.z, cascade.y, viewDepth ) );
				}
			}
			return shadow;
		}
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
	#if defined( SHADOWMAP_TYPE_PCF )
	float getPointShadow( samplerCubeShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		vec3 bd3D = normalize( lightToPosition );
		vec3 absVec = abs( lightToPosition );
		float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );
		if ( viewSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {
			float lightDistance = length( lightToPosition );
			float depthRange = shadowCameraFar - shadowCameraNear;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				float depthA = - shadowCameraNear / depthRange - shadowBias;
				float depthB = shadowCameraNear * shadowCameraFar / ( depthRange * lightDistance );
			#else
				float depthA = shadowCameraFar / depthRange + shadowBias;
				float depthB = - shadowCameraNear * shadowCameraFar / ( depthRange * lightDistance );
			#endif
			float texelSize = shadowRadius / shadowMapSize.x;
			vec3 absDir = abs( bd3D );
			vec3 tangent = absDir.x > absDir.z ? vec3( 0.0, 1.0, 0.0 ) : vec3( 1.0, 0.0, 0.0 );
			tangent = normalize( cross( bd3D, tangent ) );
			vec3 bitangent = cross( bd3D, tangent );
			float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;
			shadow = 0.0;
			for ( int i = 0; i < 5; i ++ ) {
				vec2 offset = vogelDiskSample( i, 5, phi );
				vec3 direction = bd3D + ( tangent * offset.x + bitangent * offset.y ) * texelSize;
				vec3 absDirection = abs( direction );
				float dp = depthA + depthB / max( max( absDirection.x, absDirection.y ), absDirection.z );
				shadow += texture( shadowMap, vec4( direction, dp ) );
			}
			shadow *= 0.2;
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	#elif defined( SHADOWMAP_TYPE_BASIC )
	float getPointShadow( samplerCube shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		vec3 absVec = abs( lightToPosition );
		float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );
		if ( viewSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {
			float dp = ( shadowCameraFar * ( viewSpaceZ - shadowCameraNear ) ) / ( viewSpaceZ * ( shadowCameraFar - shadowCameraNear ) );
			dp += shadowBias;
			vec3 bd3D = normalize( lightToPosition );
			float depth = textureCube( shadowMap, bd3D ).r;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				depth = 1.0 - depth;
			#endif
			shadow = step( dp, depth );
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	#endif
	#endif
#endif`,gw=`#if NUM_SPOT_LIGHT_COORDS > 0
	uniform mat4 spotLightMatrix[ NUM_SPOT_LIGHT_COORDS ];
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
		varying vec4 vSunShadowWorldPosition;
		varying vec3 vSunShadowWorldNormal;
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		uniform mat4 directionalShadowMatrix[ NUM_DIR_LIGHT_SHADOWS ];
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		uniform mat4 pointShadowMatrix[ NUM_POINT_LIGHT_SHADOWS ];
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
#endif`,_w=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_SUN_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
	#ifdef HAS_NORMAL
		vec3 shadowWorldNormal = transformNormalByInverseViewMatrix( transformedNormal, viewMatrix );
	#else
		vec3 shadowWorldNormal = vec3( 0.0 );
	#endif
	vec4 shadowWorldPosition;
#endif
#if defined( USE_SHADOWMAP )
	#if NUM_SUN_LIGHT_SHADOWS > 0
		vSunShadowWorldPosition = vec4( worldPosition.xyz, - mvPosition.z );
		vSunShadowWorldNormal = shadowWorldNormal;
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * directionalLightShadows[ i ].shadowNormalBias, 0 );
			vDirectionalShadowCoord[ i ] = directionalShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * pointLightShadows[ i ].shadowNormalBias, 0 );
			vPointShadowCoord[ i ] = pointShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
#endif
#if NUM_SPOT_LIGHT_COORDS > 0
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_COORDS; i ++ ) {
		shadowWorldPosition = worldPosition;
		#if ( defined( USE_SHADOWMAP ) && UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
			shadowWorldPosition.xyz += shadowWorldNormal * spotLightShadows[ i ].shadowNormalBias;
		#endif
		vSpotLightCoord[ i ] = spotLightMatrix[ i ] * shadowWorldPosition;
	}
	#pragma unroll_loop_end
#endif`,xw=`float getShadowMask() {
	float shadow = 1.0;
	#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
	SunLightShadow sunLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SUN_LIGHT_SHADOWS; i ++ ) {
		sunLight = sunLightShadows[ i ];
		shadow *= receiveShadow ? getSunShadow( sunShadowMap[ i ], sunLight, UNROLLED_LOOP_INDEX ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
		directionalLight = directionalLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( directionalShadowMap[ i ], directionalLight.shadowMapSize, directionalLight.shadowIntensity, directionalLight.shadowBias, directionalLight.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_SHADOWS; i ++ ) {
		spotLight = spotLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( spotShadowMap[ i ], spotLight.shadowMapSize, spotLight.shadowIntensity, spotLight.shadowBias, spotLight.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0 && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_BASIC ) )
	PointLightShadow pointLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
		pointLight = pointLightShadows[ i ];
		shadow *= receiveShadow ? getPointShadow( pointShadowMap[ i ], pointLight.shadowMapSize, pointLight.shadowIntensity, pointLight.shadowBias, pointLight.shadowRadius, vPointShadowCoord[ i ], pointLight.shadowCameraNear, pointLight.shadowCameraFar ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#endif
	return shadow;
}`,vw=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,yw=`#ifdef USE_SKINNING
	uniform mat4 bindMatrix;
	uniform mat4 bindMatrixInverse;
	uniform highp sampler2D boneTexture;
	mat4 getBoneMatrix( const in float i ) {
		int size = textureSize( boneTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( boneTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( boneTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( boneTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( boneTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
#endif`,bw=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,ww=`#ifdef USE_SKINNING
	mat4 skinMatrix = mat4( 0.0 );
	skinMatrix += skinWeight.x * boneMatX;
	skinMatrix += skinWeight.y * boneMatY;
	skinMatrix += skinWeight.z * boneMatZ;
	skinMatrix += skinWeight.w * boneMatW;
	skinMatrix = bindMatrixInverse * skinMatrix * bindMatrix;
	objectNormal = vec4( skinMatrix * vec4( objectNormal, 0.0 ) ).xyz;
	#ifdef USE_TANGENT
		objectTangent = vec4( skinMatrix * vec4( objectTangent, 0.0 ) ).xyz;
	#endif
#endif`,Sw=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,Mw=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,Tw=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,Aw=`#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
uniform float toneMappingExposure;
vec3 LinearToneMapping( vec3 color ) {
	return saturate( toneMappingExposure * color );
}
vec3 ReinhardToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	return saturate( color / ( vec3( 1.0 ) + color ) );
}
vec3 CineonToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	color = max( vec3( 0.0 ), color - 0.004 );
	return pow( ( color * ( 6.2 * color + 0.5 ) ) / ( color * ( 6.2 * color + 1.7 ) + 0.06 ), vec3( 2.2 ) );
}
vec3 RRTAndODTFit( vec3 v ) {
	vec3 a = v * ( v + 0.0245786 ) - 0.000090537;
	vec3 b = v * ( 0.983729 * v + 0.4329510 ) + 0.238081;
	return a / b;
}
vec3 ACESFilmicToneMapping( vec3 color ) {
	const mat3 ACESInputMat = mat3(
		vec3( 0.59719, 0.07600, 0.02840 ),		vec3( 0.35458, 0.90834, 0.13383 ),
		vec3( 0.04823, 0.01566, 0.83777 )
	);
	const mat3 ACESOutputMat = mat3(
		vec3(  1.60475, -0.10208, -0.00327 ),		vec3( -0.53108,  1.10813, -0.07276 ),
		vec3( -0.07367, -0.00605,  1.07602 )
	);
	color *= toneMappingExposure / 0.6;
	color = ACESInputMat * color;
	color = RRTAndODTFit( color );
	color = ACESOutputMat * color;
	return saturate( color );
}
const mat3 LINEAR_REC2020_TO_LINEAR_SRGB = mat3(
	vec3( 1.6605, - 0.1246, - 0.0182 ),
	vec3( - 0.5876, 1.1329, - 0.1006 ),
	vec3( - 0.0728, - 0.0083, 1.1187 )
);
const mat3 LINEAR_SRGB_TO_LINEAR_REC2020 = mat3(
	vec3( 0.6274, 0.0691, 0.0164 ),
	vec3( 0.3293, 0.9195, 0.0880 ),
	vec3( 0.0433, 0.0113, 0.8956 )
);
vec3 agxDefaultContrastApprox( vec3 x ) {
	vec3 x2 = x * x;
	vec3 x4 = x2 * x2;
	return + 15.5 * x4 * x2
		- 40.14 * x4 * x
		+ 31.96 * x4
		- 6.868 * x2 * x
		+ 0.4298 * x2
		+ 0.1191 * x
		- 0.00232;
}
vec3 AgXToneMapping( vec3 color ) {
	const mat3 AgXInsetMatrix = mat3(
		vec3( 0.856627153315983, 0.137318972929847, 0.11189821299995 ),
		vec3( 0.0951212405381588, 0.761241990602591, 0.0767994186031903 ),
		vec3( 0.0482516061458583, 0.101439036467562, 0.811302368396859 )
	);
	const mat3 AgXOutsetMatrix = mat3(
		vec3( 1.1271005818144368, - 0.1413297634984383, - 0.14132976349843826 ),
		vec3( - 0.11060664309660323, 1.157823702216272, - 0.11060664309660294 ),
		vec3( - 0.016493938717834573, - 0.016493938717834257, 1.2519364065950405 )
	);
	const float AgxMinEv = - 12.47393;	const float AgxMaxEv = 4.026069;
	color *= toneMappingExposure;
	color = LINEAR_SRGB_TO_LINEAR_REC2020 * color;
	color = AgXInsetMatrix * color;
	color = max( color, 1e-10 );	color = log2( color );
	color = ( color - AgxMinEv ) / ( AgxMaxEv - AgxMinEv );
	color = clamp( color, 0.0, 1.0 );
	color = agxDefaultContrastApprox( color );
	color = AgXOutsetMatrix * color;
	color = pow( max( vec3( 0.0 ), color ), vec3( 2.2 ) );
	color = LINEAR_REC2020_TO_LINEAR_SRGB * color;
	color = clamp( color, 0.0, 1.0 );
	return color;
}
vec3 NeutralToneMapping( vec3 color ) {
	const float StartCompression = 0.8 - 0.04;
	const float Desaturation = 0.15;
	color *= toneMappingExposure;
	float x = min( color.r, min( color.g, color.b ) );
	float offset = x < 0.08 ? x - 6.25 * x * x : 0.04;
	color -= offset;
	float peak = max( color.r, max( color.g, color.b ) );
	if ( peak < StartCompression ) return color;
	float d = 1. - StartCompression;
	float newPeak = 1. - d * d / ( peak + d - StartCompression );
	color *= newPeak / peak;
	float g = 1. - 1. / ( Desaturation * ( peak - newPeak ) + 1. );
	return mix( color, vec3( newPeak ), g );
}
vec3 CustomToneMapping( vec3 color ) { return color; }`,Ew=`#ifdef USE_TRANSMISSION
	material.transmission = transmission;
	material.transmissionAlpha = 1.0;
	material.thickness = thickness;
	material.attenuationDistance = attenuationDistance;
	material.attenuationColor = attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		material.transmission *= texture2D( transmissionMap, vTransmissionMapUv ).r;
	#endif
	#ifdef USE_THICKNESSMAP
		material.thickness *= texture2D( thicknessMap, vThicknessMapUv ).g;
	#endif
	vec3 pos = vWorldPosition;
	vec3 v = normalize( cameraPosition - pos );
	vec3 n = transformNormalByInverseViewMatrix( normal, viewMatrix );
	vec4 transmitted = getIBLVolumeRefraction(
		n, v, material.roughness, material.diffuseContribution, material.specularColorBlended, material.specularF90,
		pos, modelMatrix, viewMatrix, projectionMatrix, material.dispersion, material.ior, material.thickness,
		material.attenuationColor, material.attenuationDistance );
	material.transmissionAlpha = mix( material.transmissionAlpha, transmitted.a, material.transmission );
	totalDiffuse = mix( totalDiffuse, transmitted.rgb, material.transmission );
#endif`,Rw=`#ifdef USE_TRANSMISSION
	uniform float transmission;
	uniform float thickness;
	uniform float attenuationDistance;
	uniform vec3 attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		uniform sampler2D transmissionMap;
	#endif
	#ifdef USE_THICKNESSMAP
		uniform sampler2D thicknessMap;
	#endif
	uniform vec2 transmissionSamplerSize;
	uniform sampler2D transmissionSamplerMap;
	uniform mat4 modelMatrix;
	uniform mat4 projectionMatrix;
	varying vec3 vWorldPosition;
	float w0( float a ) {
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - a + 3.0 ) - 3.0 ) + 1.0 );
	}
	float w1( float a ) {
		return ( 1.0 / 6.0 ) * ( a *  a * ( 3.0 * a - 6.0 ) + 4.0 );
	}
	float w2( float a ){
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - 3.0 * a + 3.0 ) + 3.0 ) + 1.0 );
	}
	float w3( float a ) {
		return ( 1.0 / 6.0 ) * ( a * a * a );
	}
	float g0( float a ) {
		return w0( a ) + w1( a );
	}
	float g1( float a ) {
		return w2( a ) + w3( a );
	}
	float h0( float a ) {
		return - 1.0 + w1( a ) / ( w0( a ) + w1( a ) );
	}
	float h1( float a ) {
		return 1.0 + w3( a ) / ( w2( a ) + w3( a ) );
	}
	vec4 bicubic( sampler2D tex, vec2 uv, vec4 texelSize, float lod ) {
		uv = uv * texelSize.zw + 0.5;
		vec2 iuv = floor( uv );
		vec2 fuv = fract( uv );
		float g0x = g0( fuv.x );
		float g1x = g1( fuv.x );
		float h0x = h0( fuv.x );
		float h1x = h1( fuv.x );
		float h0y = h0( fuv.y );
		float h1y = h1( fuv.y );
		vec2 p0 = ( vec2( iuv.x + h0x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p1 = ( vec2( iuv.x + h1x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p2 = ( vec2( iuv.x + h0x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		vec2 p3 = ( vec2( iuv.x + h1x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		return g0( fuv.y ) * ( g0x * textureLod( tex, p0, lod ) + g1x * textureLod( tex, p1, lod ) ) +
			g1( fuv.y ) * ( g0x * textureLod( tex, p2, lod ) + g1x * textureLod( tex, p3, lod ) );
	}
	vec4 textureBicubic( sampler2D sampler, vec2 uv, float lod ) {
		vec2 fLodSize = vec2( textureSize( sampler, int( lod ) ) );
		vec2 cLodSize = vec2( textureSize( sampler, int( lod + 1.0 ) ) );
		vec2 fLodSizeInv = 1.0 / fLodSize;
		vec2 cLodSizeInv = 1.0 / cLodSize;
		vec4 fSample = bicubic( sampler, uv, vec4( fLodSizeInv, fLodSize ), floor( lod ) );
		vec4 cSample = bicubic( sampler, uv, vec4( cLodSizeInv, cLodSize ), ceil( lod ) );
		return mix( fSample, cSample, fract( lod ) );
	}
	vec3 getVolumeTransmissionRay( const in vec3 n, const in vec3 v, const in float thickness, const in float ior, const in mat4 modelMatrix ) {
		vec3 refractionVector = refract( - v, normalize( n ), 1.0 / ior );
		vec3 modelScale;
		modelScale.x = length( vec3( modelMatrix[ 0 ].xyz ) );
		modelScale.y = length( vec3( modelMatrix[ 1 ].xyz ) );
		modelScale.z = length( vec3( modelMatrix[ 2 ].xyz ) );
		return normalize( refractionVector ) * thickness * modelScale;
	}
	float applyIorToRoughness( const in float roughness, const in float ior ) {
		return roughness * clamp( ior * 2.0 - 2.0, 0.0, 1.0 );
	}
	vec4 getTransmissionSample( const in vec2 fragCoord, const in float roughness, const in float ior ) {
		float lod = log2( transmissionSamplerSize.x ) * applyIorToRoughness( roughness, ior );
		return textureBicubic( transmissionSamplerMap, fragCoord.xy, lod );
	}
	vec3 volumeAttenuation( const in float transmissionDistance, const in vec3 attenuationColor, const in float attenuationDistance ) {
		if ( isinf( attenuationDistance ) ) {
			return vec3( 1.0 );
		} else {
			vec3 attenuationCoefficient = -log( attenuationColor ) / attenuationDistance;
			vec3 transmittance = exp( - attenuationCoefficient * transmissionDistance );			return transmittance;
		}
	}
	vec4 getIBLVolumeRefraction( const in vec3 n, const in vec3 v, const in float roughness, const in vec3 diffuseColor,
		const in vec3 specularColor, const in float specularF90, const in vec3 position, const in mat4 modelMatrix,
		const in mat4 viewMatrix, const in mat4 projMatrix, const in float dispersion, const in float ior, const in float thickness,
		const in vec3 attenuationColor, const in float attenuationDistance ) {
		vec4 transmittedLight;
		vec3 transmittance;
		#ifdef USE_DISPERSION
			float halfSpread = ( ior - 1.0 ) * 0.025 * dispersion;
			vec3 iors = vec3( ior - halfSpread, ior, ior + halfSpread );
			for ( int i = 0; i < 3; i ++ ) {
				vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, iors[ i ], modelMatrix );
				vec3 refractedRayExit = position + transmissionRay;
				vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
				vec2 refractionCoords = ndcPos.xy / ndcPos.w;
				refractionCoords += 1.0;
				refractionCoords /= 2.0;
				vec4 transmissionSample = getTransmissionSample( refractionCoords, roughness, iors[ i ] );
				transmittedLight[ i ] = transmissionSample[ i ];
				transmittedLight.a += transmissionSample.a;
				transmittance[ i ] = diffuseColor[ i ] * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance )[ i ];
			}
			transmittedLight.a /= 3.0;
		#else
			vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, ior, modelMatrix );
			vec3 refractedRayExit = position + transmissionRay;
			vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
			vec2 refractionCoords = ndcPos.xy / ndcPos.w;
			refractionCoords += 1.0;
			refractionCoords /= 2.0;
			transmittedLight = getTransmissionSample( refractionCoords, roughness, ior );
			transmittance = diffuseColor * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance );
		#endif
		vec3 attenuatedColor = transmittance * transmittedLight.rgb;
		vec3 F = EnvironmentBRDF( n, v, specularColor, specularF90, roughness );
		float transmittanceFactor = ( transmittance.r + transmittance.g + transmittance.b ) / 3.0;
		return vec4( ( 1.0 - F ) * attenuatedColor, 1.0 - ( 1.0 - transmittedLight.a ) * transmittanceFactor );
	}
#endif`,Cw=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	varying vec2 vDiffuseRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_SPECULARMAP
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,Iw=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	uniform mat3 mapTransform;
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	uniform mat3 alphaMapTransform;
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	uniform mat3 lightMapTransform;
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	uniform mat3 aoMapTransform;
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	uniform mat3 bumpMapTransform;
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	uniform mat3 normalMapTransform;
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_DISPLACEMENTMAP
	uniform mat3 displacementMapTransform;
	varying vec2 vDisplacementMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	uniform mat3 emissiveMapTransform;
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	uniform mat3 metalnessMapTransform;
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	uniform mat3 roughnessMapTransform;
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	uniform mat3 diffuseRoughnessMapTransform;
	varying vec2 vDiffuseRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	uniform mat3 anisotropyMapTransform;
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	uniform mat3 clearcoatMapTransform;
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform mat3 clearcoatNormalMapTransform;
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform mat3 clearcoatRoughnessMapTransform;
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	uniform mat3 sheenColorMapTransform;
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	uniform mat3 sheenRoughnessMapTransform;
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	uniform mat3 iridescenceMapTransform;
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform mat3 iridescenceThicknessMapTransform;
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SPECULARMAP
	uniform mat3 specularMapTransform;
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	uniform mat3 specularColorMapTransform;
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	uniform mat3 specularIntensityMapTransform;
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,Pw=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	vUv = vec3( uv, 1 ).xy;
#endif
#ifdef USE_MAP
	vMapUv = ( mapTransform * vec3( MAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ALPHAMAP
	vAlphaMapUv = ( alphaMapTransform * vec3( ALPHAMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_LIGHTMAP
	vLightMapUv = ( lightMapTransform * vec3( LIGHTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_AOMAP
	vAoMapUv = ( aoMapTransform * vec3( AOMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_BUMPMAP
	vBumpMapUv = ( bumpMapTransform * vec3( BUMPMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_NORMALMAP
	vNormalMapUv = ( normalMapTransform * vec3( NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DISPLACEMENTMAP
	vDisplacementMapUv = ( displacementMapTransform * vec3( DISPLACEMENTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_EMISSIVEMAP
	vEmissiveMapUv = ( emissiveMapTransform * vec3( EMISSIVEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_METALNESSMAP
	vMetalnessMapUv = ( metalnessMapTransform * vec3( METALNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ROUGHNESSMAP
	vRoughnessMapUv = ( roughnessMapTransform * vec3( ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	vDiffuseRoughnessMapUv = ( diffuseRoughnessMapTransform * vec3( DIFFUSE_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ANISOTROPYMAP
	vAnisotropyMapUv = ( anisotropyMapTransform * vec3( ANISOTROPYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOATMAP
	vClearcoatMapUv = ( clearcoatMapTransform * vec3( CLEARCOATMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	vClearcoatNormalMapUv = ( clearcoatNormalMapTransform * vec3( CLEARCOAT_NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	vClearcoatRoughnessMapUv = ( clearcoatRoughnessMapTransform * vec3( CLEARCOAT_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCEMAP
	vIridescenceMapUv = ( iridescenceMapTransform * vec3( IRIDESCENCEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	vIridescenceThicknessMapUv = ( iridescenceThicknessMapTransform * vec3( IRIDESCENCE_THICKNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_COLORMAP
	vSheenColorMapUv = ( sheenColorMapTransform * vec3( SHEEN_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	vSheenRoughnessMapUv = ( sheenRoughnessMapTransform * vec3( SHEEN_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULARMAP
	vSpecularMapUv = ( specularMapTransform * vec3( SPECULARMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_COLORMAP
	vSpecularColorMapUv = ( specularColorMapTransform * vec3( SPECULAR_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	vSpecularIntensityMapUv = ( specularIntensityMapTransform * vec3( SPECULAR_INTENSITYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_TRANSMISSIONMAP
	vTransmissionMapUv = ( transmissionMapTransform * vec3( TRANSMISSIONMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_THICKNESSMAP
	vThicknessMapUv = ( thicknessMapTransform * vec3( THICKNESSMAP_UV, 1 ) ).xy;
#endif`,Lw=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,Nw=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,Dw=`uniform sampler2D t2D;
uniform float backgroundIntensity;
varying vec2 vUv;
void main() {
	vec4 texColor = texture2D( t2D, vUv );
	#ifdef DECODE_VIDEO_TEXTURE
		texColor = vec4( mix( pow( texColor.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), texColor.rgb * 0.0773993808, vec3( lessThanEqual( texColor.rgb, vec3( 0.04045 ) ) ) ), texColor.w );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,Fw=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,Uw=`uniform float backgroundBlurriness;
uniform float backgroundIntensity;
uniform mat3 backgroundRotation;
varying vec3 vWorldDirection;
#include <envmap_common_pars_fragment>
void main() {
	#ifdef ENVMAP_TYPE_PMREM
		vec4 texColor = textureLod( envMap, backgroundRotation * vWorldDirection, roughnessToMip( backgroundBlurriness ) );
	#else
		vec4 texColor = textureCube( envMap, backgroundRotation * vWorldDirection );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,Ow=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,Bw=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,zw=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
varying vec2 vHighPrecisionZW;
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vHighPrecisionZW = gl_Position.zw;
}`,kw=`#if DEPTH_PACKING == 3200
	uniform float opacity;
#endif
#include <common>
#include <packing>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
varying vec2 vHighPrecisionZW;
void main() {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#if DEPTH_PACKING == 3200
		diffuseColor.a = opacity;
	#endif
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <logdepthbuf_fragment>
	#ifdef USE_REVERSED_DEPTH_BUFFER
		float fragCoordZ = vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ];
	#else
		float fragCoordZ = 0.5 * vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ] + 0.5;
	#endif
	#if DEPTH_PACKING == 3200
		gl_FragColor = vec4( vec3( 1.0 - fragCoordZ ), opacity );
	#elif DEPTH_PACKING == 3201
		gl_FragColor = packDepthToRGBA( fragCoordZ );
	#elif DEPTH_PACKING == 3202
		gl_FragColor = vec4( packDepthToRGB( fragCoordZ ), 1.0 );
	#elif DEPTH_PACKING == 3203
		gl_FragColor = vec4( packDepthToRG( fragCoordZ ), 0.0, 1.0 );
	#endif
}`,Vw=`#define DISTANCE
varying vec3 vWorldPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <worldpos_vertex>
	#include <clipping_planes_vertex>
	vWorldPosition = worldPosition.xyz;
}`,Hw=`#define DISTANCE
uniform vec3 referencePosition;
uniform float nearDistance;
uniform float farDistance;
varying vec3 vWorldPosition;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	float dist = length( vWorldPosition - referencePosition );
	dist = ( dist - nearDistance ) / ( farDistance - nearDistance );
	dist = saturate( dist );
	gl_FragColor = vec4( dist, 0.0, 0.0, 1.0 );
}`,Gw=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,Ww=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,Xw=`uniform float scale;
attribute float lineDistance;
varying float vLineDistance;
#include <common>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	vLineDistance = scale * lineDistance;
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,qw=`uniform vec3 diffuse;
uniform float opacity;
uniform float dashSize;
uniform float totalSize;
varying float vLineDistance;
#include <common>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	if ( mod( vLineDistance, totalSize ) > dashSize ) {
		discard;
	}
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,Yw=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#if defined ( USE_ENVMAP ) || defined ( USE_SKINNING )
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinbase_vertex>
		#include <skinnormal_vertex>
		#include <defaultnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <fog_vertex>
}`,$w=`uniform vec3 diffuse;
uniform float opacity;
#ifndef FLAT_SHADED
	varying vec3 vNormal;
#endif
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <fog_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		reflectedLight.indirectDiffuse += lightMapTexel.rgb * lightMapIntensity * RECIPROCAL_PI;
	#else
		reflectedLight.indirectDiffuse += vec3( 1.0 );
	#endif
	#include <aomap_fragment>
	reflectedLight.indirectDiffuse *= diffuseColor.rgb;
	vec3 outgoingLight = reflectedLight.indirectDiffuse;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,Zw=`#define LAMBERT
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,Kw=`#define LAMBERT
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_lambert_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_lambert_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,Jw=`#define MATCAP
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <displacementmap_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
	vViewPosition = - mvPosition.xyz;
}`,jw=`#define MATCAP
uniform vec3 diffuse;
uniform float opacity;
uniform sampler2D matcap;
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	vec3 viewDir = normalize( vViewPosition );
	vec3 x = normalize( vec3( viewDir.z, 0.0, - viewDir.x ) );
	vec3 y = cross( viewDir, x );
	vec2 uv = vec2( dot( x, normal ), dot( y, normal ) ) * 0.495 + 0.5;
	#ifdef USE_MATCAP
		vec4 matcapColor = texture2D( matcap, uv );
	#else
		vec4 matcapColor = vec4( vec3( mix( 0.2, 0.8, uv.y ) ), 1.0 );
	#endif
	vec3 outgoingLight = diffuseColor.rgb * matcapColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,Qw=`#define NORMAL
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	vViewPosition = - mvPosition.xyz;
#endif
}`,eS=`#define NORMAL
uniform float opacity;
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <uv_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( 0.0, 0.0, 0.0, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	gl_FragColor = vec4( normalize( normal ) * 0.5 + 0.5, diffuseColor.a );
	#ifdef OPAQUE
		gl_FragColor.a = 1.0;
	#endif
}`,tS=`#define PHONG
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,nS=`#define PHONG
uniform vec3 diffuse;
uniform vec3 emissive;
uniform vec3 specular;
uniform float shininess;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_phong_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_phong_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + reflectedLight.directSpecular + reflectedLight.indirectSpecular + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,iS=`#define STANDARD
varying vec3 vViewPosition;
#ifdef USE_TRANSMISSION
	varying vec3 vWorldPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
#ifdef USE_TRANSMISSION
	vWorldPosition = worldPosition.xyz;
#endif
}`,rS=`#define STANDARD
#ifdef PHYSICAL
	#define IOR
	#define USE_SPECULAR
#endif
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float roughness;
uniform float metalness;
uniform float opacity;
#ifdef IOR
	uniform float ior;
#endif
#ifdef USE_SPECULAR
	uniform float specularIntensity;
	uniform vec3 specularColor;
	#ifdef USE_SPECULAR_COLORMAP
		uniform sampler2D specularColorMap;
	#endif
	#ifdef USE_SPECULAR_INTENSITYMAP
		uniform sampler2D specularIntensityMap;
	#endif
#endif
#ifdef USE_CLEARCOAT
	uniform float clearcoat;
	uniform float clearcoatRoughness;
#endif
#ifdef USE_DIFFUSE_ROUGHNESS
	uniform float diffuseRoughness;
	#ifdef USE_DIFFUSE_ROUGHNESSMAP
		uniform sampler2D diffuseRoughnessMap;
	#endif
#endif
#ifdef USE_DISPERSION
	uniform float dispersion;
#endif
#ifdef USE_RETROREFLECTION
	uniform float retroreflectivity;
#endif
#ifdef USE_IRIDESCENCE
	uniform float iridescence;
	uniform float iridescenceIOR;
	uniform float iridescenceThicknessMinimum;
	uniform float iridescenceThicknessMaximum;
#endif
#ifdef USE_SHEEN
	uniform vec3 sheenColor;
	uniform float sheenRoughness;
	#ifdef USE_SHEEN_COLORMAP
		uniform sampler2D sheenColorMap;
	#endif
	#ifdef USE_SHEEN_ROUGHNESSMAP
		uniform sampler2D sheenRoughnessMap;
	#endif
#endif
#ifdef USE_ANISOTROPY
	uniform vec2 anisotropyVector;
	#ifdef USE_ANISOTROPYMAP
		uniform sampler2D anisotropyMap;
	#endif
#endif
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <iridescence_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_physical_pars_fragment>
#include <transmission_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <clearcoat_pars_fragment>
#include <iridescence_pars_fragment>
#include <roughnessmap_pars_fragment>
#include <metalnessmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <roughnessmap_fragment>
	#include <metalnessmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <clearcoat_normal_fragment_begin>
	#include <clearcoat_normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_physical_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 totalDiffuse = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse;
	vec3 totalSpecular = reflectedLight.directSpecular + reflectedLight.indirectSpecular;
	#include <transmission_fragment>
	vec3 outgoingLight = totalDiffuse + totalSpecular + totalEmissiveRadiance;
	#ifdef USE_SHEEN
 
		outgoingLight = outgoingLight + sheenSpecularDirect + sheenSpecularIndirect;
 
 	#endif
	#ifdef USE_CLEARCOAT
		float dotNVcc = saturate( dot( geometryClearcoatNormal, geometryViewDir ) );
		vec3 Fcc = F_Schlick( material.clearcoatF0, material.clearcoatF90, dotNVcc );
		outgoingLight = outgoingLight * ( 1.0 - material.clearcoat * Fcc ) + ( clearcoatSpecularDirect + clearcoatSpecularIndirect ) * material.clearcoat;
	#endif
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,sS=`#define TOON
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,oS=`#define TOON
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <gradientmap_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_toon_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_toon_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,aS=`uniform float size;
uniform float scale;
#include <common>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
#ifdef USE_POINTS_UV
	varying vec2 vUv;
	uniform mat3 uvTransform;
#endif
void main() {
	#ifdef USE_POINTS_UV
		vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	#endif
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	gl_PointSize = size;
	#ifdef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) gl_PointSize *= ( scale / - mvPosition.z );
	#endif
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <fog_vertex>
}`,lS=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <color_pars_fragment>
#include <map_particle_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_particle_fragment>
	#include <color_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,cS=`#include <common>
#include <batching_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <shadowmap_pars_vertex>
void main() {
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,uS=`uniform vec3 color;
uniform float opacity;
#include <common>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <logdepthbuf_pars_fragment>
#include <shadowmap_pars_fragment>
#include <shadowmask_pars_fragment>
void main() {
	#include <logdepthbuf_fragment>
	gl_FragColor = vec4( color, opacity * ( 1.0 - getShadowMask() ) );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,hS=`uniform float rotation;
uniform vec2 center;
#include <common>
#include <uv_pars_vertex>
#include <fog_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	vec4 mvPosition = modelViewMatrix[ 3 ];
	vec2 scale = vec2( length( modelMatrix[ 0 ].xyz ), length( modelMatrix[ 1 ].xyz ) );
	#ifndef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) scale *= - mvPosition.z;
	#endif
	vec2 alignedPosition = ( position.xy - ( center - vec2( 0.5 ) ) ) * scale;
	vec2 rotatedPosition;
	rotatedPosition.x = cos( rotation ) * alignedPosition.x - sin( rotation ) * alignedPosition.y;
	rotatedPosition.y = sin( rotation ) * alignedPosition.x + cos( rotation ) * alignedPosition.y;
	mvPosition.xy += rotatedPosition;
	gl_Position = projectionMatrix * mvPosition;
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,fS=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
}`,Et={alphahash_fragment:Dy,alphahash_pars_fragment:Fy,alphamap_fragment:Uy,alphamap_pars_fragment:Oy,alphatest_fragment:By,alphatest_pars_fragment:zy,aomap_fragment:ky,aomap_pars_fragment:Vy,batching_pars_vertex:Hy,batching_vertex:Gy,begin_vertex:Wy,beginnormal_vertex:Xy,bsdfs:qy,iridescence_fragment:Yy,bumpmap_pars_fragment:$y,clipping_planes_fragment:Zy,clipping_planes_pars_fragment:Ky,clipping_planes_pars_vertex:Jy,clipping_planes_vertex:jy,color_fragment:Qy,color_pars_fragment:eb,color_pars_vertex:tb,color_vertex:nb,common:ib,defaultnormal_vertex:rb,displacementmap_pars_vertex:sb,displacementmap_vertex:ob,emissivemap_fragment:ab,emissivemap_pars_fragment:lb,colorspace_fragment:cb,colorspace_pars_fragment:ub,envmap_fragment:hb,envmap_common_pars_fragment:fb,envmap_pars_fragment:db,envmap_pars_vertex:pb,envmap_physical_pars_fragment:Tb,envmap_vertex:mb,fog_vertex:gb,fog_pars_vertex:_b,fog_fragment:xb,fog_pars_fragment:vb,gradientmap_pars_fragment:yb,lightmap_pars_fragment:bb,lights_lambert_fragment:wb,lights_lambert_pars_fragment:Sb,lights_pars_begin:Mb,lights_toon_fragment:Ab,lights_toon_pars_fragment:Eb,lights_phong_fragment:Rb,lights_phong_pars_fragment:Cb,lights_physical_fragment:Ib,lights_physical_pars_fragment:Pb,lights_fragment_begin:Lb,lights_fragment_maps:Nb,lights_fragment_end:Db,lightprobes_pars_fragment:Fb,logdepthbuf_fragment:Ub,logdepthbuf_pars_fragment:Ob,logdepthbuf_pars_vertex:Bb,logdepthbuf_vertex:zb,map_fragment:kb,map_pars_fragment:Vb,map_particle_fragment:Hb,map_particle_pars_fragment:Gb,metalnessmap_fragment:Wb,metalnessmap_pars_fragment:Xb,morphinstance_vertex:qb,morphcolor_vertex:Yb,morphnormal_vertex:$b,morphtarget_pars_vertex:Zb,morphtarget_vertex:Kb,normal_fragment_begin:Jb,normal_fragment_maps:jb,normal_pars_fragment:Qb,normal_pars_vertex:ew,normal_vertex:tw,normalmap_pars_fragment:nw,clearcoat_normal_fragment_begin:iw,clearcoat_normal_fragment_maps:rw,clearcoat_pars_fragment:sw,iridescence_pars_fragment:ow,opaque_fragment:aw,packing:lw,premultiplied_alpha_fragment:cw,project_vertex:uw,dithering_fragment:hw,dithering_pars_fragment:fw,roughnessmap_fragment:dw,roughnessmap_pars_fragment:pw,shadowmap_pars_fragment:mw,shadowmap_pars_vertex:gw,shadowmap_vertex:_w,shadowmask_pars_fragment:xw,skinbase_vertex:vw,skinning_pars_vertex:yw,skinning_vertex:bw,skinnormal_vertex:ww,specularmap_fragment:Sw,specularmap_pars_fragment:Mw,tonemapping_fragment:Tw,tonemapping_pars_fragment:Aw,transmission_fragment:Ew,transmission_pars_fragment:Rw,uv_pars_fragment:Cw,uv_pars_vertex:Iw,uv_vertex:Pw,worldpos_vertex:Lw,background_vert:Nw,background_frag:Dw,backgroundCube_vert:Fw,backgroundCube_frag:Uw,cube_vert:Ow,cube_frag:Bw,depth_vert:zw,depth_frag:kw,distance_vert:Vw,distance_frag:Hw,equirect_vert:Gw,equirect_frag:Ww,linedashed_vert:Xw,linedashed_frag:qw,meshbasic_vert:Yw,meshbasic_frag:$w,meshlambert_vert:Zw,meshlambert_frag:Kw,meshmatcap_vert:Jw,meshmatcap_frag:jw,meshnormal_vert:Qw,meshnormal_frag:eS,meshphong_vert:tS,meshphong_frag:nS,meshphysical_vert:iS,meshphysical_frag:rS,meshtoon_vert:sS,meshtoon_frag:oS,points_vert:aS,points_frag:lS,shadow_vert:cS,shadow_frag:uS,sprite_vert:hS,sprite_frag:fS},Ye={common:{diffuse:{value:new ht(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new dt},alphaMap:{value:null},alphaMapTransform:{value:new dt},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new dt}},envmap:{envMap:{value:null},envMapRotation:{value:new dt},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new dt}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new dt}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new dt},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new dt},normalScale:{value:new xt(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new dt},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new dt}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new dt}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new dt}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new ht(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},sunLights:{value:[],properties:{direction:{},color:{}}},sunLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},sunShadowMatrix:{value:[]},sunShadowCascade:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:[]},probesMin:{value:[]},probesMax:{value:[]},probesResolution:{value:[]}},points:{diffuse:{value:new ht(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new dt},alphaTest:{value:0},uvTransform:{value:new dt}},sprite:{diffuse:{value:new ht(16777215)},opacity:{value:1},center:{value:new xt(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new dt},alphaMap:{value:null},alphaMapTransform:{value:new dt},alphaTest:{value:0}}},Fr={basic:{uniforms:li([Ye.common,Ye.specularmap,Ye.envmap,Ye.aomap,Ye.lightmap,Ye.fog]),vertexShader:Et.meshbasic_vert,fragmentShader:Et.meshbasic_frag},lambert:{uniforms:li([Ye.common,Ye.specularmap,Ye.envmap,Ye.aomap,Ye.lightmap,Ye.emissivemap,Ye.bumpmap,Ye.normalmap,Ye.displacementmap,Ye.fog,Ye.lights,{emissive:{value:new ht(0)},envMapIntensity:{value:1}}]),vertexShader:Et.meshlambert_vert,fragmentShader:Et.meshlambert_frag},phong:{uniforms:li([Ye.common,Ye.specularmap,Ye.envmap,Ye.aomap,Ye.lightmap,Ye.emissivemap,Ye.bumpmap,Ye.normalmap,Ye.displacementmap,Ye.fog,Ye.lights,{emissive:{value:new ht(0)},specular:{value:new ht(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:Et.meshphong_vert,fragmentShader:Et.meshphong_frag},standard:{uniforms:li([Ye.common,Ye.envmap,Ye.aomap,Ye.lightmap,Ye.emissivemap,Ye.bumpmap,Ye.normalmap,Ye.displacementmap,Ye.roughnessmap,Ye.metalnessmap,Ye.fog,Ye.lights,{emissive:{value:new ht(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:Et.meshphysical_vert,fragmentShader:Et.meshphysical_frag},toon:{uniforms:li([Ye.common,Ye.aomap,Ye.lightmap,Ye.emissivemap,Ye.bumpmap,Ye.normalmap,Ye.displacementmap,Ye.gradientmap,Ye.fog,Ye.lights,{emissive:{value:new ht(0)}}]),vertexShader:Et.meshtoon_vert,fragmentShader:Et.meshtoon_frag},matcap:{uniforms:li([Ye.common,Ye.bumpmap,Ye.normalmap,Ye.displacementmap,Ye.fog,{matcap:{value:null}}]),vertexShader:Et.meshmatcap_vert,fragmentShader:Et.meshmatcap_frag},points:{uniforms:li([Ye.points,Ye.fog]),vertexShader:Et.points_vert,fragmentShader:Et.points_frag},dashed:{uniforms:li([Ye.common,Ye.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:Et.linedashed_vert,fragmentShader:Et.linedashed_frag},depth:{uniforms:li([Ye.common,Ye.displacementmap]),vertexShader:Et.depth_vert,fragmentShader:Et.depth_frag},normal:{uniforms:li([Ye.common,Ye.bumpmap,Ye.normalmap,Ye.displacementmap,{opacity:{value:1}}]),vertexShader:Et.meshnormal_vert,fragmentShader:Et.meshnormal_frag},sprite:{uniforms:li([Ye.sprite,Ye.fog]),vertexShader:Et.sprite_vert,fragmentShader:Et.sprite_frag},background:{uniforms:{uvTransform:{value:new dt},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:Et.background_vert,fragmentShader:Et.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new dt}},vertexShader:Et.backgroundCube_vert,fragmentShader:Et.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:Et.cube_vert,fragmentShader:Et.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:Et.equirect_vert,fragmentShader:Et.equirect_frag},distance:{uniforms:li([Ye.common,Ye.displacementmap,{referencePosition:{value:new J},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:Et.distance_vert,fragmentShader:Et.distance_frag},shadow:{uniforms:li([Ye.lights,Ye.fog,{color:{value:new ht(0)},opacity:{value:1}}]),vertexShader:Et.shadow_vert,fragmentShader:Et.shadow_frag}};Fr.physical={uniforms:li([Fr.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new dt},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new dt},clearcoatNormalScale:{value:new xt(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new dt},diffuseRoughness:{value:0},diffuseRoughnessMap:{value:null},diffuseRoughnessMapTransform:{value:new dt},dispersion:{value:0},retroreflectivity:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new dt},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new dt},sheen:{value:0},sheenColor:{value:new ht(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new dt},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new dt},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new dt},transmissionSamplerSize:{value:new xt},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new dt},attenuationDistance:{value:0},attenuationColor:{value:new ht(0)},specularColor:{value:new ht(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new dt},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new dt},anisotropyVector:{value:new xt},anisotropyMap:{value:null},anisotropyMapTransform:{value:new dt}}]),vertexShader:Et.meshphysical_vert,fragmentShader:Et.meshphysical_frag};var qu={r:0,b:0,g:0},dS=new it,Ng=new dt;Ng.set(-1,0,0,0,1,0,0,0,1);function pS(i,e,t,n,r,s){let o=new ht(0),a=r===!0?0:1,l,c,u=null,h=0,f=null;function d(S){let T=S.isScene===!0?S.background:null;if(T&&T.isTexture){let M=S.backgroundBlurriness>0;T=e.get(T,M)}return T}function m(S){let T=!1,M=d(S);M===null?g(o,a):M&&M.isColor&&(g(M,1),T=!0);let P=i.xr.getEnvironmentBlendMode();P==="additive"?t.buffers.color.setClear(0,0,0,1,s):P==="alpha-blend"&&t.buffers.color.setClear(0,0,0,0,s),(i.autoClear||T)&&(t.buffers.depth.setTest(!0),t.buffers.depth.setMask(!0),t.buffers.color.setMask(!0),i.clear(i.autoClearColor,i.autoClearDepth,i.autoClearStencil))}function b(S,T){let M=d(T);M&&M.isCubeTexture?(c===void 0&&(c=new In(new sa(1,1,1),new Cr({name:"BackgroundCubeMaterial",uniforms:go(Fr.backgroundCube.uniforms),vertexShader:Fr.backgroundCube.vertexShader,fragmentShader:Fr.backgroundCube.fragmentShader,side:mi,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),c.geometry.deleteAttribute("uv"),c.onBeforeRender=function(P,R,y){this.matrixWorld.copyPosition(y.matrixWorld)},Object.defineProperty(c.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),n.update(c)),c.material.uniforms.envMap.value=M,c.material.uniforms.backgroundBlurriness.value=T.backgroundBlurriness,c.material.uniforms.backgroundIntensity.value=T.backgroundIntensity,c.material.uniforms.backgroundRotation.value.setFromMatrix4(dS.makeRotationFromEuler(T.backgroundRotation)).transpose(),M.isRenderTargetTexture===!1&&c.material.uniforms.backgroundRotation.value.premultiply(Ng),c.material.toneMapped=Rt.getTransfer(M.colorSpace)!==Yt,(u!==M||h!==M.version||f!==i.toneMapping)&&(c.material.needsUpdate=!0,u=M,h=M.version,f=i.toneMapping),c.layers.enableAll(),S.unshift(c,c.geometry,c.material,0,0,null)):M&&M.isTexture&&(l===void 0&&(l=new In(new gl(2,2),new Cr({name:"BackgroundMaterial",uniforms:go(Fr.background.uniforms),vertexShader:Fr.background.vertexShader,fragmentShader:Fr.background.fragmentShader,side:Pr,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),l.geometry.deleteAttribute("normal"),Object.defineProperty(l.material,"map",{get:function(){return this.uniforms.t2D.value}}),n.update(l)),l.material.uniforms.t2D.value=M,l.material.uniforms.backgroundIntensity.value=T.backgroundIntensity,l.material.toneMapped=Rt.getTransfer(M.colorSpace)!==Yt,M.matrixAutoUpdate===!0&&M.updateMatrix(),l.material.uniforms.uvTransform.value.copy(M.matrix),(u!==M||h!==M.version||f!==i.toneMapping)&&(l.material.needsUpdate=!0,u=M,h=M.version,f=i.toneMapping),l.layers.enableAll(),S.unshift(l,l.geometry,l.material,0,0,null))}function g(S,T){S.getRGB(qu,dd(i)),t.buffers.color.setClear(qu.r,qu.g,qu.b,T,s)}function _(){c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0),l!==void 0&&(l.geometry.dispose(),l.material.dispose(),l=void 0)}return{getClearColor:function(){return o},setClearColor:function(S,T=1){o.set(S),a=T,g(o,a)},getClearAlpha:function(){return a},setClearAlpha:function(S){a=S,g(o,a)},render:m,addToRenderList:b,dispose:_}}function mS(i,e){let t=i.getParameter(i.MAX_VERTEX_ATTRIBS),n={},r=f(null),s=r,o=!1;function a(D,q,Y,U,W){let K=!1,$=h(D,U,Y,q);s!==$&&(s=$,c(s.object)),K=d(D,U,Y,W),K&&m(D,U,Y,W),W!==null&&e.update(W,i.ELEMENT_ARRAY_BUFFER),(K||o)&&(o=!1,M(D,q,Y,U),W!==null&&i.bindBuffer(i.ELEMENT_ARRAY_BUFFER,e.get(W).buffer))}function l(){return i.createVertexArray()}function c(D){return i.bindVertexArray(D)}function u(D){return i.deleteVertexArray(D)}function h(D,q,Y,U){let W=U.wireframe===!0,K=n[q.id];K===void 0&&(K={},n[q.id]=K);let $=D.isInstancedMesh===!0?D.id:0,xe=K[$];xe===void 0&&(xe={},K[$]=xe);let ne=xe[Y.id];ne===void 0&&(ne={},xe[Y.id]=ne);let re=ne[W];return re===void 0&&(re=f(l()),ne[W]=re),re}function f(D){let q=[],Y=[],U=[];for(let W=0;W<t;W++)q[W]=0,Y[W]=0,U[W]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:q,enabledAttributes:Y,attributeDivisors:U,object:D,attributes:{},index:null}}function d(D,q,Y,U){let W=s.attributes,K=q.attributes,$=0,xe=Y.getAttributes();for(let ne in xe)if(xe[ne].location>=0){let de=W[ne],ge=K[ne];if(ge===void 0&&(ne==="instanceMatrix"&&D.instanceMatrix&&(ge=D.instanceMatrix),ne==="instanceColor"&&D.instanceColor&&(ge=D.instanceColor)),de===void 0||de.attribute!==ge||ge&&de.data!==ge.data)return!0;$++}return s.attributesNum!==$||s.index!==U}function m(D,q,Y,U){let W={},K=q.attributes,$=0,xe=Y.getAttributes();for(let ne in xe)if(xe[ne].location>=0){let de=K[ne];de===void 0&&(ne==="instanceMatrix"&&D.instanceMatrix&&(de=D.instanceMatrix),ne==="instanceColor"&&D.instanceColor&&(de=D.instanceColor));let ge={};ge.attribute=de,de&&de.data&&(ge.data=de.data),W[ne]=ge,$++}s.attributes=W,s.attributesNum=$,s.index=U}function b(){let D=s.newAttributes;for(let q=0,Y=D.length;q<Y;q++)D[q]=0}function g(D){_(D,0)}function _(D,q){let Y=s.newAttributes,U=s.enabledAttributes,W=s.attributeDivisors;Y[D]=1,U[D]===0&&(i.enableVertexAttribArray(D),U[D]=1),W[D]!==q&&(i.vertexAttribDivisor(D,q),W[D]=q)}function S(){let D=s.newAttributes,q=s.enabledAttributes;for(let Y=0,U=q.length;Y<U;Y++)q[Y]!==D[Y]&&(i.disableVertexAttribArray(Y),q[Y]=0)}function T(D,q,Y,U,W,K,$){$===!0?i.vertexAttribIPointer(D,q,Y,W,K):i.vertexAttribPointer(D,q,Y,U,W,K)}function M(D,q,Y,U){b();let W=U.attributes,K=Y.getAttributes(),$=q.defaultAttributeValues;for(let xe in K){let ne=K[xe];if(ne.location>=0){let re=W[xe];if(re===void 0&&(xe==="instanceMatrix"&&D.instanceMatrix&&(re=D.instanceMatrix),xe==="instanceColor"&&D.instanceColor&&(re=D.instanceColor)),re!==void 0){let de=re.normalized,ge=re.itemSize,pe=e.get(re);if(pe===void 0)continue;let se=pe.buffer,Ee=pe.type,Pe=pe.bytesPerElement,Oe=Ee===i.INT||Ee===i.UNSIGNED_INT||re.gpuType===lu;if(re.isInterleavedBufferAttribute){let ye=re.data,Ke=ye.isInterleavedBuffer===!0?ye.stride:ye.itemSize,ft=re.offset;if(ye.isInstancedInterleavedBuffer||ye.isInstancedBufferAttribute){for(let et=0;et<ne.locationSize;et++)_(ne.location+et,ye.meshPerAttribute);D.isInstancedMesh!==!0&&U._maxInstanceCount===void 0&&(U._maxInstanceCount=ye.meshPerAttribute*ye.count)}else for(let et=0;et<ne.locationSize;et++)g(ne.location+et);i.bindBuffer(i.ARRAY_BUFFER,se);for(let et=0;et<ne.locationSize;et++)T(ne.location+et,ge/ne.locationSize,Ee,de,Ke*Pe,(ft+ge/ne.locationSize*et)*Pe,Oe)}else{if(re.isInstancedBufferAttribute){for(let ye=0;ye<ne.locationSize;ye++)_(ne.location+ye,re.meshPerAttribute);D.isInstancedMesh!==!0&&U._maxInstanceCount===void 0&&(U._maxInstanceCount=re.meshPerAttribute*re.count)}else for(let ye=0;ye<ne.locationSize;ye++)g(ne.location+ye);i.bindBuffer(i.ARRAY_BUFFER,se);for(let ye=0;ye<ne.locationSize;ye++)T(ne.location+ye,ge/ne.locationSize,Ee,de,ge*Pe,ge/ne.locationSize*ye*Pe,Oe)}}else if($!==void 0){let de=$[xe];if(de!==void 0)switch(de.length){case 2:i.vertexAttrib2fv(ne.location,de);break;case 3:i.vertexAttrib3fv(ne.location,de);break;case 4:i.vertexAttrib4fv(ne.location,de);break;default:i.vertexAttrib1fv(ne.location,de)}}}}S()}function P(){V();for(let D in n){let q=n[D];for(let Y in q){let U=q[Y];for(let W in U){let K=U[W];for(let $ in K)u(K[$].object),delete K[$];delete U[W]}}delete n[D]}}function R(D){if(n[D.id]===void 0)return;let q=n[D.id];for(let Y in q){let U=q[Y];for(let W in U){let K=U[W];for(let $ in K)u(K[$].object),delete K[$];delete U[W]}}delete n[D.id]}function y(D){for(let q in n){let Y=n[q];for(let U in Y){let W=Y[U];if(W[D.id]===void 0)continue;let K=W[D.id];for(let $ in K)u(K[$].object),delete K[$];delete W[D.id]}}}function A(D){for(let q in n){let Y=n[q],U=D.isInstancedMesh===!0?D.id:0,W=Y[U];if(W!==void 0){for(let K in W){let $=W[K];for(let xe in $)u($[xe].object),delete $[xe];delete W[K]}delete Y[U],Object.keys(Y).length===0&&delete n[q]}}}function V(){z(),o=!0,s!==r&&(s=r,c(s.object))}function z(){r.geometry=null,r.program=null,r.wireframe=!1}return{setup:a,reset:V,resetDefaultState:z,dispose:P,releaseStatesOfGeometry:R,releaseStatesOfObject:A,releaseStatesOfProgram:y,initAttributes:b,enableAttribute:g,disableUnusedAttributes:S}}function gS(i,e,t){let n;function r(l){n=l}function s(l,c){i.drawArrays(n,l,c),t.update(c,n,1)}function o(l,c,u){u!==0&&(i.drawArraysInstanced(n,l,c,u),t.update(c,n,u))}function a(l,c,u){if(u===0)return;e.get("WEBGL_multi_draw").multiDrawArraysWEBGL(n,l,0,c,0,u);let f=0;for(let d=0;d<u;d++)f+=c[d];t.update(f,n,1)}this.setMode=r,this.render=s,this.renderInstances=o,this.renderMultiDraw=a}function _S(i,e,t,n){let r;function s(){if(r!==void 0)return r;if(e.has("EXT_texture_filter_anisotropic")===!0){let y=e.get("EXT_texture_filter_anisotropic");r=i.getParameter(y.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else r=0;return r}function o(y){return!(y!==jt&&n.convert(y)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(y){let A=y===tn&&(e.has("EXT_color_buffer_half_float")||e.has("EXT_color_buffer_float"));return!(y!==bi&&y!==Nt&&!A&&n.convert(y)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_TYPE))}function l(y){if(y==="highp"){if(i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.HIGH_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.HIGH_FLOAT).precision>0)return"highp";y="mediump"}return y==="mediump"&&i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.MEDIUM_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let c=t.precision!==void 0?t.precision:"highp",u=l(c);u!==c&&(nt("WebGLRenderer:",c,"not supported, using",u,"instead."),c=u);let h=t.reversedDepthBuffer===!0&&e.has("EXT_clip_control"),f=t.logarithmicDepthBuffer===!0&&h===!1;t.reversedDepthBuffer===!0&&h===!1&&nt("WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer."),t.logarithmicDepthBuffer===!0&&h===!0&&nt("WebGLRenderer: Logarithmic depth buffer is ignored when reversed depth buffer is enabled.");let d=i.getParameter(i.MAX_TEXTURE_IMAGE_UNITS),m=i.getParameter(i.MAX_VERTEX_TEXTURE_IMAGE_UNITS),b=i.getParameter(i.MAX_TEXTURE_SIZE),g=i.getParameter(i.MAX_CUBE_MAP_TEXTURE_SIZE),_=i.getParameter(i.MAX_VERTEX_ATTRIBS),S=i.getParameter(i.MAX_VERTEX_UNIFORM_VECTORS),T=i.getParameter(i.MAX_VARYING_VECTORS),M=i.getParameter(i.MAX_FRAGMENT_UNIFORM_VECTORS),P=i.getParameter(i.MAX_SAMPLES),R=i.getParameter(i.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:s,getMaxPrecision:l,textureFormatReadable:o,textureTypeReadable:a,precision:c,logarithmicDepthBuffer:f,reversedDepthBuffer:h,maxTextures:d,maxVertexTextures:m,maxTextureSize:b,maxCubemapSize:g,maxAttributes:_,maxVertexUniforms:S,maxVaryings:T,maxFragmentUniforms:M,maxSamples:P,samples:R}}function xS(i){let e=this,t=null,n=0,r=!1,s=!1,o=new ar,a=new dt,l={value:null,needsUpdate:!1};this.uniform=l,this.numPlanes=0,this.numIntersection=0,this.init=function(h,f){let d=h.length!==0||f||n!==0||r;return r=f,n=h.length,d},this.beginShadows=function(){s=!0,u(null)},this.endShadows=function(){s=!1},this.setGlobalState=function(h,f){t=u(h,f,0)},this.setState=function(h,f,d){let m=h.clippingPlanes,b=h.clipIntersection,g=h.clipShadows,_=i.get(h);if(!r||m===null||m.length===0||s&&!g)s?u(null):c();else{let S=s?0:n,T=S*4,M=_.clippingState||null;l.value=M,M=u(m,f,T,d);for(let P=0;P!==T;++P)M[P]=t[P];_.clippingState=M,this.numIntersection=b?this.numPlanes:0,this.numPlanes+=S}};function c(){l.value!==t&&(l.value=t,l.needsUpdate=n>0),e.numPlanes=n,e.numIntersection=0}function u(h,f,d,m){let b=h!==null?h.length:0,g=null;if(b!==0){if(g=l.value,m!==!0||g===null){let _=d+b*4,S=f.matrixWorldInverse;a.getNormalMatrix(S),(g===null||g.length<_)&&(g=new Float32Array(_));for(let T=0,M=d;T!==b;++T,M+=4)o.copy(h[T]).applyMatrix4(S,a),o.normal.toArray(g,M),g[M+3]=o.constant}l.value=g,l.needsUpdate=!0}return e.numPlanes=b,e.numIntersection=0,g}}var Ol=class extends Zn{constructor(e=1,t={}){super(e,e,t),this.isWebGLCubeRenderTarget=!0;let n={width:e,height:e,depth:1},r=[n,n,n,n,n,n];this.texture=new dl(r),this._setTextureOptions(t),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(e,t){this.texture.type=t.type,this.texture.colorSpace=t.colorSpace,this.texture.generateMipmaps=t.generateMipmaps,this.texture.minFilter=t.minFilter,this.texture.magFilter=t.magFilter;let n={uniforms:{tEquirect:{value:null}},vertexShader:`

				varying vec3 vWorldDirection;

				vec3 transformDirection( in vec3 dir, in mat4 matrix ) {

					return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );

				}

				void main() {

					vWorldDirection = transformDirection( position, modelMatrix );

					#include <begin_vertex>
					#include <project_vertex>

				}
			`,fragmentShader:`

				uniform sampler2D tEquirect;

				varying vec3 vWorldDirection;

				#include <common>

				void main() {

					vec3 direction = normalize( vWorldDirection );

					vec2 sampleUV = equirectUv( direction );

					gl_FragColor = texture2D( tEquirect, sampleUV );

				}
			`},r=new sa(5,5,5),s=new Cr({name:"CubemapFromEquirect",uniforms:go(n.uniforms),vertexShader:n.vertexShader,fragmentShader:n.fragmentShader,side:mi,blending:uo});s.uniforms.tEquirect.value=t;let o=new In(r,s),a=t.minFilter;return t.minFilter===Fi&&(t.minFilter=qt),new ca(1,10,this).update(e,o),t.minFilter=a,o.geometry.dispose(),o.material.dispose(),this}clear(e,t=!0,n=!0,r=!0){let s=e.getRenderTarget();for(let o=0;o<6;o++)e.setRenderTarget(this,o),e.clear(t,n,r);e.setRenderTarget(s)}},hg=256,vS=3,yS=20,Dg=256,Fg=16,bS=3,wS=new J,SS=new ht,$u=class i{constructor(e){this._renderer=e,this._cubeSize=0,this._sourceTarget=null,this._cubeCamera=new ca(1,10,null),this._boxMesh=new In(new sa(5,5,5),null),this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null,this._integrationMaterial=null}fromScene(e,t=0,n=.1,r=100,s={}){let{size:o=256,position:a=wS}=s,l=this._renderer;this._setSize(o);let c=this._allocateTarget(),u=this._getSourceTarget(!0);t>0&&(u.texture.mipmapsAutoUpdate=!1);let h=l.autoClear,f=l.autoClearColor,d=l.autoClearDepth,m=l.autoClearStencil,b=e.background;l.autoClear=!0,l.autoClearColor=!0,l.autoClearDepth=!0,l.autoClearStencil=!0,b===null&&(e.background=l.getClearColor(SS));let g=new ca(n,r,u);return g.position.copy(a),g.update(l,e),l.autoClear=h,l.autoClearColor=f,l.autoClearDepth=d,l.autoClearStencil=m,e.background=b,t>0&&(u.texture.mipmapsAutoUpdate=!0,this._blur(c,t)),this._applyPMREM(c),c}fromEquirectangular(e,t=null){return this._fromTexture(e,t)}fromCubemap(e,t=null){return this._fromTexture(e,t)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=pg(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=dg(),this._compileMaterial(this._equirectMaterial))}dispose(){this._sourceTarget!==null&&this._sourceTarget.dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._integrationMaterial!==null&&this._integrationMaterial.dispose(),this._boxMesh.geometry.dispose()}static lodToRoughness(e,t){return t>0?1-Math.sqrt(1-e/t):0}_setSize(e){this._cubeSize=Math.max(hg,ud(e))}_fromTexture(e,t){e.mapping===fo||e.mapping===fa?this._setSize(e.image.length===0?hg:e.image[0].width||e.image[0].image.width):this._setSize(e.image.width/4);let n=t||this._allocateTarget();return this._textureToCubemap(e),this._applyPMREM(n),n}_allocateTarget(){let e=this._cubeSize,t=fg(e,!1,!1),n=Math.log2(e)-vS;for(let r=0;r<=n;r++)t.texture.mipmaps.push({width:e>>r,height:e>>r});return t.texture.name="PMREM",t.texture.isPMREMTexture=!0,t}_getSourceTarget(e=!1){let t=this._cubeSize,n=this._sourceTarget;return(n===null||n.width!==t||e&&n.depthBuffer===!1)&&(n!==null&&n.dispose(),this._sourceTarget=fg(t,!0,e)),this._sourceTarget}_compileMaterial(e){this._boxMesh.material=e,this._renderer.compile(this._boxMesh,this._cubeCamera.children[0])}_renderCube(e,t,n){let r=this._boxMesh,s=this._cubeCamera;r.material=n,s.renderTarget=e,s.activeMipmapLevel=t;let o=e.width>>t;e.viewport.set(0,0,o,o),s.update(this._renderer,r),e.viewport.set(0,0,e.width,e.height)}_textureToCubemap(e){let t;e.mapping===fo||e.mapping===fa?(this._cubemapMaterial===null&&(this._cubemapMaterial=pg()),t=this._cubemapMaterial,t.uniforms.flipEnvMap.value=e.isRenderTargetTexture===!1?-1:1):(this._equirectMaterial===null&&(this._equirectMaterial=dg()),t=this._equirectMaterial),t.uniforms.envMap.value=e,this._renderCube(this._getSourceTarget(),0,t)}_applyPMREM(e){this._ggxMaterial===null&&(this._ggxMaterial=MS(),this._integrationMaterial=TS());let t=this._cubeSize,n=e.texture.mipmaps.length-1,r=this._ggxMaterial.uniforms;r.envMap.value=this._sourceTarget.texture;let s=this._integrationMaterial.uniforms;s.envMap.value=this._sourceTarget.texture,s.sourceLod.value=Math.log2(t/Fg);for(let o=0;o<=n;o++){let a=i.lodToRoughness(o,n);if(o>n-bS)s.roughness.value=a,this._renderCube(e,o,this._integrationMaterial);else{let l=a>0?Math.log2(t)+.5*Math.log2(6/(Dg*Math.pow(a,4)))+.5:0;r.roughness.value=a,r.lodBias.value=l,this._renderCube(e,o,this._ggxMaterial)}}}_blur(e,t){this._blurMaterial===null&&(this._blurMaterial=AS());let n=this._blurMaterial,r=n.uniforms,s=this._sourceTarget;r.sigma.value=Math.min(t,Math.PI)/Math.SQRT2,r.envMap.value=s.texture,this._renderCube(e,0,n),r.envMap.value=e.texture,this._renderCube(s,0,n)}};function fg(i,e,t){return new Ol(i,{minFilter:Fi,generateMipmaps:e,type:tn,colorSpace:dn,depthBuffer:t})}function Bl(i,e,t){return new Cr({name:i,uniforms:e,vertexShader:Et.cube_vert,fragmentShader:t,side:mi,blending:uo,depthTest:!1,depthWrite:!1})}function MS(){return Bl("PMREMGGXConvolution",{envMap:{value:null},roughness:{value:0},lodBias:{value:0}},`

		#define GGX_SAMPLES ${Dg}u

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float roughness;
		uniform float lodBias;

		#include <common>

		// Van der Corput radical inverse
		float radicalInverse_VdC( uint bits ) {

			bits = ( bits << 16u ) | ( bits >> 16u );
			bits = ( ( bits & 0x55555555u ) << 1u ) | ( ( bits & 0xAAAAAAAAu ) >> 1u );
			bits = ( ( bits & 0x33333333u ) << 2u ) | ( ( bits & 0xCCCCCCCCu ) >> 2u );
			bits = ( ( bits & 0x0F0F0F0Fu ) << 4u ) | ( ( bits & 0xF0F0F0F0u ) >> 4u );
			bits = ( ( bits & 0x00FF00FFu ) << 8u ) | ( ( bits & 0xFF00FF00u ) >> 8u );
			return float( bits ) * 2.3283064365386963e-10; // / 0x100000000

		}

		// Hammersley sequence
		vec2 hammersley( uint i, uint N ) {

			return vec2( float( i ) / float( N ), radicalInverse_VdC( i ) );

		}

		void main() {

			vec3 N = normalize( vWorldDirection );

			// For very low roughness, just sample the environment directly
			if ( roughness < 0.001 ) {

				gl_FragColor = vec4( textureLod( envMap, N, 0.0 ).rgb, 1.0 );
				return;

			}

			float alpha = roughness * roughness;
			float alpha2 = alpha * alpha;

			// Tangent space basis for VNDF sampling
			vec3 up = abs( N.z ) < 0.999 ? vec3( 0.0, 0.0, 1.0 ) : vec3( 1.0, 0.0, 0.0 );
			vec3 tangent = normalize( cross( up, N ) );
			vec3 bitangent = cross( N, tangent );

			vec3 prefilteredColor = vec3( 0.0 );
			float totalWeight = 0.0;

			for ( uint i = 0u; i < GGX_SAMPLES; i ++ ) {

				vec2 Xi = hammersley( i, GGX_SAMPLES );

				// With V = N, sample the reflected direction directly.
				float invQ = 1.0 / ( 1.0 - Xi.x + alpha2 * Xi.x );
				float NdotL = ( 1.0 - Xi.x - alpha2 * Xi.x ) * invQ;

				if ( NdotL > 0.0 ) {

					float phi = 2.0 * PI * Xi.y;
					float sinTheta = 2.0 * alpha * sqrt( Xi.x * ( 1.0 - Xi.x ) ) * invQ;
					vec3 L = N * NdotL + ( tangent * cos( phi ) + bitangent * sin( phi ) ) * sinTheta;

					// Match the source mip to the sample's solid angle. The terms
					// independent of the sample are precomputed in lodBias.
					float d = alpha2 * invQ;
					float lod = max( log2( d ) + lodBias, 0.0 );

					// Weight by NdotL for the split-sum approximation
					prefilteredColor += textureLod( envMap, L, lod ).rgb * NdotL;
					totalWeight += NdotL;

				}

			}

			gl_FragColor = vec4( prefilteredColor / totalWeight, 1.0 );

		}
	`)}function TS(){return Bl("PMREMGGXIntegration",{envMap:{value:null},roughness:{value:0},sourceLod:{value:0},sourceSize:{value:Fg}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float roughness;
		uniform float sourceLod;
		uniform int sourceSize;

		void main() {

			vec3 N = normalize( vWorldDirection );

			float alpha = roughness * roughness;
			float alpha2 = alpha * alpha;

			float texelSize = 2.0 / float( sourceSize );

			vec3 prefilteredColor = vec3( 0.0 );
			float totalWeight = 0.0;

			// Pair opposite texels: only the one in N's hemisphere contributes.
			for ( int face = 0; face < 3; face ++ ) {

				for ( int y = 0; y < sourceSize; y ++ ) {

					for ( int x = 0; x < sourceSize; x ++ ) {

						vec2 uv = ( vec2( x, y ) + 0.5 ) * texelSize - 1.0;
						vec3 texelDirection = face == 0 ? vec3( 1.0, uv ) : ( face == 1 ? vec3( uv.x, 1.0, uv.y ) : vec3( uv, 1.0 ) );

						float invDistance = inversesqrt( 1.0 + dot( uv, uv ) );
						float NdotL = dot( N, texelDirection );
						texelDirection *= NdotL < 0.0 ? - 1.0 : 1.0;
						NdotL = abs( NdotL ) * invDistance;

						// With V = N, NdotH squared is ( 1 + NdotL ) / 2. Common factors
						// in the GGX distribution and texel solid angle cancel when normalized.
						float d = 1.0 + alpha2 + ( alpha2 - 1.0 ) * NdotL;
						float weight = NdotL * invDistance * invDistance * invDistance / ( d * d );

						prefilteredColor += textureLod( envMap, texelDirection, sourceLod ).rgb * weight;
						totalWeight += weight;

					}

				}

			}

			gl_FragColor = vec4( prefilteredColor / totalWeight, 1.0 );

		}
	`)}function AS(){return Bl("PMREMSphericalGaussianBlur",{envMap:{value:null},sigma:{value:0}},`

		#define SAMPLES ${yS}
		#define GOLDEN_ANGLE 2.39996322973

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float sigma;

		#include <common>

		void main() {

			vec3 outputDirection = normalize( vWorldDirection );

			vec3 up = abs( outputDirection.z ) < 0.999 ? vec3( 0.0, 0.0, 1.0 ) : vec3( 1.0, 0.0, 0.0 );
			vec3 tangent = normalize( cross( up, outputDirection ) );
			vec3 bitangent = cross( outputDirection, tangent );

			// Truncate the kernel at three standard deviations or at the antipode.
			float thetaMax = min( 3.0 * sigma, PI );
			float truncation = 1.0 - exp( - 0.5 * thetaMax * thetaMax / ( sigma * sigma ) );

			vec3 accumColor = vec3( 0.0 );
			float accumWeight = 0.0;

			for ( int i = 0; i < SAMPLES; i ++ ) {

				// Stratified inverse-CDF sampling of the Gaussian, placed on a golden-angle spiral.
				float stratum = ( float( i ) + 0.5 ) / float( SAMPLES );
				float theta = sigma * sqrt( - 2.0 * log( 1.0 - stratum * truncation ) );
				float phi = float( i ) * GOLDEN_ANGLE;

				vec3 offset = cos( phi ) * tangent + sin( phi ) * bitangent;
				vec3 sampleDirection = cos( theta ) * outputDirection + sin( theta ) * offset;

				// Correct the planar sample density to solid angle.
				float weight = sin( theta ) / theta;

				accumColor += weight * textureLod( envMap, sampleDirection, 0.0 ).rgb;
				accumWeight += weight;

			}

			gl_FragColor = vec4( accumColor / accumWeight, 1.0 );

		}
	`)}function dg(){return Bl("PMREMEquirectangularToCubemap",{envMap:{value:null}},`

		varying vec3 vWorldDirection;

		uniform sampler2D envMap;

		#include <common>

		void main() {

			// Average four subpixel samples to preserve small, bright features.
			vec3 direction = normalize( vWorldDirection );
			vec3 dx = dFdx( direction ) * 0.25;
			vec3 dy = dFdy( direction ) * 0.25;

			vec3 color = textureLod( envMap, equirectUv( normalize( direction - dx - dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction + dx - dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction - dx + dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction + dx + dy ) ), 0.0 ).rgb;
			gl_FragColor = vec4( color * 0.25, 1.0 );

		}
	`)}function pg(){return Bl("PMREMCubemapToCubemap",{envMap:{value:null},flipEnvMap:{value:-1}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float flipEnvMap;

		void main() {

			gl_FragColor = vec4( textureCube( envMap, vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) ).rgb, 1.0 );

		}
	`)}function ES(i){let e=new WeakMap,t=new WeakMap,n=null;function r(f,d=!1){return f==null?null:d?o(f):s(f)}function s(f){if(f&&f.isTexture){let d=f.mapping;if(d===su||d===ou)if(e.has(f)){let m=e.get(f).texture;return a(m,f.mapping)}else{let m=f.image;if(m&&m.height>0){let b=new Ol(m.height);return b.fromEquirectangularTexture(i,f),e.set(f,b),f.addEventListener("dispose",c),a(b.texture,f.mapping)}else return null}}return f}function o(f){if(f&&f.isTexture&&f.isPMREMTexture!==!0){let d=f.mapping,m=d===su||d===ou,b=d===fo||d===fa;if(m||b){let g=t.get(f),_=g!==void 0?g.texture.pmremVersion:0;if(f.isRenderTargetTexture&&f.pmremVersion!==_)return n===null&&(n=new $u(i)),g=m?n.fromEquirectangular(f,g):n.fromCubemap(f,g),g.texture.pmremVersion=f.pmremVersion,t.set(f,g),g.texture;if(g!==void 0)return g.texture;{let S=f.image;return m&&S&&S.height>0||b&&S&&l(S)?(n===null&&(n=new $u(i)),g=m?n.fromEquirectangular(f):n.fromCubemap(f),g.texture.pmremVersion=f.pmremVersion,t.set(f,g),f.addEventListener("dispose",u),g.texture):null}}}return f}function a(f,d){return d===su?f.mapping=fo:d===ou&&(f.mapping=fa),f}function l(f){let d=0,m=6;for(let b=0;b<m;b++)f[b]!==void 0&&d++;return d===m}function c(f){let d=f.target;d.removeEventListener("dispose",c);let m=e.get(d);m!==void 0&&(e.delete(d),m.dispose())}function u(f){let d=f.target;d.removeEventListener("dispose",u);let m=t.get(d);m!==void 0&&(t.delete(d),m.dispose())}function h(){e=new WeakMap,t=new WeakMap,n!==null&&(n.dispose(),n=null)}return{get:r,dispose:h}}function RS(i){let e={};function t(n){if(e[n]!==void 0)return e[n];let r=i.getExtension(n);return e[n]=r,r}return{has:function(n){return t(n)!==null},init:function(){t("EXT_color_buffer_float"),t("WEBGL_clip_cull_distance"),t("OES_texture_float_linear"),t("EXT_color_buffer_half_float"),t("WEBGL_multisampled_render_to_texture"),t("WEBGL_render_shared_exponent")},get:function(n){let r=t(n);return r===null&&Qs("WebGLRenderer: "+n+" extension not supported."),r}}}function CS(i,e,t,n){let r={},s=new WeakMap,o=new FinalizationRegistry(m=>delete r[m]);function a(m){l(m.target)}function l(m){m.index!==null&&e.remove(m.index);for(let g in m.attributes)e.remove(m.attributes[g]);m.removeEventListener("dispose",a),delete r[m.id],o.unregister(m);let b=s.get(m);b&&(e.remove(b),s.delete(m)),n.releaseStatesOfGeometry(m),m.isInstancedBufferGeometry===!0&&delete m._maxInstanceCount,t.memory.geometries--}function c(m,b){return r[b.id]!==void 0||(b.addEventListener("dispose",a),r[b.id]=new WeakRef(b),o.register(b,b.id,b),t.memory.geometries++),b}function u(m){let b=m.attributes;for(let g in b)e.update(b[g],i.ARRAY_BUFFER)}function h(m){let b=m.index,g=m.attributes.position,_=0;if(g===void 0)return;let S=b!==null?b.array.length:g.array.length/3-1,T=g.count>=65535?ll:al,M=new T(Math.ceil(S/3)*6,1),P=M.array;if(b!==null){let y=b.array;_=b.version;for(let A=0,V=0;A<S;A+=3){let z=y[A+0],D=y[A+1],q=y[A+2];P[V++]=z,P[V++]=D,P[V++]=D,P[V++]=q,P[V++]=q,P[V++]=z}}else{_=g.version;for(let y=0,A=0;y<S;y+=3){let V=y+0,z=y+1,D=y+2;P[A++]=V,P[A++]=z,P[A++]=z,P[A++]=D,P[A++]=D,P[A++]=V}}M.version=_;let R=s.get(m);R&&e.remove(R),s.set(m,M)}function f(m){let b=s.get(m);if(b){let g=m.index;g!==null&&b.version<g.version&&h(m)}else h(m);return s.get(m)}function d(){for(let m in r){let b=r[m].deref();b!==void 0&&l(b)}}return{get:c,update:u,getWireframeAttribute:f,dispose:d}}function IS(i,e,t){let n;function r(h){n=h}let s,o;function a(h){s=h.type,o=h.bytesPerElement}function l(h,f){i.drawElements(n,f,s,h*o),t.update(f,n,1)}function c(h,f,d){d!==0&&(i.drawElementsInstanced(n,f,s,h*o,d),t.update(f,n,d))}function u(h,f,d){if(d===0)return;e.get("WEBGL_multi_draw").multiDrawElementsWEBGL(n,f,0,s,h,0,d);let b=0;for(let g=0;g<d;g++)b+=f[g];t.update(b,n,1)}this.setMode=r,this.setIndex=a,this.render=l,this.renderInstances=c,this.renderMultiDraw=u}function PS(i){let e={geometries:0,textures:0},t={frame:0,calls:0,triangles:0,points:0,lines:0};function n(s,o,a){switch(t.calls++,o){case i.TRIANGLES:t.triangles+=a*(s/3);break;case i.LINES:t.lines+=a*(s/2);break;case i.LINE_STRIP:t.lines+=a*(s-1);break;case i.LINE_LOOP:t.lines+=a*s;break;case i.POINTS:t.points+=a*s;break;default:_t("WebGLInfo: Unknown draw mode:",o);break}}function r(){t.calls=0,t.triangles=0,t.points=0,t.lines=0}return{memory:e,render:t,programs:null,autoReset:!0,reset:r,update:n}}function LS(i,e,t){let n=new WeakMap,r=new Ot;function s(o,a,l){let c=o.morphTargetInfluences,u=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,h=u!==void 0?u.length:0,f=n.get(a);if(f===void 0||f.count!==h){let V=function(){y.dispose(),n.delete(a),a.removeEventListener("dispose",V)};f!==void 0&&f.texture.dispose();let d=a.morphAttributes.position!==void 0,m=a.morphAttributes.normal!==void 0,b=a.morphAttributes.color!==void 0,g=a.morphAttributes.position||[],_=a.morphAttributes.normal||[],S=a.morphAttributes.color||[],T=0;d===!0&&(T=1),m===!0&&(T=2),b===!0&&(T=3);let M=a.attributes.position.count*T,P=1;M>e.maxTextureSize&&(P=Math.ceil(M/e.maxTextureSize),M=e.maxTextureSize);let R=new Float32Array(M*P*4*h),y=new io(R,M,P,h);y.type=Nt,y.needsUpdate=!0;let A=T*4;for(let z=0;z<h;z++){let D=g[z],q=_[z],Y=S[z],U=M*P*4*z;for(let W=0;W<D.count;W++){let K=W*A;d===!0&&(r.fromBufferAttribute(D,W),R[U+K+0]=r.x,R[U+K+1]=r.y,R[U+K+2]=r.z,R[U+K+3]=0),m===!0&&(r.fromBufferAttribute(q,W),R[U+K+4]=r.x,R[U+K+5]=r.y,R[U+K+6]=r.z,R[U+K+7]=0),b===!0&&(r.fromBufferAttribute(Y,W),R[U+K+8]=r.x,R[U+K+9]=r.y,R[U+K+10]=r.z,R[U+K+11]=Y.itemSize===4?r.w:1)}}f={count:h,texture:y,size:new xt(M,P)},n.set(a,f),a.addEventListener("dispose",V)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)l.getUniforms().setValue(i,"morphTexture",o.morphTexture,t);else{let d=0;for(let b=0;b<c.length;b++)d+=c[b];let m=a.morphTargetsRelative?1:1-d;l.getUniforms().setValue(i,"morphTargetBaseInfluence",m),l.getUniforms().setValue(i,"morphTargetInfluences",c)}l.getUniforms().setValue(i,"morphTargetsTexture",f.texture,t),l.getUniforms().setValue(i,"morphTargetsTextureSize",f.size)}return{update:s}}function NS(i,e,t,n,r){let s=new WeakMap;function o(c){let u=r.render.frame,h=c.geometry,f=e.get(c,h);if(s.get(f)!==u&&(e.update(f),s.set(f,u)),c.isInstancedMesh&&(c.hasEventListener("dispose",l)===!1&&c.addEventListener("dispose",l),s.get(c)!==u&&(t.update(c.instanceMatrix,i.ARRAY_BUFFER),c.instanceColor!==null&&t.update(c.instanceColor,i.ARRAY_BUFFER),s.set(c,u))),c.isSkinnedMesh){let d=c.skeleton;s.get(d)!==u&&(d.update(),s.set(d,u))}return f}function a(){s=new WeakMap}function l(c){let u=c.target;u.removeEventListener("dispose",l),n.releaseStatesOfObject(u),t.remove(u.instanceMatrix),u.instanceColor!==null&&t.remove(u.instanceColor)}return{update:o,dispose:a}}var DS={[Wf]:"LINEAR_TONE_MAPPING",[Xf]:"REINHARD_TONE_MAPPING",[qf]:"CINEON_TONE_MAPPING",[Yf]:"ACES_FILMIC_TONE_MAPPING",[Zf]:"AGX_TONE_MAPPING",[Kf]:"NEUTRAL_TONE_MAPPING",[$f]:"CUSTOM_TONE_MAPPING"};function FS(i,e,t,n,r,s){let o=new Zn(e,t,{type:i,depthBuffer:r,stencilBuffer:s,samples:n?4:0,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,resolveDepthBuffer:!1,resolveStencilBuffer:!1}),a=null,l=null,c=null,u=new _n;u.setAttribute("position",new Cn([-1,3,0,-1,-1,0,3,-1,0],3)),u.setAttribute("uv",new Cn([0,2,0,0,2,0],2));let h=new oa({uniforms:{tDiffuse:{value:null}},vertexShader:`
			precision highp float;

			uniform mat4 modelViewMatrix;
			uniform mat4 projectionMatrix;

			attribute vec3 position;
			attribute vec2 uv;

			varying vec2 vUv;

			void main() {
				vUv = uv;
				gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
			}`,fragmentShader:`
			precision highp float;

			uniform sampler2D tDiffuse;

			varying vec2 vUv;

			#include <tonemapping_pars_fragment>
			#include <colorspace_pars_fragment>

			void main() {
				gl_FragColor = texture2D( tDiffuse, vUv );

				#ifdef LINEAR_TONE_MAPPING
					gl_FragColor.rgb = LinearToneMapping( gl_FragColor.rgb );
				#elif defined( REINHARD_TONE_MAPPING )
					gl_FragColor.rgb = ReinhardToneMapping( gl_FragColor.rgb );
				#elif defined( CINEON_TONE_MAPPING )
					gl_FragColor.rgb = CineonToneMapping( gl_FragColor.rgb );
				#elif defined( ACES_FILMIC_TONE_MAPPING )
					gl_FragColor.rgb = ACESFilmicToneMapping( gl_FragColor.rgb );
				#elif defined( AGX_TONE_MAPPING )
					gl_FragColor.rgb = AgXToneMapping( gl_FragColor.rgb );
				#elif defined( NEUTRAL_TONE_MAPPING )
					gl_FragColor.rgb = NeutralToneMapping( gl_FragColor.rgb );
				#elif defined( CUSTOM_TONE_MAPPING )
					gl_FragColor.rgb = CustomToneMapping( gl_FragColor.rgb );
				#endif

				#ifdef SRGB_TRANSFER
					gl_FragColor = sRGBTransferOETF( gl_FragColor );
				#endif
			}`,depthTest:!1,depthWrite:!1}),f=new In(u,h),d=new co(-1,1,1,-1,0,1),m=null,b=null,g=!1,_,S=null,T=[],M=!1;this.setSize=function(P,R){o.setSize(P,R),a!==null&&a.setSize(P,R),l!==null&&l.setSize(P,R);for(let y=0;y<T.length;y++){let A=T[y];A.setSize&&A.setSize(P,R)}},this.setEffects=function(P){T=P,M=T.length>0&&T[0].isRenderPass===!0;let R=o.width,y=o.height;T.length>0&&a===null&&(a=new Zn(R,y,{type:tn,depthBuffer:!1,stencilBuffer:!1}),l=new Zn(R,y,{type:tn,depthBuffer:!1,stencilBuffer:!1}));let A=r===!0&&T.some(V=>V.needsDepthTexture===!0);A!==(o.depthTexture!==null)&&(A===!0&&c===null&&(c=new cr(R,y),s===!0&&(c.format=as,c.type=mo)),o.dispose(),o.depthTexture=A?c:null,o.resolveDepthBuffer=A,o.storeMultisampledDepthBuffer=A);for(let V=0;V<T.length;V++){let z=T[V];z.setSize&&z.setSize(R,y),A&&z.needsDepthTexture===!0&&z.setDepthTexture&&z.setDepthTexture(c)}},this.begin=function(P,R){if(g||P.toneMapping===Lr&&T.length===0)return!1;if(S=R,R!==null){let y=R.width,A=R.height;(o.width!==y||o.height!==A)&&this.setSize(y,A)}return M===!1&&P.setRenderTarget(o),_=P.toneMapping,P.toneMapping=Lr,!0},this.hasRenderPass=function(){return M},this.end=function(P,R){P.toneMapping=_,g=!0;let y=o,A=a;for(let V=0;V<T.length;V++){let z=T[V];z.enabled!==!1&&(z.render(P,A,y,R),z.needsSwap!==!1&&(y=A,A=A===a?l:a))}if(m!==P.outputColorSpace||b!==P.toneMapping){m=P.outputColorSpace,b=P.toneMapping,h.defines={},Rt.getTransfer(m)===Yt&&(h.defines.SRGB_TRANSFER="");let V=DS[b];V&&(h.defines[V]=""),h.needsUpdate=!0}h.uniforms.tDiffuse.value=y.texture,P.setRenderTarget(S),P.render(f,d),S=null,g=!1},this.isCompositing=function(){return g},this.dispose=function(){o.dispose(),a!==null&&a.dispose(),l!==null&&l.dispose(),u.dispose(),h.dispose()}}var Ug=new $n,Og=new cr(1,1),Bg=new pl(1),zg=new io,kg=new Wc,Vg=new dl,mg=[],gg=[],_g=new Float32Array(16),xg=new Float32Array(9),vg=new Float32Array(4);function _a(i,e,t){let n=i[0];if(n<=0||n>0)return i;let r=e*t,s=mg[r];if(s===void 0&&(s=new Float32Array(r),mg[r]=s),e!==0){n.toArray(s,0);for(let o=1,a=0;o!==e;++o)a+=t,i[o].toArray(s,a)}return s}function Bn(i,e){if(i.length!==e.length)return!1;for(let t=0,n=i.length;t<n;t++)if(i[t]!==e[t])return!1;return!0}function zn(i,e){for(let t=0,n=e.length;t<n;t++)i[t]=e[t]}function Ku(i,e){let t=gg[e];t===void 0&&(t=new Int32Array(e),gg[e]=t);for(let n=0;n!==e;++n)t[n]=i.allocateTextureUnit();return t}function US(i,e){let t=this.cache;t[0]!==e&&(i.uniform1f(this.addr,e),t[0]=e)}function OS(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(i.uniform2f(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(Bn(t,e))return;i.uniform2fv(this.addr,e),zn(t,e)}}function BS(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(i.uniform3f(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else if(e.r!==void 0)(t[0]!==e.r||t[1]!==e.g||t[2]!==e.b)&&(i.uniform3f(this.addr,e.r,e.g,e.b),t[0]=e.r,t[1]=e.g,t[2]=e.b);else{if(Bn(t,e))return;i.uniform3fv(this.addr,e),zn(t,e)}}function zS(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(i.uniform4f(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(Bn(t,e))return;i.uniform4fv(this.addr,e),zn(t,e)}}function kS(i,e){let t=this.cache,n=e.elements;if(n===void 0){if(Bn(t,e))return;i.uniformMatrix2fv(this.addr,!1,e),zn(t,e)}else{if(Bn(t,n))return;vg.set(n),i.uniformMatrix2fv(this.addr,!1,vg),zn(t,n)}}function VS(i,e){let t=this.cache,n=e.elements;if(n===void 0){if(Bn(t,e))return;i.uniformMatrix3fv(this.addr,!1,e),zn(t,e)}else{if(Bn(t,n))return;xg.set(n),i.uniformMatrix3fv(this.addr,!1,xg),zn(t,n)}}function HS(i,e){let t=this.cache,n=e.elements;if(n===void 0){if(Bn(t,e))return;i.uniformMatrix4fv(this.addr,!1,e),zn(t,e)}else{if(Bn(t,n))return;_g.set(n),i.uniformMatrix4fv(this.addr,!1,_g),zn(t,n)}}function GS(i,e){let t=this.cache;t[0]!==e&&(i.uniform1i(this.addr,e),t[0]=e)}function WS(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(i.uniform2i(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(Bn(t,e))return;i.uniform2iv(this.addr,e),zn(t,e)}}function XS(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(i.uniform3i(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(Bn(t,e))return;i.uniform3iv(this.addr,e),zn(t,e)}}function qS(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(i.uniform4i(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(Bn(t,e))return;i.uniform4iv(this.addr,e),zn(t,e)}}function YS(i,e){let t=this.cache;t[0]!==e&&(i.uniform1ui(this.addr,e),t[0]=e)}function $S(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(i.uniform2ui(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(Bn(t,e))return;i.uniform2uiv(this.addr,e),zn(t,e)}}function ZS(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(i.uniform3ui(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(Bn(t,e))return;i.uniform3uiv(this.addr,e),zn(t,e)}}function KS(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(i.uniform4ui(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(Bn(t,e))return;i.uniform4uiv(this.addr,e),zn(t,e)}}function Ju(i){return i.version===0&&(i.compareFunction=ad,i.needsUpdate=!0),i}function JS(i,e,t){let n=this.cache,r=t.allocateTextureUnit();n[0]!==r&&(i.uniform1i(this.addr,r),n[0]=r);let s;this.type===i.SAMPLER_2D_SHADOW?s=Ju(Og):s=Ug,t.setTexture2D(e||s,r)}function jS(i,e,t){let n=this.cache,r=t.allocateTextureUnit();n[0]!==r&&(i.uniform1i(this.addr,r),n[0]=r),t.setTexture3D(e||kg,r)}function QS(i,e,t){let n=this.cache,r=t.allocateTextureUnit();n[0]!==r&&(i.uniform1i(this.addr,r),n[0]=r);let s;this.type===i.SAMPLER_CUBE_SHADOW?s=Ju(Bg):s=Vg,t.setTextureCube(e||s,r)}function eM(i,e,t){let n=this.cache,r=t.allocateTextureUnit();n[0]!==r&&(i.uniform1i(this.addr,r),n[0]=r),t.setTexture2DArray(e||zg,r)}function tM(i){switch(i){case 5126:return US;case 35664:return OS;case 35665:return BS;case 35666:return zS;case 35674:return kS;case 35675:return VS;case 35676:return HS;case 5124:case 35670:return GS;case 35667:case 35671:return WS;case 35668:case 35672:return XS;case 35669:case 35673:return qS;case 5125:return YS;case 36294:return $S;case 36295:return ZS;case 36296:return KS;case 35678:case 36198:case 36298:case 36306:case 35682:return JS;case 35679:case 36299:case 36307:return jS;case 35680:case 36300:case 36308:case 36293:return QS;case 36289:case 36303:case 36311:case 36292:return eM}}function nM(i,e){i.uniform1fv(this.addr,e)}function iM(i,e){let t=_a(e,this.size,2);i.uniform2fv(this.addr,t)}function rM(i,e){let t=_a(e,this.size,3);i.uniform3fv(this.addr,t)}function sM(i,e){let t=_a(e,this.size,4);i.uniform4fv(this.addr,t)}function oM(i,e){let t=_a(e,this.size,4);i.uniformMatrix2fv(this.addr,!1,t)}function aM(i,e){let t=_a(e,this.size,9);i.uniformMatrix3fv(this.addr,!1,t)}function lM(i,e){let t=_a(e,this.size,16);i.uniformMatrix4fv(this.addr,!1,t)}function cM(i,e){i.uniform1iv(this.addr,e)}function uM(i,e){i.uniform2iv(this.addr,e)}function hM(i,e){i.uniform3iv(this.addr,e)}function fM(i,e){i.uniform4iv(this.addr,e)}function dM(i,e){i.uniform1uiv(this.addr,e)}function pM(i,e){i.uniform2uiv(this.addr,e)}function mM(i,e){i.uniform3uiv(this.addr,e)}function gM(i,e){i.uniform4uiv(this.addr,e)}function _M(i,e,t){let n=this.cache,r=e.length,s=Ku(t,r);Bn(n,s)||(i.uniform1iv(this.addr,s),zn(n,s));let o;this.type===i.SAMPLER_2D_SHADOW?o=Ju(Og):o=Ug;for(let a=0;a!==r;++a)t.setTexture2D(e[a]||o,s[a])}function xM(i,e,t){let n=this.cache,r=e.length,s=Ku(t,r);Bn(n,s)||(i.uniform1iv(this.addr,s),zn(n,s));for(let o=0;o!==r;++o)t.setTexture3D(e[o]||kg,s[o])}function vM(i,e,t){let n=this.cache,r=e.length,s=Ku(t,r);Bn(n,s)||(i.uniform1iv(this.addr,s),zn(n,s));let o;this.type===i.SAMPLER_CUBE_SHADOW?o=Ju(Bg):o=Vg;for(let a=0;a!==r;++a)t.setTextureCube(e[a]||o,s[a])}function yM(i,e,t){let n=this.cache,r=e.length,s=Ku(t,r);Bn(n,s)||(i.uniform1iv(this.addr,s),zn(n,s));for(let o=0;o!==r;++o)t.setTexture2DArray(e[o]||zg,s[o])}function bM(i){switch(i){case 5126:return nM;case 35664:return iM;case 35665:return rM;case 35666:return sM;case 35674:return oM;case 35675:return aM;case 35676:return lM;case 5124:case 35670:return cM;case 35667:case 35671:return uM;case 35668:case 35672:return hM;case 35669:case 35673:return fM;case 5125:return dM;case 36294:return pM;case 36295:return mM;case 36296:return gM;case 35678:case 36198:case 36298:case 36306:case 35682:return _M;case 35679:case 36299:case 36307:return xM;case 35680:case 36300:case 36308:case 36293:return vM;case 36289:case 36303:case 36311:case 36292:return yM}}var vd=class{constructor(e,t,n){this.id=e,this.addr=n,this.cache=[],this.type=t.type,this.setValue=tM(t.type)}},yd=class{constructor(e,t,n){this.id=e,this.addr=n,this.cache=[],this.type=t.type,this.size=t.size,this.setValue=bM(t.type)}},bd=class{constructor(e){this.id=e,this.seq=[],this.map={}}setValue(e,t,n){let r=this.seq;for(let s=0,o=r.length;s!==o;++s){let a=r[s];a.setValue(e,t[a.id],n)}}},_d=/(\w+)(\])?(\[|\.)?/g;function yg(i,e){i.seq.push(e),i.map[e.id]=e}function wM(i,e,t){let n=i.name,r=n.length;for(_d.lastIndex=0;;){let s=_d.exec(n),o=_d.lastIndex,a=s[1],l=s[2]==="]",c=s[3];if(l&&(a=a|0),c===void 0||c==="["&&o+2===r){yg(t,c===void 0?new vd(a,i,e):new yd(a,i,e));break}else{let h=t.map[a];h===void 0&&(h=new bd(a),yg(t,h)),t=h}}}var ga=class{constructor(e,t){this.seq=[],this.map={};let n=e.getProgramParameter(t,e.ACTIVE_UNIFORMS);for(let o=0;o<n;++o){let a=e.getActiveUniform(t,o),l=e.getUniformLocation(t,a.name);wM(a,l,this)}let r=[],s=[];for(let o of this.seq)o.type===e.SAMPLER_2D_SHADOW||o.type===e.SAMPLER_CUBE_SHADOW||o.type===e.SAMPLER_2D_ARRAY_SHADOW?r.push(o):s.push(o);r.length>0&&(this.seq=r.concat(s))}setValue(e,t,n,r){let s=this.map[t];s!==void 0&&s.setValue(e,n,r)}setOptional(e,t,n){let r=t[n];r!==void 0&&this.setValue(e,n,r)}static upload(e,t,n,r){for(let s=0,o=t.length;s!==o;++s){let a=t[s],l=n[a.id];l.needsUpdate!==!1&&a.setValue(e,l.value,r)}}static seqWithValue(e,t){let n=[];for(let r=0,s=e.length;r!==s;++r){let o=e[r];o.id in t&&n.push(o)}return n}};function bg(i,e,t){let n=i.createShader(e);return i.shaderSource(n,t),i.compileShader(n),n}var SM=37297,MM=0;function TM(i,e){let t=i.split(`
`),n=[],r=Math.max(e-6,0),s=Math.min(e+6,t.length);for(let o=r;o<s;o++){let a=o+1;n.push(`${a===e?">":" "} ${a}: ${t[o]}`)}return n.join(`
`)}var wg=new dt;function AM(i){Rt._getMatrix(wg,Rt.workingColorSpace,i);let e=`mat3( ${wg.elements.map(t=>t.toFixed(4))} )`;switch(Rt.getTransfer(i)){case il:return[e,"LinearTransferOETF"];case Yt:return[e,"sRGBTransferOETF"];default:return nt("WebGLProgram: Unsupported color space: ",i),[e,"LinearTransferOETF"]}}function Sg(i,e,t){let n=i.getShaderParameter(e,i.COMPILE_STATUS),s=(i.getShaderInfoLog(e)||"").trim();if(n&&s==="")return"";let o=/ERROR: 0:(\d+)/.exec(s);if(o){let a=parseInt(o[1]);return t.toUpperCase()+`

`+s+`

`+TM(i.getShaderSource(e),a)}else return s}function EM(i,e){let t=AM(e);return[`vec4 ${i}( vec4 value ) {`,`	return ${t[1]}( vec4( ${t[0]} * value.rgb, value.a ) );`,"}"].join(`
`)}var RM={[Wf]:"Linear",[Xf]:"Reinhard",[qf]:"Cineon",[Yf]:"ACESFilmic",[Zf]:"AgX",[Kf]:"Neutral",[$f]:"Custom"};function CM(i,e){let t=RM[e];return t===void 0?(nt("WebGLProgram: Unsupported toneMapping:",e),"vec3 "+i+"( vec3 color ) { return LinearToneMapping( color ); }"):"vec3 "+i+"( vec3 color ) { return "+t+"ToneMapping( color ); }"}var Yu=new J;function IM(){Rt.getLuminanceCoefficients(Yu);let i=Yu.x.toFixed(4),e=Yu.y.toFixed(4),t=Yu.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${i}, ${e}, ${t} );`,"	return dot( weights, rgb );","}"].join(`
`)}function PM(i){return[i.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",i.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(Ul).join(`
`)}function LM(i){let e=[];for(let t in i){let n=i[t];n!==!1&&e.push("#define "+t+" "+n)}return e.join(`
`)}function NM(i,e){let t={},n=i.getProgramParameter(e,i.ACTIVE_ATTRIBUTES);for(let r=0;r<n;r++){let s=i.getActiveAttrib(e,r),o=s.name,a=1;s.type===i.FLOAT_MAT2&&(a=2),s.type===i.FLOAT_MAT3&&(a=3),s.type===i.FLOAT_MAT4&&(a=4),t[o]={type:s.type,location:i.getAttribLocation(e,o),locationSize:a}}return t}function Ul(i){return i!==""}function Mg(i,e){let t=e.numSpotLightShadows+e.numSpotLightMaps-e.numSpotLightShadowsWithMaps;return i.replace(/NUM_SUN_LIGHTS/g,e.numSunLights).replace(/NUM_DIR_LIGHTS/g,e.numDirLights).replace(/NUM_SPOT_LIGHTS/g,e.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,e.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,t).replace(/NUM_RECT_AREA_LIGHTS/g,e.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,e.numPointLights).replace(/NUM_HEMI_LIGHTS/g,e.numHemiLights).replace(/NUM_SUN_LIGHT_SHADOWS/g,e.numSunLightShadows).replace(/NUM_DIR_LIGHT_SHADOWS/g,e.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,e.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,e.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,e.numPointLightShadows).replace(/NUM_LIGHT_PROBE_GRIDS/g,e.numLightProbeGrids)}function Tg(i,e){return i.replace(/NUM_CLIPPING_PLANES/g,e.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,e.numClippingPlanes-e.numClipIntersection)}var DM=/^[ \t]*#include +<([\w\d./]+)>/gm;function wd(i){return i.replace(DM,FM)}function FM(i,e){let t=Et[e];if(t===void 0)throw new Error("THREE.WebGLProgram: Can not resolve #include <"+e+">");return wd(t)}var UM=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function Ag(i){return i.replace(UM,OM)}function OM(i,e,t,n){let r="";for(let s=parseInt(e);s<parseInt(t);s++)r+=n.replace(/\[\s*i\s*\]/g,"[ "+s+" ]").replace(/UNROLLED_LOOP_INDEX/g,s);return r}function Eg(i){let e=`precision ${i.precision} float;
	precision ${i.precision} int;
	precision ${i.precision} sampler2D;
	precision ${i.precision} samplerCube;
	precision ${i.precision} sampler3D;
	precision ${i.precision} sampler2DArray;
	precision ${i.precision} sampler2DShadow;
	precision ${i.precision} samplerCubeShadow;
	precision ${i.precision} sampler2DArrayShadow;
	precision ${i.precision} isampler2D;
	precision ${i.precision} isampler3D;
	precision ${i.precision} isamplerCube;
	precision ${i.precision} isampler2DArray;
	precision ${i.precision} usampler2D;
	precision ${i.precision} usampler3D;
	precision ${i.precision} usamplerCube;
	precision ${i.precision} usampler2DArray;
	`;return i.precision==="highp"?e+=`
#define HIGH_PRECISION`:i.precision==="mediump"?e+=`
#define MEDIUM_PRECISION`:i.precision==="lowp"&&(e+=`
#define LOW_PRECISION`),e}var BM={[Tl]:"SHADOWMAP_TYPE_PCF",[ua]:"SHADOWMAP_TYPE_VSM"};function zM(i){return BM[i.shadowMapType]||"SHADOWMAP_TYPE_BASIC"}var kM={[fa]:"ENVMAP_MODE_REFRACTION"};function VM(i){return i.envMap===!1?"ENVMAP_MODE_REFLECTION":kM[i.envMapMode]||"ENVMAP_MODE_REFLECTION"}var HM={[ru]:"ENVMAP_BLENDING_MULTIPLY",[X0]:"ENVMAP_BLENDING_MIX",[q0]:"ENVMAP_BLENDING_ADD"};function GM(i){return i.envMap===!1?"ENVMAP_BLENDING_NONE":HM[i.combine]||"ENVMAP_BLENDING_NONE"}function WM(i,e,t,n){let r=i.getContext(),s=t.defines,o=t.vertexShader,a=t.fragmentShader,l=zM(t),c=t.envMapPMREM===!0?"ENVMAP_TYPE_PMREM":"ENVMAP_TYPE_CUBE",u=VM(t),h=GM(t),f=PM(t),d=LM(s),m=r.createProgram(),b,g,_=t.glslVersion?"#version "+t.glslVersion+`
`:"";t.isRawShaderMaterial?(b=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,d].filter(Ul).join(`
`),b.length>0&&(b+=`
`),g=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,d].filter(Ul).join(`
`),g.length>0&&(g+=`
`)):(b=[Eg(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,d,t.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",t.batching?"#define USE_BATCHING":"",t.batchingColor?"#define USE_BATCHING_COLOR":"",t.instancing?"#define USE_INSTANCING":"",t.instancingColor?"#define USE_INSTANCING_COLOR":"",t.instancingMorph?"#define USE_INSTANCING_MORPH":"",t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.map?"#define USE_MAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+u:"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.displacementMap?"#define USE_DISPLACEMENTMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.mapUv?"#define MAP_UV "+t.mapUv:"",t.alphaMapUv?"#define ALPHAMAP_UV "+t.alphaMapUv:"",t.lightMapUv?"#define LIGHTMAP_UV "+t.lightMapUv:"",t.aoMapUv?"#define AOMAP_UV "+t.aoMapUv:"",t.emissiveMapUv?"#define EMISSIVEMAP_UV "+t.emissiveMapUv:"",t.bumpMapUv?"#define BUMPMAP_UV "+t.bumpMapUv:"",t.normalMapUv?"#define NORMALMAP_UV "+t.normalMapUv:"",t.displacementMapUv?"#define DISPLACEMENTMAP_UV "+t.displacementMapUv:"",t.metalnessMapUv?"#define METALNESSMAP_UV "+t.metalnessMapUv:"",t.roughnessMapUv?"#define ROUGHNESSMAP_UV "+t.roughnessMapUv:"",t.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+t.anisotropyMapUv:"",t.clearcoatMapUv?"#define CLEARCOATMAP_UV "+t.clearcoatMapUv:"",t.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+t.clearcoatNormalMapUv:"",t.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+t.clearcoatRoughnessMapUv:"",t.diffuseRoughnessMapUv?"#define DIFFUSE_ROUGHNESSMAP_UV "+t.diffuseRoughnessMapUv:"",t.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+t.iridescenceMapUv:"",t.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+t.iridescenceThicknessMapUv:"",t.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+t.sheenColorMapUv:"",t.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+t.sheenRoughnessMapUv:"",t.specularMapUv?"#define SPECULARMAP_UV "+t.specularMapUv:"",t.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+t.specularColorMapUv:"",t.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+t.specularIntensityMapUv:"",t.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+t.transmissionMapUv:"",t.thicknessMapUv?"#define THICKNESSMAP_UV "+t.thicknessMapUv:"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexNormals?"#define HAS_NORMAL":"",t.vertexColors?"#define USE_COLOR":"",t.vertexAlphas?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.flatShading?"#define FLAT_SHADED":"",t.skinning?"#define USE_SKINNING":"",t.morphTargets?"#define USE_MORPHTARGETS":"",t.morphNormals&&t.flatShading===!1?"#define USE_MORPHNORMALS":"",t.morphColors?"#define USE_MORPHCOLORS":"",t.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+t.morphTextureStride:"",t.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+t.morphTargetsCount:"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.sizeAttenuation?"#define USE_SIZEATTENUATION":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(Ul).join(`
`),g=[Eg(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,d,t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",t.map?"#define USE_MAP":"",t.matcap?"#define USE_MATCAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+c:"",t.envMap?"#define "+u:"",t.envMap?"#define "+h:"",t.envMapPMREM?"#define ENVMAP_MAX_LOD "+t.envMapMaxLod+".0":"",t.envMapPMREM?"#define ENVMAP_SIZE "+t.envMapSize+".0":"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.packedNormalMap?"#define USE_PACKED_NORMALMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoat?"#define USE_CLEARCOAT":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughness?"#define USE_DIFFUSE_ROUGHNESS":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.dispersion?"#define USE_DISPERSION":"",t.retroreflection?"#define USE_RETROREFLECTION":"",t.iridescence?"#define USE_IRIDESCENCE":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaTest?"#define USE_ALPHATEST":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.sheen?"#define USE_SHEEN":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexColors||t.instancingColor?"#define USE_COLOR":"",t.vertexAlphas||t.batchingColor?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.gradientMap?"#define USE_GRADIENTMAP":"",t.flatShading?"#define FLAT_SHADED":"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",t.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",t.toneMapping!==Lr?"#define TONE_MAPPING":"",t.toneMapping!==Lr?Et.tonemapping_pars_fragment:"",t.toneMapping!==Lr?CM("toneMapping",t.toneMapping):"",t.dithering?"#define DITHERING":"",t.opaque?"#define OPAQUE":"",Et.colorspace_pars_fragment,EM("linearToOutputTexel",t.outputColorSpace),IM(),t.useDepthPacking?"#define DEPTH_PACKING "+t.depthPacking:"",`
`].filter(Ul).join(`
`)),o=wd(o),o=Mg(o,t),o=Tg(o,t),a=wd(a),a=Mg(a,t),a=Tg(a,t),o=Ag(o),a=Ag(a),t.isRawShaderMaterial!==!0&&(_=`#version 300 es
`,b=[f,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+b,g=["#define varying in",t.glslVersion===Dl?"":"layout(location = 0) out highp vec4 pc_fragColor;",t.glslVersion===Dl?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+g);let S=_+b+o,T=_+g+a,M=bg(r,r.VERTEX_SHADER,S),P=bg(r,r.FRAGMENT_SHADER,T);r.attachShader(m,M),r.attachShader(m,P),t.index0AttributeName!==void 0?r.bindAttribLocation(m,0,t.index0AttributeName):t.hasPositionAttribute===!0&&r.bindAttribLocation(m,0,"position"),r.linkProgram(m);function R(z){if(i.debug.checkShaderErrors){let D=r.getProgramInfoLog(m)||"",q=r.getShaderInfoLog(M)||"",Y=r.getShaderInfoLog(P)||"",U=D.trim(),W=q.trim(),K=Y.trim(),$=!0,xe=!0;if(r.getProgramParameter(m,r.LINK_STATUS)===!1)if($=!1,typeof i.debug.onShaderError=="function")i.debug.onShaderError(r,m,M,P);else{let ne=Sg(r,M,"vertex"),re=Sg(r,P,"fragment");_t("WebGLProgram: Shader Error "+r.getError()+" - VALIDATE_STATUS "+r.getProgramParameter(m,r.VALIDATE_STATUS)+`

Material Name: `+z.name+`
Material Type: `+z.type+`

Program Info Log: `+U+`
`+ne+`
`+re)}else U!==""?nt("WebGLProgram: Program Info Log:",U):(W===""||K==="")&&(xe=!1);xe&&(z.diagnostics={runnable:$,programLog:U,vertexShader:{log:W,prefix:b},fragmentShader:{log:K,prefix:g}})}r.deleteShader(M),r.deleteShader(P),y=new ga(r,m),A=NM(r,m)}let y;this.getUniforms=function(){return y===void 0&&R(this),y};let A;this.getAttributes=function(){return A===void 0&&R(this),A};let V=t.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return V===!1&&(V=r.getProgramParameter(m,SM)),V},this.destroy=function(){n.releaseStatesOfProgram(this),r.deleteProgram(m),this.program=void 0},this.type=t.shaderType,this.name=t.shaderName,this.id=MM++,this.cacheKey=e,this.usedTimes=1,this.program=m,this.vertexShader=M,this.fragmentShader=P,this}var XM=0,Sd=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(e,t,n){let r=this._getShaderCacheForMaterial(e);return r.has(t)===!1&&(r.add(t),t.usedTimes++),r.has(n)===!1&&(r.add(n),n.usedTimes++),this}remove(e){let t=this.materialCache.get(e);for(let n of t)n.usedTimes--,n.usedTimes===0&&this.shaderCache.delete(n.code);return this.materialCache.delete(e),this}getVertexShaderStage(e){return this._getShaderStage(e.vertexShader)}getFragmentShaderStage(e){return this._getShaderStage(e.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(e){let t=this.materialCache,n=t.get(e);return n===void 0&&(n=new Set,t.set(e,n)),n}_getShaderStage(e){let t=this.shaderCache,n=t.get(e);return n===void 0&&(n=new Md(e),t.set(e,n)),n}},Md=class{constructor(e){this.id=XM++,this.code=e,this.usedTimes=0}};function qM(i){return i===ai||i===Il||i===Pl}function YM(i,e,t,n,r,s){let o=new sl,a=new Sd,l=new Set,c=[],u=new Map,h=n.logarithmicDepthBuffer,f={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distance",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function d(y){return l.add(y),y===0?"uv":`uv${y}`}function m(y,A,V,z,D,q){let Y=z.fog,U=D.geometry,W=y.isMeshStandardMaterial||y.isMeshLambertMaterial||y.isMeshPhongMaterial?z.environment:null,K=y.isMeshStandardMaterial||y.isMeshLambertMaterial&&!y.envMap||y.isMeshPhongMaterial&&!y.envMap,$=e.get(y.envMap||W,K),xe=f[y.type],ne=n.precision;y.precision!==null&&(ne=n.getMaxPrecision(y.precision),ne!==y.precision&&nt("WebGLProgram.getParameters:",y.precision,"not supported, using",ne,"instead."));let re=U.morphAttributes.position||U.morphAttributes.normal||U.morphAttributes.color,de=re!==void 0?re.length:0,ge=0;U.morphAttributes.position!==void 0&&(ge=1),U.morphAttributes.normal!==void 0&&(ge=2),U.morphAttributes.color!==void 0&&(ge=3);let pe,se,Ee,Pe;if(xe){let Ge=Fr[xe];pe=Ge.vertexShader,se=Ge.fragmentShader}else{pe=y.vertexShader,se=y.fragmentShader;let Ge=a.getVertexShaderStage(y),Mt=a.getFragmentShaderStage(y);a.update(y,Ge,Mt),Ee=Ge.id,Pe=Mt.id}let Oe=i.getRenderTarget(),ye=i.state.buffers.depth.getReversed(),Ke=D.isInstancedMesh===!0,ft=D.isBatchedMesh===!0,et=!!y.map,St=!!y.matcap,bt=!!$,vt=bt&&$.isPMREMTexture===!0,Zt=!!y.aoMap,kt=!!y.lightMap,mn=!!y.bumpMap&&y.wireframe===!1,Xt=!!y.normalMap,Dn=!!y.displacementMap,Pt=!!y.emissiveMap,Tn=!!y.metalnessMap,ln=!!y.roughnessMap,An=y.anisotropy>0,G=y.clearcoat>0,He=y.diffuseRoughness>0,ct=y.dispersion>0,yt=y.retroreflectivity>0,De=y.iridescence>0,Kt=y.sheen>0,je=y.transmission>0,lt=An&&!!y.anisotropyMap,F=G&&!!y.clearcoatMap,E=G&&!!y.clearcoatNormalMap,ee=G&&!!y.clearcoatRoughnessMap,be=He&&!!y.diffuseRoughnessMap,me=De&&!!y.iridescenceMap,Ne=De&&!!y.iridescenceThicknessMap,Fe=Kt&&!!y.sheenColorMap,ae=Kt&&!!y.sheenRoughnessMap,he=!!y.specularMap,Re=!!y.specularColorMap,H=!!y.specularIntensityMap,ue=je&&!!y.transmissionMap,oe=je&&!!y.thicknessMap,ke=!!y.gradientMap,Le=!!y.alphaMap,Be=y.alphaTest>0,tt=!!y.alphaHash,pt=!!y.extensions,we=Lr;y.toneMapped&&(Oe===null||Oe.isXRRenderTarget===!0)&&(we=i.toneMapping);let Je=vt?$.isCompressedCubeTexture?$.image[0].mipmaps:$.mipmaps:null,mt={shaderID:xe,shaderType:y.type,shaderName:y.name,vertexShader:pe,fragmentShader:se,defines:y.defines,customVertexShaderID:Ee,customFragmentShaderID:Pe,isRawShaderMaterial:y.isRawShaderMaterial===!0,glslVersion:y.glslVersion,precision:ne,batching:ft,batchingColor:ft&&D._colorsTexture!==null,instancing:Ke,instancingColor:Ke&&D.instanceColor!==null,instancingMorph:Ke&&D.morphTexture!==null,outputColorSpace:Oe===null?i.outputColorSpace:Oe.isXRRenderTarget===!0?Oe.texture.colorSpace:Rt.workingColorSpace,alphaToCoverage:!!y.alphaToCoverage,map:et,matcap:St,envMap:bt,envMapMode:bt&&$.mapping,envMapPMREM:vt,envMapMaxLod:vt?Je.length-1:null,envMapSize:vt?Je[0].width:null,aoMap:Zt,lightMap:kt,bumpMap:mn,normalMap:Xt,displacementMap:Dn,emissiveMap:Pt,normalMapObjectSpace:Xt&&y.normalMapType===K0,normalMapTangentSpace:Xt&&y.normalMapType===Nl,packedNormalMap:Xt&&y.normalMapType===Nl&&qM(y.normalMap.format),metalnessMap:Tn,roughnessMap:ln,anisotropy:An,anisotropyMap:lt,clearcoat:G,clearcoatMap:F,clearcoatNormalMap:E,clearcoatRoughnessMap:ee,diffuseRoughness:He,diffuseRoughnessMap:be,dispersion:ct,retroreflection:yt,iridescence:De,iridescenceMap:me,iridescenceThicknessMap:Ne,sheen:Kt,sheenColorMap:Fe,sheenRoughnessMap:ae,specularMap:he,specularColorMap:Re,specularIntensityMap:H,transmission:je,transmissionMap:ue,thicknessMap:oe,gradientMap:ke,opaque:y.transparent===!1&&y.blending===ha&&y.alphaToCoverage===!1,alphaMap:Le,alphaTest:Be,alphaHash:tt,combine:y.combine,mapUv:et&&d(y.map.channel),aoMapUv:Zt&&d(y.aoMap.channel),lightMapUv:kt&&d(y.lightMap.channel),bumpMapUv:mn&&d(y.bumpMap.channel),normalMapUv:Xt&&d(y.normalMap.channel),displacementMapUv:Dn&&d(y.displacementMap.channel),emissiveMapUv:Pt&&d(y.emissiveMap.channel),metalnessMapUv:Tn&&d(y.metalnessMap.channel),roughnessMapUv:ln&&d(y.roughnessMap.channel),anisotropyMapUv:lt&&d(y.anisotropyMap.channel),clearcoatMapUv:F&&d(y.clearcoatMap.channel),clearcoatNormalMapUv:E&&d(y.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:ee&&d(y.clearcoatRoughnessMap.channel),diffuseRoughnessMapUv:be&&d(y.diffuseRoughnessMap.channel),iridescenceMapUv:me&&d(y.iridescenceMap.channel),iridescenceThicknessMapUv:Ne&&d(y.iridescenceThicknessMap.channel),sheenColorMapUv:Fe&&d(y.sheenColorMap.channel),sheenRoughnessMapUv:ae&&d(y.sheenRoughnessMap.channel),specularMapUv:he&&d(y.specularMap.channel),specularColorMapUv:Re&&d(y.specularColorMap.channel),specularIntensityMapUv:H&&d(y.specularIntensityMap.channel),transmissionMapUv:ue&&d(y.transmissionMap.channel),thicknessMapUv:oe&&d(y.thicknessMap.channel),alphaMapUv:Le&&d(y.alphaMap.channel),vertexTangents:!!U.attributes.tangent&&(Xt||An),vertexNormals:!!U.attributes.normal,vertexColors:y.vertexColors,vertexAlphas:y.vertexColors===!0&&!!U.attributes.color&&U.attributes.color.itemSize===4,pointsUvs:D.isPoints===!0&&!!U.attributes.uv&&(et||Le),fog:!!Y,useFog:y.fog===!0,fogExp2:!!Y&&Y.isFogExp2,flatShading:y.wireframe===!1&&(y.flatShading===!0||U.attributes.normal===void 0&&Xt===!1&&(y.isMeshLambertMaterial||y.isMeshPhongMaterial||y.isMeshStandardMaterial||y.isMeshPhysicalMaterial)),sizeAttenuation:y.sizeAttenuation===!0,logarithmicDepthBuffer:h,reversedDepthBuffer:ye,skinning:D.isSkinnedMesh===!0,hasPositionAttribute:U.attributes.position!==void 0,morphTargets:U.morphAttributes.position!==void 0,morphNormals:U.morphAttributes.normal!==void 0,morphColors:U.morphAttributes.color!==void 0,morphTargetsCount:de,morphTextureStride:ge,numSunLights:A.sun.length,numDirLights:A.directional.length,numPointLights:A.point.length,numSpotLights:A.spot.length,numSpotLightMaps:A.spotLightMap.length,numRectAreaLights:A.rectArea.length,numHemiLights:A.hemi.length,numSunLightShadows:A.sunShadowMap.length,numDirLightShadows:A.directionalShadowMap.length,numPointLightShadows:A.pointShadowMap.length,numSpotLightShadows:A.spotShadowMap.length,numSpotLightShadowsWithMaps:A.numSpotLightShadowsWithMaps,numLightProbes:A.numLightProbes,numLightProbeGrids:q.filter(Ge=>Ge.texture!==null).length,numClippingPlanes:s.numPlanes,numClipIntersection:s.numIntersection,dithering:y.dithering,shadowMapEnabled:i.shadowMap.enabled&&V.length>0,shadowMapType:i.shadowMap.type,toneMapping:we,decodeVideoTexture:et&&y.map.isVideoTexture===!0&&Rt.getTransfer(y.map.colorSpace)===Yt,decodeVideoTextureEmissive:Pt&&y.emissiveMap.isVideoTexture===!0&&Rt.getTransfer(y.emissiveMap.colorSpace)===Yt,premultipliedAlpha:y.premultipliedAlpha,doubleSided:y.side===Xi,flipSided:y.side===mi,useDepthPacking:y.depthPacking>=0,depthPacking:y.depthPacking||0,index0AttributeName:y.index0AttributeName,extensionClipCullDistance:pt&&y.extensions.clipCullDistance===!0&&t.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(pt&&y.extensions.multiDraw===!0||ft)&&t.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:t.has("KHR_parallel_shader_compile"),customProgramCacheKey:y.customProgramCacheKey()};return mt.vertexUv1s=l.has(1),mt.vertexUv2s=l.has(2),mt.vertexUv3s=l.has(3),l.clear(),mt}function b(y){let A=[];if(y.shaderID?A.push(y.shaderID):(A.push(y.customVertexShaderID),A.push(y.customFragmentShaderID)),y.defines!==void 0)for(let V in y.defines)A.push(V),A.push(y.defines[V]);return y.isRawShaderMaterial===!1&&(g(A,y),_(A,y),A.push(i.outputColorSpace)),A.push(y.customProgramCacheKey),A.join()}function g(y,A){y.push(A.precision),y.push(A.outputColorSpace),y.push(A.envMapMode),y.push(A.envMapPMREM),y.push(A.envMapMaxLod),y.push(A.envMapSize),y.push(A.mapUv),y.push(A.alphaMapUv),y.push(A.lightMapUv),y.push(A.aoMapUv),y.push(A.bumpMapUv),y.push(A.normalMapUv),y.push(A.displacementMapUv),y.push(A.emissiveMapUv),y.push(A.metalnessMapUv),y.push(A.roughnessMapUv),y.push(A.anisotropyMapUv),y.push(A.clearcoatMapUv),y.push(A.clearcoatNormalMapUv),y.push(A.clearcoatRoughnessMapUv),y.push(A.diffuseRoughnessMapUv),y.push(A.iridescenceMapUv),y.push(A.iridescenceThicknessMapUv),y.push(A.sheenColorMapUv),y.push(A.sheenRoughnessMapUv),y.push(A.specularMapUv),y.push(A.specularColorMapUv),y.push(A.specularIntensityMapUv),y.push(A.transmissionMapUv),y.push(A.thicknessMapUv),y.push(A.combine),y.push(A.fogExp2),y.push(A.sizeAttenuation),y.push(A.morphTargetsCount),y.push(A.numSunLights),y.push(A.numDirLights),y.push(A.numPointLights),y.push(A.numSpotLights),y.push(A.numSpotLightMaps),y.push(A.numHemiLights),y.push(A.numRectAreaLights),y.push(A.numSunLightShadows),y.push(A.numDirLightShadows),y.push(A.numPointLightShadows),y.push(A.numSpotLightShadows),y.push(A.numSpotLightShadowsWithMaps),y.push(A.numLightProbes),y.push(A.numLightProbeGrids),y.push(A.shadowMapType),y.push(A.toneMapping),y.push(A.numClippingPlanes),y.push(A.numClipIntersection),y.push(A.depthPacking)}function _(y,A){o.disableAll(),A.instancing&&o.enable(0),A.instancingColor&&o.enable(1),A.instancingMorph&&o.enable(2),A.matcap&&o.enable(3),A.envMap&&o.enable(4),A.normalMapObjectSpace&&o.enable(5),A.normalMapTangentSpace&&o.enable(6),A.clearcoat&&o.enable(7),A.iridescence&&o.enable(8),A.alphaTest&&o.enable(9),A.vertexColors&&o.enable(10),A.vertexAlphas&&o.enable(11),A.vertexUv1s&&o.enable(12),A.vertexUv2s&&o.enable(13),A.vertexUv3s&&o.enable(14),A.vertexTangents&&o.enable(15),A.anisotropy&&o.enable(16),A.alphaHash&&o.enable(17),A.batching&&o.enable(18),A.dispersion&&o.enable(19),A.retroreflection&&o.enable(24),A.diffuseRoughness&&o.enable(25),A.batchingColor&&o.enable(20),A.gradientMap&&o.enable(21),A.packedNormalMap&&o.enable(22),A.vertexNormals&&o.enable(23),y.push(o.mask),o.disableAll(),A.fog&&o.enable(0),A.useFog&&o.enable(1),A.flatShading&&o.enable(2),A.logarithmicDepthBuffer&&o.enable(3),A.reversedDepthBuffer&&o.enable(4),A.skinning&&o.enable(5),A.morphTargets&&o.enable(6),A.morphNormals&&o.enable(7),A.morphColors&&o.enable(8),A.premultipliedAlpha&&o.enable(9),A.shadowMapEnabled&&o.enable(10),A.doubleSided&&o.enable(11),A.flipSided&&o.enable(12),A.useDepthPacking&&o.enable(13),A.dithering&&o.enable(14),A.transmission&&o.enable(15),A.sheen&&o.enable(16),A.opaque&&o.enable(17),A.pointsUvs&&o.enable(18),A.decodeVideoTexture&&o.enable(19),A.decodeVideoTextureEmissive&&o.enable(20),A.alphaToCoverage&&o.enable(21),A.numLightProbeGrids>0&&o.enable(22),A.hasPositionAttribute&&o.enable(23),y.push(o.mask)}function S(y){let A=f[y.type],V;if(A){let z=Fr[A];V=lg.clone(z.uniforms)}else V=y.uniforms;return V}function T(y,A){let V=u.get(A);return V!==void 0?++V.usedTimes:(V=new WM(i,A,y,r),c.push(V),u.set(A,V)),V}function M(y){if(--y.usedTimes===0){let A=c.indexOf(y);c[A]=c[c.length-1],c.pop(),u.delete(y.cacheKey),y.destroy()}}function P(y){a.remove(y)}function R(){a.dispose()}return{getParameters:m,getProgramCacheKey:b,getUniforms:S,acquireProgram:T,releaseProgram:M,releaseShaderCache:P,programs:c,dispose:R}}function $M(){let i=new WeakMap;function e(o){return i.has(o)}function t(o){let a=i.get(o);return a===void 0&&(a={},i.set(o,a)),a}function n(o){i.delete(o)}function r(o,a,l){i.get(o)[a]=l}function s(){i=new WeakMap}return{has:e,get:t,remove:n,update:r,dispose:s}}function ZM(i,e){return i.groupOrder!==e.groupOrder?i.groupOrder-e.groupOrder:i.renderOrder!==e.renderOrder?i.renderOrder-e.renderOrder:i.material.id!==e.material.id?i.material.id-e.material.id:i.materialVariant!==e.materialVariant?i.materialVariant-e.materialVariant:i.z!==e.z?i.z-e.z:i.id-e.id}function Rg(i,e){return i.groupOrder!==e.groupOrder?i.groupOrder-e.groupOrder:i.renderOrder!==e.renderOrder?i.renderOrder-e.renderOrder:i.z!==e.z?e.z-i.z:i.id-e.id}function Cg(){let i=[],e=0,t=[],n=[],r=[];function s(){e=0,t.length=0,n.length=0,r.length=0}function o(f){let d=0;return f.isInstancedMesh&&(d+=2),f.isSkinnedMesh&&(d+=1),d}function a(f,d,m,b,g,_){let S=i[e];return S===void 0?(S={id:f.id,object:f,geometry:d,material:m,materialVariant:o(f),groupOrder:b,renderOrder:f.renderOrder,z:g,group:_},i[e]=S):(S.id=f.id,S.object=f,S.geometry=d,S.material=m,S.materialVariant=o(f),S.groupOrder=b,S.renderOrder=f.renderOrder,S.z=g,S.group=_),e++,S}function l(f,d,m,b,g,_,S){S.reversedDepth===!0&&(g=-g);let T=a(f,d,m,b,g,_);m.transmission>0?n.push(T):m.transparent===!0?r.push(T):t.push(T)}function c(f,d,m,b,g,_){let S=a(f,d,m,b,g,_);m.transmission>0?n.unshift(S):m.transparent===!0?r.unshift(S):t.unshift(S)}function u(f,d){t.length>1&&t.sort(f||ZM),n.length>1&&n.sort(d||Rg),r.length>1&&r.sort(d||Rg)}function h(){for(let f=e,d=i.length;f<d;f++){let m=i[f];if(m.id===null)break;m.id=null,m.object=null,m.geometry=null,m.material=null,m.group=null}}return{opaque:t,transmissive:n,transparent:r,init:s,push:l,unshift:c,finish:h,sort:u}}function KM(){let i=new WeakMap;function e(n,r){let s=i.get(n),o;return s===void 0?(o=new Cg,i.set(n,[o])):r>=s.length?(o=new Cg,s.push(o)):o=s[r],o}function t(){i=new WeakMap}return{get:e,dispose:t}}function JM(){let i={};return{get:function(e){if(i[e.id]!==void 0)return i[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={direction:new J,color:new ht};break;case"SpotLight":t={position:new J,direction:new J,color:new ht,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":t={position:new J,color:new ht,distance:0,decay:0};break;case"HemisphereLight":t={direction:new J,skyColor:new ht,groundColor:new ht};break;case"RectAreaLight":t={color:new ht,position:new J,halfWidth:new J,halfHeight:new J};break}return i[e.id]=t,t}}}function jM(){let i={};return{get:function(e){if(i[e.id]!==void 0)return i[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new xt};break;case"SpotLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new xt};break;case"PointLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new xt,shadowCameraNear:1,shadowCameraFar:1e3};break}return i[e.id]=t,t}}}var QM=0;function e2(i,e){return(e.castShadow?2:0)-(i.castShadow?2:0)+(e.map?1:0)-(i.map?1:0)}function t2(i){let e=new JM,t=jM(),n={version:0,hash:{sunLength:-1,directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numSunShadows:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],sun:[],sunShadow:[],sunShadowMap:[],sunShadowMatrix:[],sunShadowCascade:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let c=0;c<9;c++)n.probe.push(new J);let r=new J,s=new it,o=new it;function a(c){let u=0,h=0,f=0;for(let q=0;q<9;q++)n.probe[q].set(0,0,0);let d=0,m=0,b=0,g=0,_=0,S=0,T=0,M=0,P=0,R=0,y=0,A=0,V=0,z=0;c.sort(e2);for(let q=0,Y=c.length;q<Y;q++){let U=c[q],W=U.color,K=U.intensity,$=U.distance,xe=null;if(U.shadow&&U.shadow.map&&(U.shadow.map.texture.format===ai?xe=U.shadow.map.texture:xe=U.shadow.map.depthTexture||U.shadow.map.texture),U.isAmbientLight)u+=W.r*K,h+=W.g*K,f+=W.b*K;else if(U.isLightProbe){for(let ne=0;ne<9;ne++)n.probe[ne].addScaledVector(U.sh.coefficients[ne],K);z++}else if(U.isSunLight){let ne=e.get(U);if(ne.color.copy(U.color).multiplyScalar(U.intensity),U.castShadow){let re=U.shadow,de=t.get(U);de.shadowIntensity=re.intensity,de.shadowBias=re.bias,de.shadowNormalBias=re.normalBias,de.shadowRadius=re.radius,de.shadowMapSize.copy(re.mapSize).multiply(re.getFrameExtents()),n.sunShadow[m]=de,n.sunShadowMap[m]=xe;let ge=re.getViewportCount();for(let pe=0;pe<ge;pe++)n.sunShadowMatrix[b+pe]=re.getMatrix(pe),n.sunShadowCascade[b+pe]=re._cascadeData[pe];b+=ge,m++}n.sun[d]=ne,d++}else if(U.isDirectionalLight){let ne=e.get(U);if(ne.color.copy(U.color).multiplyScalar(U.intensity),U.castShadow){let re=U.shadow,de=t.get(U);de.shadowIntensity=re.intensity,de.shadowBias=re.bias,de.shadowNormalBias=re.normalBias,de.shadowRadius=re.radius,de.shadowMapSize=re.mapSize,n.directionalShadow[g]=de,n.directionalShadowMap[g]=xe,n.directionalShadowMatrix[g]=U.shadow.matrix,P++}n.directional[g]=ne,g++}else if(U.isSpotLight){let ne=e.get(U);ne.position.setFromMatrixPosition(U.matrixWorld),ne.color.copy(W).multiplyScalar(K),ne.distance=$,ne.coneCos=Math.cos(U.angle),ne.penumbraCos=Math.cos(U.angle*(1-U.penumbra)),ne.decay=U.decay,n.spot[S]=ne;let re=U.shadow;if(U.map&&(n.spotLightMap[A]=U.map,A++,re.updateMatrices(U),U.castShadow&&V++),n.spotLightMatrix[S]=re.matrix,U.castShadow){let de=t.get(U);de.shadowIntensity=re.intensity,de.shadowBias=re.bias,de.shadowNormalBias=re.normalBias,de.shadowRadius=re.radius,de.shadowMapSize=re.mapSize,n.spotShadow[S]=de,n.spotShadowMap[S]=xe,y++}S++}else if(U.isRectAreaLight){let ne=e.get(U);ne.color.copy(W).multiplyScalar(K),ne.halfWidth.set(U.width*.5,0,0),ne.halfHeight.set(0,U.height*.5,0),n.rectArea[T]=ne,T++}else if(U.isPointLight){let ne=e.get(U);if(ne.color.copy(U.color).multiplyScalar(U.intensity),ne.distance=U.distance,ne.decay=U.decay,U.castShadow){let re=U.shadow,de=t.get(U);de.shadowIntensity=re.intensity,de.shadowBias=re.bias,de.shadowNormalBias=re.normalBias,de.shadowRadius=re.radius,de.shadowMapSize=re.mapSize,de.shadowCameraNear=re.camera.near,de.shadowCameraFar=re.camera.far,n.pointShadow[_]=de,n.pointShadowMap[_]=xe,n.pointShadowMatrix[_]=U.shadow.matrix,R++}n.point[_]=ne,_++}else if(U.isHemisphereLight){let ne=e.get(U);ne.skyColor.copy(U.color).multiplyScalar(K),ne.groundColor.copy(U.groundColor).multiplyScalar(K),n.hemi[M]=ne,M++}}T>0&&(i.has("OES_texture_float_linear")===!0?(n.rectAreaLTC1=Ye.LTC_FLOAT_1,n.rectAreaLTC2=Ye.LTC_FLOAT_2):(n.rectAreaLTC1=Ye.LTC_HALF_1,n.rectAreaLTC2=Ye.LTC_HALF_2)),n.ambient[0]=u,n.ambient[1]=h,n.ambient[2]=f;let D=n.hash;(D.sunLength!==d||D.directionalLength!==g||D.pointLength!==_||D.spotLength!==S||D.rectAreaLength!==T||D.hemiLength!==M||D.numSunShadows!==m||D.numDirectionalShadows!==P||D.numPointShadows!==R||D.numSpotShadows!==y||D.numSpotMaps!==A||D.numLightProbes!==z)&&(n.sun.length=d,n.directional.length=g,n.spot.length=S,n.rectArea.length=T,n.point.length=_,n.hemi.length=M,n.sunShadow.length=m,n.sunShadowMap.length=m,n.sunShadowMatrix.length=b,n.sunShadowCascade.length=b,n.directionalShadow.length=P,n.directionalShadowMap.length=P,n.directionalShadowMatrix.length=P,n.pointShadow.length=R,n.pointShadowMap.length=R,n.pointShadowMatrix.length=R,n.spotShadow.length=y,n.spotShadowMap.length=y,n.spotLightMatrix.length=y+A-V,n.spotLightMap.length=A,n.numSpotLightShadowsWithMaps=V,n.numLightProbes=z,D.sunLength=d,D.directionalLength=g,D.pointLength=_,D.spotLength=S,D.rectAreaLength=T,D.hemiLength=M,D.numSunShadows=m,D.numDirectionalShadows=P,D.numPointShadows=R,D.numSpotShadows=y,D.numSpotMaps=A,D.numLightProbes=z,n.version=QM++)}function l(c,u){let h=0,f=0,d=0,m=0,b=0,g=0,_=u.matrixWorldInverse;for(let S=0,T=c.length;S<T;S++){let M=c[S];if(M.isSunLight){let P=n.sun[h];P.direction.setFromMatrixPosition(M.matrixWorld),P.direction.transformDirection(_),h++}else if(M.isDirectionalLight){let P=n.directional[f];P.direction.setFromMatrixPosition(M.matrixWorld),r.setFromMatrixPosition(M.target.matrixWorld),P.direction.sub(r),P.direction.transformDirection(_),f++}else if(M.isSpotLight){let P=n.spot[m];P.position.setFromMatrixPosition(M.matrixWorld),P.position.applyMatrix4(_),P.direction.setFromMatrixPosition(M.matrixWorld),r.setFromMatrixPosition(M.target.matrixWorld),P.direction.sub(r),P.direction.transformDirection(_),m++}else if(M.isRectAreaLight){let P=n.rectArea[b];P.position.setFromMatrixPosition(M.matrixWorld),P.position.applyMatrix4(_),o.identity(),s.copy(M.matrixWorld),s.premultiply(_),o.extractRotation(s),P.halfWidth.set(M.width*.5,0,0),P.halfHeight.set(0,M.height*.5,0),P.halfWidth.applyMatrix4(o),P.halfHeight.applyMatrix4(o),b++}else if(M.isPointLight){let P=n.point[d];P.position.setFromMatrixPosition(M.matrixWorld),P.position.applyMatrix4(_),d++}else if(M.isHemisphereLight){let P=n.hemi[g];P.direction.setFromMatrixPosition(M.matrixWorld),P.direction.transformDirection(_),g++}}}return{setup:a,setupView:l,state:n}}function Ig(i){let e=new t2(i),t=[],n=[],r=[];function s(h){u.camera=h,t.length=0,n.length=0,r.length=0}function o(h){h.isLightProbeGrid?r.push(h):t.push(h)}function a(h){n.push(h)}function l(){e.setup(t),r.sort((h,f)=>h.priority-f.priority||h.id-f.id)}function c(h){e.setupView(t,h)}let u={lightsArray:t,shadowsArray:n,lightProbeGridArray:r,camera:null,lights:e,transmissionRenderTarget:{},textureUnits:0};return{init:s,state:u,setupLights:l,setupLightsView:c,pushLight:o,pushShadow:a}}function n2(i){let e=new WeakMap;function t(r,s=0){let o=e.get(r),a;return o===void 0?(a=new Ig(i),e.set(r,[a])):s>=o.length?(a=new Ig(i),o.push(a)):a=o[s],a}function n(){e=new WeakMap}return{get:t,dispose:n}}var i2=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,r2=`uniform sampler2D shadow_pass;
uniform vec2 resolution;
uniform float radius;
void main() {
	const float samples = float( VSM_SAMPLES );
	float mean = 0.0;
	float squared_mean = 0.0;
	float uvStride = samples <= 1.0 ? 0.0 : 2.0 / ( samples - 1.0 );
	float uvStart = samples <= 1.0 ? 0.0 : - 1.0;
	for ( float i = 0.0; i < samples; i ++ ) {
		float uvOffset = uvStart + i * uvStride;
		#ifdef HORIZONTAL_PASS
			vec2 distribution = texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( uvOffset, 0.0 ) * radius ) / resolution ).rg;
			mean += distribution.x;
			squared_mean += distribution.y * distribution.y + distribution.x * distribution.x;
		#else
			float depth = texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( 0.0, uvOffset ) * radius ) / resolution ).r;
			mean += depth;
			squared_mean += depth * depth;
		#endif
	}
	mean = mean / samples;
	squared_mean = squared_mean / samples;
	float std_dev = sqrt( max( 0.0, squared_mean - mean * mean ) );
	gl_FragColor = vec4( mean, std_dev, 0.0, 1.0 );
}`,s2=[new J(1,0,0),new J(-1,0,0),new J(0,1,0),new J(0,-1,0),new J(0,0,1),new J(0,0,-1)],o2=[new J(0,-1,0),new J(0,-1,0),new J(0,0,1),new J(0,0,-1),new J(0,-1,0),new J(0,-1,0)],Pg=new it,Fl=new J,xd=new J;function a2(i,e,t){let n=new Ds,r=new xt,s=new xt,o=new Ot,a=new $c,l=new Zc,c={},u=t.maxTextureSize,h={[Pr]:mi,[mi]:Pr,[Xi]:Xi},f=new Cr({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new xt},radius:{value:4}},vertexShader:i2,fragmentShader:r2}),d=f.clone();d.defines.HORIZONTAL_PASS=1;let m=new _n;m.setAttribute("position",new an(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let b=new In(m,f),g=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=Tl;let _=this.type;this.render=function(R,y,A){if(g.enabled===!1||g.autoUpdate===!1&&g.needsUpdate===!1||R.length===0)return;this.type===A0&&(nt("WebGLShadowMap: PCFSoftShadowMap has been removed. Using PCFShadowMap instead."),this.type=Tl);let V=i.getRenderTarget(),z=i.getActiveCubeFace(),D=i.getActiveMipmapLevel(),q=i.state;q.setBlending(uo),q.buffers.depth.getReversed()===!0?q.buffers.color.setClear(0,0,0,0):q.buffers.color.setClear(1,1,1,1),q.buffers.depth.setTest(!0),q.setScissorTest(!1);let Y=_!==this.type;Y&&y.traverse(function(U){U.material&&(Array.isArray(U.material)?U.material.forEach(W=>W.needsUpdate=!0):U.material.needsUpdate=!0)});for(let U=0,W=R.length;U<W;U++){let K=R[U],$=K.shadow;if($===void 0){nt("WebGLShadowMap:",K,"has no shadow.");continue}if($.autoUpdate===!1&&$.needsUpdate===!1)continue;r.copy($.mapSize);let xe=$.getFrameExtents();r.multiply(xe),s.copy($.mapSize),(r.x>u||r.y>u)&&(r.x>u&&(s.x=Math.floor(u/xe.x),r.x=s.x*xe.x,$.mapSize.x=s.x),r.y>u&&(s.y=Math.floor(u/xe.y),r.y=s.y*xe.y,$.mapSize.y=s.y));let ne=i.state.buffers.depth.getReversed();if($.camera._reversedDepth=ne,$.map===null||Y===!0){if($.map!==null&&($.map.depthTexture!==null&&($.map.depthTexture.dispose(),$.map.depthTexture=null),$.map.dispose()),this.type===ua){if(K.isPointLight){nt("WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.");continue}$.map=new Zn(r.x,r.y,{format:ai,type:tn,minFilter:qt,magFilter:qt,generateMipmaps:!1}),$.map.texture.name=K.name+".shadowMap",$.map.depthTexture=new cr(r.x,r.y,Nt),$.map.depthTexture.name=K.name+".shadowMapDepth",$.map.depthTexture.format=jr,$.map.depthTexture.compareFunction=null,$.map.depthTexture.minFilter=Ut,$.map.depthTexture.magFilter=Ut}else K.isPointLight?($.map=new Ol(r.x),$.map.depthTexture=new pl(r.x,ur)):($.map=new Zn(r.x,r.y),$.map.depthTexture=new cr(r.x,r.y,ur)),$.map.depthTexture.name=K.name+".shadowMap",$.map.depthTexture.format=jr,this.type===Tl?($.map.depthTexture.compareFunction=ne?od:sd,$.map.depthTexture.minFilter=qt,$.map.depthTexture.magFilter=qt):($.map.depthTexture.compareFunction=null,$.map.depthTexture.minFilter=Ut,$.map.depthTexture.magFilter=Ut);$.camera.updateProjectionMatrix()}$.map.isWebGLCubeRenderTarget!==!0&&($.map.width!==r.x||$.map.height!==r.y)&&$.map.setSize(r.x,r.y);let re=$.map.isWebGLCubeRenderTarget?6:$.getViewportCount();K.isPointLight!==!0&&$.updateMatrices(K,A);let de=($.camera.layers.mask&4294967294)!==0?$.camera.layers:A.layers;for(let ge=0;ge<re;ge++){let pe=$.getCamera(ge);if(K.isPointLight){let se=$.camera,Ee=$.matrix,Pe=K.distance||se.far;Pe!==se.far&&(se.far=Pe,se.updateProjectionMatrix()),Fl.setFromMatrixPosition(K.matrixWorld),se.position.copy(Fl),xd.copy(se.position),xd.add(s2[ge]),se.up.copy(o2[ge]),se.lookAt(xd),se.updateMatrixWorld(),Ee.makeTranslation(-Fl.x,-Fl.y,-Fl.z),Pg.multiplyMatrices(se.projectionMatrix,se.matrixWorldInverse),$._frustum.setFromProjectionMatrix(Pg,se.coordinateSystem,se.reversedDepth)}if($.map.isWebGLCubeRenderTarget)i.setRenderTarget($.map,ge),i.clear();else{ge===0&&(i.setRenderTarget($.map),i.clear());let se=$.getViewport(ge);o.set(s.x*se.x,s.y*se.y,s.x*se.z,s.y*se.w),q.viewport(o)}n=$.getFrustum(ge),M(y,A,pe,K,de,this.type)}$.isPointLightShadow!==!0&&this.type===ua&&S($,A),$.needsUpdate=!1}_=this.type,g.needsUpdate=!1,i.setRenderTarget(V,z,D)};function S(R,y){let A=e.update(b);f.defines.VSM_SAMPLES!==R.blurSamples&&(f.defines.VSM_SAMPLES=R.blurSamples,d.defines.VSM_SAMPLES=R.blurSamples,f.needsUpdate=!0,d.needsUpdate=!0),R.mapPass===null?R.mapPass=new Zn(r.x,r.y,{format:ai,type:tn}):(R.mapPass.width!==R.map.width||R.mapPass.height!==R.map.height)&&R.mapPass.setSize(R.map.width,R.map.height),f.uniforms.shadow_pass.value=R.map.depthTexture,f.uniforms.resolution.value.set(R.map.width,R.map.height),f.uniforms.radius.value=R.radius,i.setRenderTarget(R.mapPass),i.clear(),i.renderBufferDirect(y,null,A,f,b,null),d.uniforms.shadow_pass.value=R.mapPass.texture,d.uniforms.resolution.value.set(R.map.width,R.map.height),d.uniforms.radius.value=R.radius,i.setRenderTarget(R.map),i.clear(),i.renderBufferDirect(y,null,A,d,b,null)}function T(R,y,A,V){let z=null,D=A.isPointLight===!0?R.customDistanceMaterial:R.customDepthMaterial;if(D!==void 0)z=D;else if(z=A.isPointLight===!0?l:a,i.localClippingEnabled&&y.clipShadows===!0&&Array.isArray(y.clippingPlanes)&&y.clippingPlanes.length!==0||y.displacementMap&&y.displacementScale!==0||y.alphaMap&&y.alphaTest>0||y.map&&y.alphaTest>0||y.alphaToCoverage===!0){let q=z.uuid,Y=y.uuid,U=c[q];U===void 0&&(U={},c[q]=U);let W=U[Y];W===void 0&&(W=z.clone(),U[Y]=W,y.addEventListener("dispose",P)),z=W}if(z.visible=y.visible,z.wireframe=y.wireframe,V===ua?z.side=y.shadowSide!==null?y.shadowSide:y.side:z.side=y.shadowSide!==null?y.shadowSide:h[y.side],z.alphaMap=y.alphaMap,z.alphaTest=y.alphaToCoverage===!0?.5:y.alphaTest,z.map=y.map,z.clipShadows=y.clipShadows,z.clippingPlanes=y.clippingPlanes,z.clipIntersection=y.clipIntersection,z.displacementMap=y.displacementMap,z.displacementScale=y.displacementScale,z.displacementBias=y.displacementBias,z.wireframeLinewidth=y.wireframeLinewidth,z.linewidth=y.linewidth,A.isPointLight===!0&&z.isMeshDistanceMaterial===!0){let q=i.properties.get(z);q.light=A}return z}function M(R,y,A,V,z,D){if(R.visible===!1)return;if(R.layers.test(z)&&(R.isMesh||R.isLine||R.isPoints)&&(R.castShadow||R.receiveShadow&&D===ua)&&(!R.frustumCulled||R.intersectsFrustum(n))){R.modelViewMatrix.multiplyMatrices(A.matrixWorldInverse,R.matrixWorld);let U=e.update(R),W=R.material;if(Array.isArray(W)){let K=U.groups;for(let $=0,xe=K.length;$<xe;$++){let ne=K[$],re=W[ne.materialIndex];if(re&&re.visible){let de=T(R,re,V,D);R.onBeforeShadow(i,R,y,A,U,de,ne),i.renderBufferDirect(A,null,U,de,R,ne),R.onAfterShadow(i,R,y,A,U,de,ne)}}}else if(W.visible){let K=T(R,W,V,D);R.onBeforeShadow(i,R,y,A,U,K,null),i.renderBufferDirect(A,null,U,K,R,null),R.onAfterShadow(i,R,y,A,U,K,null)}}let Y=R.children;for(let U=0,W=Y.length;U<W;U++)M(Y[U],y,A,V,z,D)}function P(R){R.target.removeEventListener("dispose",P);for(let A in c){let V=c[A],z=R.target.uuid;z in V&&(V[z].dispose(),delete V[z])}}}function l2(i,e){function t(){let H=!1,ue=new Ot,oe=null,ke=new Ot(0,0,0,0);return{setMask:function(Le){oe!==Le&&!H&&(i.colorMask(Le,Le,Le,Le),oe=Le)},setLocked:function(Le){H=Le},setClear:function(Le,Be,tt,pt,we){we===!0&&(Le*=pt,Be*=pt,tt*=pt),ue.set(Le,Be,tt,pt),ke.equals(ue)===!1&&(i.clearColor(Le,Be,tt,pt),ke.copy(ue))},reset:function(){H=!1,oe=null,ke.set(-1,0,0,0)}}}function n(){let H=!1,ue=!1,oe=null,ke=null,Le=null;return{setReversed:function(Be){if(ue!==Be){let tt=e.get("EXT_clip_control");Be?tt.clipControlEXT(tt.LOWER_LEFT_EXT,tt.ZERO_TO_ONE_EXT):tt.clipControlEXT(tt.LOWER_LEFT_EXT,tt.NEGATIVE_ONE_TO_ONE_EXT),ue=Be;let pt=Le;Le=null,this.setClear(pt)}},getReversed:function(){return ue},setTest:function(Be){Be?ye(i.DEPTH_TEST):Ke(i.DEPTH_TEST)},setMask:function(Be){oe!==Be&&!H&&(i.depthMask(Be),oe=Be)},setFunc:function(Be){if(ue&&(Be=og[Be]),ke!==Be){switch(Be){case Fc:i.depthFunc(i.NEVER);break;case Uc:i.depthFunc(i.ALWAYS);break;case Oc:i.depthFunc(i.LESS);break;case Zo:i.depthFunc(i.LEQUAL);break;case Bc:i.depthFunc(i.EQUAL);break;case zc:i.depthFunc(i.GEQUAL);break;case kc:i.depthFunc(i.GREATER);break;case Vc:i.depthFunc(i.NOTEQUAL);break;default:i.depthFunc(i.LEQUAL)}ke=Be}},setLocked:function(Be){H=Be},setClear:function(Be){Le!==Be&&(Le=Be,ue&&(Be=1-Be),i.clearDepth(Be))},reset:function(){H=!1,oe=null,ke=null,Le=null,ue=!1}}}function r(){let H=!1,ue=null,oe=null,ke=null,Le=null,Be=null,tt=null,pt=null,we=null;return{setTest:function(Je){H||(Je?ye(i.STENCIL_TEST):Ke(i.STENCIL_TEST))},setMask:function(Je){ue!==Je&&!H&&(i.stencilMask(Je),ue=Je)},setFunc:function(Je,mt,Ge){(oe!==Je||ke!==mt||Le!==Ge)&&(i.stencilFunc(Je,mt,Ge),oe=Je,ke=mt,Le=Ge)},setOp:function(Je,mt,Ge){(Be!==Je||tt!==mt||pt!==Ge)&&(i.stencilOp(Je,mt,Ge),Be=Je,tt=mt,pt=Ge)},setLocked:function(Je){H=Je},setClear:function(Je){we!==Je&&(i.clearStencil(Je),we=Je)},reset:function(){H=!1,ue=null,oe=null,ke=null,Le=null,Be=null,tt=null,pt=null,we=null}}}let s=new t,o=new n,a=new r,l={},c=new WeakMap,u={},h={},f={},d=new WeakMap,m=[],b=null,g=!1,_=null,S=null,T=null,M=null,P=null,R=null,y=null,A=new ht(0,0,0),V=0,z=!1,D=null,q=null,Y=null,U=null,W=null,K=i.getParameter(i.MAX_COMBINED_TEXTURE_IMAGE_UNITS),$=!1,xe=0,ne=i.getParameter(i.VERSION);ne.indexOf("WebGL")!==-1?(xe=parseFloat(/^WebGL (\d)/.exec(ne)[1]),$=xe>=1):ne.indexOf("OpenGL ES")!==-1&&(xe=parseFloat(/^OpenGL ES (\d)/.exec(ne)[1]),$=xe>=2);let re=null,de={},ge=i.getParameter(i.SCISSOR_BOX),pe=i.getParameter(i.VIEWPORT),se=new Ot().fromArray(ge),Ee=new Ot().fromArray(pe);function Pe(H,ue,oe,ke){let Le=new Uint8Array(4),Be=i.createTexture();i.bindTexture(H,Be),i.texParameteri(H,i.TEXTURE_MIN_FILTER,i.NEAREST),i.texParameteri(H,i.TEXTURE_MAG_FILTER,i.NEAREST);for(let tt=0;tt<oe;tt++)H===i.TEXTURE_3D||H===i.TEXTURE_2D_ARRAY?i.texImage3D(ue,0,i.RGBA,1,1,ke,0,i.RGBA,i.UNSIGNED_BYTE,Le):i.texImage2D(ue+tt,0,i.RGBA,1,1,0,i.RGBA,i.UNSIGNED_BYTE,Le);return Be}let Oe={};Oe[i.TEXTURE_2D]=Pe(i.TEXTURE_2D,i.TEXTURE_2D,1),Oe[i.TEXTURE_CUBE_MAP]=Pe(i.TEXTURE_CUBE_MAP,i.TEXTURE_CUBE_MAP_POSITIVE_X,6),Oe[i.TEXTURE_2D_ARRAY]=Pe(i.TEXTURE_2D_ARRAY,i.TEXTURE_2D_ARRAY,1,1),Oe[i.TEXTURE_3D]=Pe(i.TEXTURE_3D,i.TEXTURE_3D,1,1),s.setClear(0,0,0,1),o.setClear(1),a.setClear(0),ye(i.DEPTH_TEST),o.setFunc(Zo),mn(!1),Xt(Bf),ye(i.CULL_FACE),Zt(uo);function ye(H){u[H]!==!0&&(i.enable(H),u[H]=!0)}function Ke(H){u[H]!==!1&&(i.disable(H),u[H]=!1)}function ft(H,ue){return f[H]!==ue?(i.bindFramebuffer(H,ue),f[H]=ue,H===i.DRAW_FRAMEBUFFER&&(f[i.FRAMEBUFFER]=ue),H===i.FRAMEBUFFER&&(f[i.DRAW_FRAMEBUFFER]=ue),!0):!1}function et(H,ue){let oe=m,ke=!1;if(H){oe=d.get(ue),oe===void 0&&(oe=[],d.set(ue,oe));let Le=H.textures;if(oe.length!==Le.length||oe[0]!==i.COLOR_ATTACHMENT0){for(let Be=0,tt=Le.length;Be<tt;Be++)oe[Be]=i.COLOR_ATTACHMENT0+Be;oe.length=Le.length,ke=!0}}else oe[0]!==i.BACK&&(oe[0]=i.BACK,ke=!0);ke&&i.drawBuffers(oe)}function St(H){return b!==H?(i.useProgram(H),b=H,!0):!1}let bt={[ho]:i.FUNC_ADD,[R0]:i.FUNC_SUBTRACT,[C0]:i.FUNC_REVERSE_SUBTRACT};bt[I0]=i.MIN,bt[P0]=i.MAX;let vt={[L0]:i.ZERO,[N0]:i.ONE,[D0]:i.SRC_COLOR,[Hf]:i.SRC_ALPHA,[k0]:i.SRC_ALPHA_SATURATE,[B0]:i.DST_COLOR,[U0]:i.DST_ALPHA,[F0]:i.ONE_MINUS_SRC_COLOR,[Gf]:i.ONE_MINUS_SRC_ALPHA,[z0]:i.ONE_MINUS_DST_COLOR,[O0]:i.ONE_MINUS_DST_ALPHA,[V0]:i.CONSTANT_COLOR,[H0]:i.ONE_MINUS_CONSTANT_COLOR,[G0]:i.CONSTANT_ALPHA,[W0]:i.ONE_MINUS_CONSTANT_ALPHA};function Zt(H,ue,oe,ke,Le,Be,tt,pt,we,Je){if(H===uo){g===!0&&(Ke(i.BLEND),g=!1);return}if(g===!1&&(ye(i.BLEND),g=!0),H!==E0){if(H!==_||Je!==z){if((S!==ho||P!==ho)&&(i.blendEquation(i.FUNC_ADD),S=ho,P=ho),Je)switch(H){case ha:i.blendFuncSeparate(i.ONE,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case zf:i.blendFunc(i.ONE,i.ONE);break;case kf:i.blendFuncSeparate(i.ZERO,i.ONE_MINUS_SRC_COLOR,i.ZERO,i.ONE);break;case Vf:i.blendFuncSeparate(i.DST_COLOR,i.ONE_MINUS_SRC_ALPHA,i.ZERO,i.ONE);break;default:_t("WebGLState: Invalid blending: ",H);break}else switch(H){case ha:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case zf:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE,i.ONE,i.ONE);break;case kf:_t("WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case Vf:_t("WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:_t("WebGLState: Invalid blending: ",H);break}T=null,M=null,R=null,y=null,A.set(0,0,0),V=0,_=H,z=Je}return}Le=Le||ue,Be=Be||oe,tt=tt||ke,(ue!==S||Le!==P)&&(i.blendEquationSeparate(bt[ue],bt[Le]),S=ue,P=Le),(oe!==T||ke!==M||Be!==R||tt!==y)&&(i.blendFuncSeparate(vt[oe],vt[ke],vt[Be],vt[tt]),T=oe,M=ke,R=Be,y=tt),(pt.equals(A)===!1||we!==V)&&(i.blendColor(pt.r,pt.g,pt.b,we),A.copy(pt),V=we),_=H,z=!1}function kt(H,ue){H.side===Xi?Ke(i.CULL_FACE):ye(i.CULL_FACE);let oe=H.side===mi;ue&&(oe=!oe),mn(oe),H.blending===ha&&H.transparent===!1?Zt(uo):Zt(H.blending,H.blendEquation,H.blendSrc,H.blendDst,H.blendEquationAlpha,H.blendSrcAlpha,H.blendDstAlpha,H.blendColor,H.blendAlpha,H.premultipliedAlpha),o.setFunc(H.depthFunc),o.setTest(H.depthTest),o.setMask(H.depthWrite),s.setMask(H.colorWrite);let ke=H.stencilWrite;a.setTest(ke),ke&&(a.setMask(H.stencilWriteMask),a.setFunc(H.stencilFunc,H.stencilRef,H.stencilFuncMask),a.setOp(H.stencilFail,H.stencilZFail,H.stencilZPass)),Pt(H.polygonOffset,H.polygonOffsetFactor,H.polygonOffsetUnits),H.alphaToCoverage===!0?ye(i.SAMPLE_ALPHA_TO_COVERAGE):Ke(i.SAMPLE_ALPHA_TO_COVERAGE)}function mn(H){D!==H&&(H?i.frontFace(i.CW):i.frontFace(i.CCW),D=H)}function Xt(H){H!==M0?(ye(i.CULL_FACE),H!==q&&(H===Bf?i.cullFace(i.BACK):H===T0?i.cullFace(i.FRONT):i.cullFace(i.FRONT_AND_BACK))):Ke(i.CULL_FACE),q=H}function Dn(H){H!==Y&&($&&i.lineWidth(H),Y=H)}function Pt(H,ue,oe){H?(ye(i.POLYGON_OFFSET_FILL),(U!==ue||W!==oe)&&(U=ue,W=oe,o.getReversed()&&(ue=-ue,oe=-oe),i.polygonOffset(ue,oe))):Ke(i.POLYGON_OFFSET_FILL)}function Tn(H){H?ye(i.SCISSOR_TEST):Ke(i.SCISSOR_TEST)}function ln(H){H===void 0&&(H=i.TEXTURE0+K-1),re!==H&&(i.activeTexture(H),re=H)}function An(H,ue,oe){oe===void 0&&(re===null?oe=i.TEXTURE0+K-1:oe=re);let ke=de[oe];ke===void 0&&(ke={type:void 0,texture:void 0},de[oe]=ke),(ke.type!==H||ke.texture!==ue)&&(re!==oe&&(i.activeTexture(oe),re=oe),i.bindTexture(H,ue||Oe[H]),ke.type=H,ke.texture=ue)}function G(){let H=de[re];H!==void 0&&H.type!==void 0&&(i.bindTexture(H.type,null),H.type=void 0,H.texture=void 0)}function He(){try{i.compressedTexImage2D(...arguments)}catch(H){_t("WebGLState:",H)}}function ct(){try{i.compressedTexImage3D(...arguments)}catch(H){_t("WebGLState:",H)}}function yt(){try{i.texSubImage2D(...arguments)}catch(H){_t("WebGLState:",H)}}function De(){try{i.texSubImage3D(...arguments)}catch(H){_t("WebGLState:",H)}}function Kt(){try{i.compressedTexSubImage2D(...arguments)}catch(H){_t("WebGLState:",H)}}function je(){try{i.compressedTexSubImage3D(...arguments)}catch(H){_t("WebGLState:",H)}}function lt(){try{i.texStorage2D(...arguments)}catch(H){_t("WebGLState:",H)}}function F(){try{i.texStorage3D(...arguments)}catch(H){_t("WebGLState:",H)}}function E(){try{i.texImage2D(...arguments)}catch(H){_t("WebGLState:",H)}}function ee(){try{i.texImage3D(...arguments)}catch(H){_t("WebGLState:",H)}}function be(H){return h[H]!==void 0?h[H]:i.getParameter(H)}function me(H,ue){h[H]!==ue&&(i.pixelStorei(H,ue),h[H]=ue)}function Ne(H){se.equals(H)===!1&&(i.scissor(H.x,H.y,H.z,H.w),se.copy(H))}function Fe(H){Ee.equals(H)===!1&&(i.viewport(H.x,H.y,H.z,H.w),Ee.copy(H))}function ae(H,ue){let oe=c.get(ue);oe===void 0&&(oe=new WeakMap,c.set(ue,oe));let ke=oe.get(H);ke===void 0&&(ke=i.getUniformBlockIndex(ue,H.name),i.uniformBlockBinding(ue,ke,ke),oe.set(H,ke))}function he(H,ue,oe){let Le=c.get(ue).get(H);l[Le]!==oe&&(i.bindBufferBase(i.UNIFORM_BUFFER,Le,oe),l[Le]=oe)}function Re(){i.disable(i.BLEND),i.disable(i.CULL_FACE),i.disable(i.DEPTH_TEST),i.disable(i.POLYGON_OFFSET_FILL),i.disable(i.SCISSOR_TEST),i.disable(i.STENCIL_TEST),i.disable(i.SAMPLE_ALPHA_TO_COVERAGE),i.blendEquation(i.FUNC_ADD),i.blendFunc(i.ONE,i.ZERO),i.blendFuncSeparate(i.ONE,i.ZERO,i.ONE,i.ZERO),i.blendColor(0,0,0,0),i.colorMask(!0,!0,!0,!0),i.clearColor(0,0,0,0),i.depthMask(!0),i.depthFunc(i.LESS),o.setReversed(!1),i.clearDepth(1),i.stencilMask(4294967295),i.stencilFunc(i.ALWAYS,0,4294967295),i.stencilOp(i.KEEP,i.KEEP,i.KEEP),i.clearStencil(0),i.cullFace(i.BACK),i.frontFace(i.CCW),i.polygonOffset(0,0),i.activeTexture(i.TEXTURE0),i.bindFramebuffer(i.FRAMEBUFFER,null),i.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),i.bindFramebuffer(i.READ_FRAMEBUFFER,null),i.useProgram(null),i.lineWidth(1),i.scissor(0,0,i.canvas.width,i.canvas.height),i.viewport(0,0,i.canvas.width,i.canvas.height),i.pixelStorei(i.PACK_ALIGNMENT,4),i.pixelStorei(i.UNPACK_ALIGNMENT,4),i.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,!1),i.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),i.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,i.BROWSER_DEFAULT_WEBGL),i.pixelStorei(i.PACK_ROW_LENGTH,0),i.pixelStorei(i.PACK_SKIP_PIXELS,0),i.pixelStorei(i.PACK_SKIP_ROWS,0),i.pixelStorei(i.UNPACK_ROW_LENGTH,0),i.pixelStorei(i.UNPACK_IMAGE_HEIGHT,0),i.pixelStorei(i.UNPACK_SKIP_PIXELS,0),i.pixelStorei(i.UNPACK_SKIP_ROWS,0),i.pixelStorei(i.UNPACK_SKIP_IMAGES,0),u={},h={},re=null,de={},f={},l={},d=new WeakMap,m=[],b=null,g=!1,_=null,S=null,T=null,M=null,P=null,R=null,y=null,A=new ht(0,0,0),V=0,z=!1,D=null,q=null,Y=null,U=null,W=null,se.set(0,0,i.canvas.width,i.canvas.height),Ee.set(0,0,i.canvas.width,i.canvas.height),s.reset(),o.reset(),a.reset()}return{buffers:{color:s,depth:o,stencil:a},enable:ye,disable:Ke,bindFramebuffer:ft,drawBuffers:et,useProgram:St,setBlending:Zt,setMaterial:kt,setFlipSided:mn,setCullFace:Xt,setLineWidth:Dn,setPolygonOffset:Pt,setScissorTest:Tn,activeTexture:ln,bindTexture:An,unbindTexture:G,compressedTexImage2D:He,compressedTexImage3D:ct,texImage2D:E,texImage3D:ee,pixelStorei:me,getParameter:be,updateUBOMapping:ae,uniformBlockBinding:he,texStorage2D:lt,texStorage3D:F,texSubImage2D:yt,texSubImage3D:De,compressedTexSubImage2D:Kt,compressedTexSubImage3D:je,scissor:Ne,viewport:Fe,reset:Re}}function c2(i,e,t,n,r,s,o){let a=e.has("WEBGL_multisampled_render_to_texture")?e.get("WEBGL_multisampled_render_to_texture"):null,l=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),c=new xt,u=new WeakMap,h=new Set,f,d=new WeakMap,m=new Set,b=new FinalizationRegistry(F=>m.delete(F)),g=!1;try{g=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function _(F,E){return g?new OffscreenCanvas(F,E):jo("canvas")}function S(F,E,ee){let be=1,me=lt(F);if((me.width>ee||me.height>ee)&&(be=ee/Math.max(me.width,me.height)),be<1)if(typeof HTMLImageElement<"u"&&F instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&F instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&F instanceof ImageBitmap||typeof VideoFrame<"u"&&F instanceof VideoFrame){let Ne=Math.floor(be*me.width),Fe=Math.floor(be*me.height);f===void 0&&(f=_(Ne,Fe));let ae=E?_(Ne,Fe):f;return ae.width=Ne,ae.height=Fe,ae.getContext("2d").drawImage(F,0,0,Ne,Fe),nt("WebGLRenderer: Texture has been resized from ("+me.width+"x"+me.height+") to ("+Ne+"x"+Fe+")."),ae}else return"data"in F&&nt("WebGLRenderer: Image in DataTexture is too big ("+me.width+"x"+me.height+")."),F;return F}function T(F){return F.generateMipmaps}function M(F){i.generateMipmap(F)}function P(F){return F.isWebGLCubeRenderTarget?i.TEXTURE_CUBE_MAP:F.isWebGL3DRenderTarget?i.TEXTURE_3D:F.isWebGLArrayRenderTarget||F.isCompressedArrayTexture?i.TEXTURE_2D_ARRAY:i.TEXTURE_2D}function R(F,E,ee,be,me,Ne=!1){if(F!==null){if(i[F]!==void 0)return i[F];nt("WebGLRenderer: Attempt to use non-existing WebGL internal format '"+F+"'")}let Fe;be&&(Fe=e.get("EXT_texture_norm16"),Fe||nt("WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension"));let ae=E;if(E===i.RED&&(ee===i.FLOAT&&(ae=i.R32F),ee===i.HALF_FLOAT&&(ae=i.R16F),ee===i.UNSIGNED_BYTE&&(ae=i.R8),ee===i.UNSIGNED_SHORT&&Fe&&(ae=Fe.R16_EXT),ee===i.SHORT&&Fe&&(ae=Fe.R16_SNORM_EXT)),E===i.RED_INTEGER&&(ee===i.UNSIGNED_BYTE&&(ae=i.R8UI),ee===i.UNSIGNED_SHORT&&(ae=i.R16UI),ee===i.UNSIGNED_INT&&(ae=i.R32UI),ee===i.BYTE&&(ae=i.R8I),ee===i.SHORT&&(ae=i.R16I),ee===i.INT&&(ae=i.R32I)),E===i.RG&&(ee===i.FLOAT&&(ae=i.RG32F),ee===i.HALF_FLOAT&&(ae=i.RG16F),ee===i.UNSIGNED_BYTE&&(ae=i.RG8),ee===i.UNSIGNED_SHORT&&Fe&&(ae=Fe.RG16_EXT),ee===i.SHORT&&Fe&&(ae=Fe.RG16_SNORM_EXT)),E===i.RG_INTEGER&&(ee===i.UNSIGNED_BYTE&&(ae=i.RG8UI),ee===i.UNSIGNED_SHORT&&(ae=i.RG16UI),ee===i.UNSIGNED_INT&&(ae=i.RG32UI),ee===i.BYTE&&(ae=i.RG8I),ee===i.SHORT&&(ae=i.RG16I),ee===i.INT&&(ae=i.RG32I)),E===i.RGB_INTEGER&&(ee===i.UNSIGNED_BYTE&&(ae=i.RGB8UI),ee===i.UNSIGNED_SHORT&&(ae=i.RGB16UI),ee===i.UNSIGNED_INT&&(ae=i.RGB32UI),ee===i.BYTE&&(ae=i.RGB8I),ee===i.SHORT&&(ae=i.RGB16I),ee===i.INT&&(ae=i.RGB32I)),E===i.RGBA_INTEGER&&(ee===i.UNSIGNED_BYTE&&(ae=i.RGBA8UI),ee===i.UNSIGNED_SHORT&&(ae=i.RGBA16UI),ee===i.UNSIGNED_INT&&(ae=i.RGBA32UI),ee===i.BYTE&&(ae=i.RGBA8I),ee===i.SHORT&&(ae=i.RGBA16I),ee===i.INT&&(ae=i.RGBA32I)),E===i.RGB&&(ee===i.UNSIGNED_SHORT&&Fe&&(ae=Fe.RGB16_EXT),ee===i.SHORT&&Fe&&(ae=Fe.RGB16_SNORM_EXT),ee===i.UNSIGNED_INT_5_9_9_9_REV&&(ae=i.RGB9_E5),ee===i.UNSIGNED_INT_10F_11F_11F_REV&&(ae=i.R11F_G11F_B10F)),E===i.RGBA){let he=Ne?il:Rt.getTransfer(me);ee===i.FLOAT&&(ae=i.RGBA32F),ee===i.HALF_FLOAT&&(ae=i.RGBA16F),ee===i.UNSIGNED_BYTE&&(ae=he===Yt?i.SRGB8_ALPHA8:i.RGBA8),ee===i.UNSIGNED_SHORT&&Fe&&(ae=Fe.RGBA16_EXT),ee===i.SHORT&&Fe&&(ae=Fe.RGBA16_SNORM_EXT),ee===i.UNSIGNED_SHORT_4_4_4_4&&(ae=i.RGBA4),ee===i.UNSIGNED_SHORT_5_5_5_1&&(ae=i.RGB5_A1)}return(ae===i.R16F||ae===i.R32F||ae===i.RG16F||ae===i.RG32F||ae===i.RGBA16F||ae===i.RGBA32F)&&e.get("EXT_color_buffer_float"),ae}function y(F,E){let ee;return F?E===null||E===ur||E===mo?ee=i.DEPTH24_STENCIL8:E===Nt?ee=i.DEPTH32F_STENCIL8:E===pa&&(ee=i.DEPTH24_STENCIL8,nt("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):E===null||E===ur||E===mo?ee=i.DEPTH_COMPONENT24:E===Nt?ee=i.DEPTH_COMPONENT32F:E===pa&&(ee=i.DEPTH_COMPONENT16),ee}function A(F,E){return T(F)===!0||F.isFramebufferTexture&&F.minFilter!==Ut&&F.minFilter!==qt?Math.log2(Math.max(E.width,E.height))+1:F.mipmaps.length>0?F.mipmaps.length:F.isCompressedTexture&&Array.isArray(F.image)?E.mipmaps.length:1}function V(F){let E=new WeakRef(F);n.get(F).__ref=E,m.add(E),b.register(F,E,E)}function z(F){let E=n.get(F).__ref;E!==void 0&&(m.delete(E),b.unregister(E))}function D(F){Y(F.target)}function q(F){U(F.target)}function Y(F){F.removeEventListener("dispose",D),z(F),K(F),F.isVideoTexture&&u.delete(F),F.isHTMLTexture&&h.delete(F)}function U(F){F.removeEventListener("dispose",q),z(F),xe(F)}function W(){for(let F of m){let E=F.deref();E!==void 0&&(E.isRenderTarget===!0?U(E):Y(E))}m.clear(),h.clear()}function K(F){let E=n.get(F);if(E.__webglInit===void 0)return;let ee=F.source,be=d.get(ee);if(be){let me=be[E.__cacheKey];me.usedTimes--,me.usedTimes===0&&$(F),Object.keys(be).length===0&&d.delete(ee)}n.remove(F)}function $(F){let E=n.get(F);i.deleteTexture(E.__webglTexture);let ee=F.source,be=d.get(ee);delete be[E.__cacheKey],o.memory.textures--}function xe(F){let E=n.get(F);E.__depthDisposeCallback&&E.__depthDisposeCallback();let ee=F.depthTexture;if(ee&&ee.renderTarget===F&&Y(ee),F.isWebGLCubeRenderTarget)for(let me=0;me<6;me++){if(Array.isArray(E.__webglFramebuffer[me]))for(let Ne=0;Ne<E.__webglFramebuffer[me].length;Ne++)i.deleteFramebuffer(E.__webglFramebuffer[me][Ne]);else i.deleteFramebuffer(E.__webglFramebuffer[me]);E.__webglDepthbuffer&&i.deleteRenderbuffer(E.__webglDepthbuffer[me])}else{if(Array.isArray(E.__webglFramebuffer))for(let me=0;me<E.__webglFramebuffer.length;me++)i.deleteFramebuffer(E.__webglFramebuffer[me]);else i.deleteFramebuffer(E.__webglFramebuffer);if(E.__webglDepthbuffer&&i.deleteRenderbuffer(E.__webglDepthbuffer),E.__webglMultisampledFramebuffer&&i.deleteFramebuffer(E.__webglMultisampledFramebuffer),E.__webglColorRenderbuffer)for(let me=0;me<E.__webglColorRenderbuffer.length;me++)E.__webglColorRenderbuffer[me]&&i.deleteRenderbuffer(E.__webglColorRenderbuffer[me]);E.__webglDepthRenderbuffer&&i.deleteRenderbuffer(E.__webglDepthRenderbuffer)}let be=F.textures;for(let me=0,Ne=be.length;me<Ne;me++){let Fe=n.get(be[me]);Fe.__webglTexture&&(i.deleteTexture(Fe.__webglTexture),o.memory.textures--),n.remove(be[me])}n.remove(F)}let ne=0;function re(){ne=0}function de(){return ne}function ge(F){ne=F}function pe(){let F=ne;return F>=r.maxTextures&&nt("WebGLTextures: Trying to use "+(F+1)+" texture units while this GPU supports only "+r.maxTextures),ne+=1,F}function se(F){let E=[];return E.push(F.wrapS),E.push(F.wrapT),E.push(F.wrapR||0),E.push(F.magFilter),E.push(F.minFilter),E.push(F.anisotropy),E.push(F.internalFormat),E.push(F.format),E.push(F.type),E.push(F.generateMipmaps),E.push(F.mipmapsAutoUpdate),E.push(F.premultiplyAlpha),E.push(F.flipY),E.push(F.unpackAlignment),E.push(F.colorSpace),E.join()}function Ee(F,E){let ee=n.get(F);if(F.isVideoTexture&&Kt(F),F.isRenderTargetTexture===!1&&F.isExternalTexture!==!0&&F.version>0&&ee.__version!==F.version){let be=F.image;if(be===null)nt("WebGLRenderer: Texture marked for update but no image data found.");else if(be.complete===!1)nt("WebGLRenderer: Texture marked for update but image is incomplete");else{kt(ee,F,E);return}}else F.isExternalTexture&&(ee.__webglTexture=F.sourceTexture?F.sourceTexture:null);t.bindTexture(i.TEXTURE_2D,ee.__webglTexture,i.TEXTURE0+E)}function Pe(F,E){let ee=n.get(F);if(F.isRenderTargetTexture===!1&&F.version>0&&ee.__version!==F.version){kt(ee,F,E);return}else F.isExternalTexture&&(ee.__webglTexture=F.sourceTexture?F.sourceTexture:null);t.bindTexture(i.TEXTURE_2D_ARRAY,ee.__webglTexture,i.TEXTURE0+E)}function Oe(F,E){let ee=n.get(F);if(F.isRenderTargetTexture===!1&&F.version>0&&ee.__version!==F.version){kt(ee,F,E);return}t.bindTexture(i.TEXTURE_3D,ee.__webglTexture,i.TEXTURE0+E)}function ye(F,E){let ee=n.get(F);if(F.version>0&&ee.__version!==F.version){mn(ee,F,E);return}t.bindTexture(i.TEXTURE_CUBE_MAP,ee.__webglTexture,i.TEXTURE0+E)}let Ke={[Ns]:i.REPEAT,[si]:i.CLAMP_TO_EDGE,[Ko]:i.MIRRORED_REPEAT},ft={[Ut]:i.NEAREST,[au]:i.NEAREST_MIPMAP_NEAREST,[po]:i.NEAREST_MIPMAP_LINEAR,[qt]:i.LINEAR,[da]:i.LINEAR_MIPMAP_NEAREST,[Fi]:i.LINEAR_MIPMAP_LINEAR},et={[j0]:i.NEVER,[ad]:i.ALWAYS,[Q0]:i.LESS,[sd]:i.LEQUAL,[eg]:i.EQUAL,[od]:i.GEQUAL,[tg]:i.GREATER,[ng]:i.NOTEQUAL};function St(F,E){if(E.type===Nt&&e.has("OES_texture_float_linear")===!1&&(E.magFilter===qt||E.magFilter===da||E.magFilter===po||E.magFilter===Fi||E.minFilter===qt||E.minFilter===da||E.minFilter===po||E.minFilter===Fi)&&nt("WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),i.texParameteri(F,i.TEXTURE_WRAP_S,Ke[E.wrapS]),i.texParameteri(F,i.TEXTURE_WRAP_T,Ke[E.wrapT]),(F===i.TEXTURE_3D||F===i.TEXTURE_2D_ARRAY)&&i.texParameteri(F,i.TEXTURE_WRAP_R,Ke[E.wrapR]),i.texParameteri(F,i.TEXTURE_MAG_FILTER,ft[E.magFilter]),i.texParameteri(F,i.TEXTURE_MIN_FILTER,ft[E.minFilter]),E.compareFunction&&(i.texParameteri(F,i.TEXTURE_COMPARE_MODE,i.COMPARE_REF_TO_TEXTURE),i.texParameteri(F,i.TEXTURE_COMPARE_FUNC,et[E.compareFunction])),e.has("EXT_texture_filter_anisotropic")===!0){if(E.magFilter===Ut||E.minFilter!==po&&E.minFilter!==Fi||E.type===Nt&&e.has("OES_texture_float_linear")===!1)return;if(E.anisotropy>1||n.get(E).__currentAnisotropy){let ee=e.get("EXT_texture_filter_anisotropic");i.texParameterf(F,ee.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(E.anisotropy,r.getMaxAnisotropy())),n.get(E).__currentAnisotropy=E.anisotropy}}}function bt(F,E){let ee=!1;F.__webglInit===void 0&&(F.__webglInit=!0,E.addEventListener("dispose",D),V(E));let be=E.source,me=d.get(be);me===void 0&&(me={},d.set(be,me));let Ne=se(E);if(Ne!==F.__cacheKey){me[Ne]===void 0&&(me[Ne]={texture:i.createTexture(),usedTimes:0},o.memory.textures++,ee=!0),me[Ne].usedTimes++;let Fe=me[F.__cacheKey];Fe!==void 0&&(me[F.__cacheKey].usedTimes--,Fe.usedTimes===0&&$(E)),F.__cacheKey=Ne,F.__webglTexture=me[Ne].texture}return ee}function vt(F,E,ee){return Math.floor(Math.floor(F/ee)/E)}function Zt(F,E,ee,be){let Ne=F.updateRanges;if(Ne.length===0)t.texSubImage2D(i.TEXTURE_2D,0,0,0,E.width,E.height,ee,be,E.data);else{Ne.sort((H,ue)=>H.start-ue.start);let Fe=0;for(let H=1;H<Ne.length;H++){let ue=Ne[Fe],oe=Ne[H],ke=ue.start+ue.count,Le=vt(oe.start,E.width,4),Be=vt(ue.start,E.width,4);oe.start<=ke+1&&Le===Be&&vt(oe.start+oe.count-1,E.width,4)===Le?ue.count=Math.max(ue.count,oe.start+oe.count-ue.start):(++Fe,Ne[Fe]=oe)}Ne.length=Fe+1;let ae=t.getParameter(i.UNPACK_ROW_LENGTH),he=t.getParameter(i.UNPACK_SKIP_PIXELS),Re=t.getParameter(i.UNPACK_SKIP_ROWS);t.pixelStorei(i.UNPACK_ROW_LENGTH,E.width);for(let H=0,ue=Ne.length;H<ue;H++){let oe=Ne[H],ke=Math.floor(oe.start/4),Le=Math.ceil(oe.count/4),Be=ke%E.width,tt=Math.floor(ke/E.width),pt=Le,we=1;t.pixelStorei(i.UNPACK_SKIP_PIXELS,Be),t.pixelStorei(i.UNPACK_SKIP_ROWS,tt),t.texSubImage2D(i.TEXTURE_2D,0,Be,tt,pt,we,ee,be,E.data)}F.clearUpdateRanges(),t.pixelStorei(i.UNPACK_ROW_LENGTH,ae),t.pixelStorei(i.UNPACK_SKIP_PIXELS,he),t.pixelStorei(i.UNPACK_SKIP_ROWS,Re)}}function kt(F,E,ee){let be=i.TEXTURE_2D;(E.isDataArrayTexture||E.isCompressedArrayTexture)&&(be=i.TEXTURE_2D_ARRAY),E.isData3DTexture&&(be=i.TEXTURE_3D);let me=bt(F,E),Ne=E.source;t.bindTexture(be,F.__webglTexture,i.TEXTURE0+ee);let Fe=n.get(Ne);if(Ne.version!==Fe.__version||me===!0){if(t.activeTexture(i.TEXTURE0+ee),(typeof ImageBitmap<"u"&&E.image instanceof ImageBitmap)===!1){let we=Rt.getPrimaries(Rt.workingColorSpace),Je=E.colorSpace===cs?null:Rt.getPrimaries(E.colorSpace),mt=E.colorSpace===cs||we===Je?i.NONE:i.BROWSER_DEFAULT_WEBGL;t.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,E.flipY),t.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,E.premultiplyAlpha),t.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,mt)}t.pixelStorei(i.UNPACK_ALIGNMENT,E.unpackAlignment);let he=S(E.image,!1,r.maxTextureSize);he=je(E,he);let Re=s.convert(E.format,E.colorSpace),H=s.convert(E.type),ue=R(E.internalFormat,Re,H,E.normalized,E.colorSpace,E.isVideoTexture);St(be,E);let oe,ke=E.mipmaps,Le=E.isVideoTexture!==!0,Be=Fe.__version===void 0||me===!0,tt=Ne.dataReady,pt=A(E,he);if(E.isDepthTexture)ue=y(E.format===as,E.type),Be&&(Le?t.texStorage2D(i.TEXTURE_2D,1,ue,he.width,he.height):t.texImage2D(i.TEXTURE_2D,0,ue,he.width,he.height,0,Re,H,null));else if(E.isDataTexture)if(ke.length>0){Le&&Be&&t.texStorage2D(i.TEXTURE_2D,pt,ue,ke[0].width,ke[0].height);for(let we=0,Je=ke.length;we<Je;we++)oe=ke[we],Le?tt&&t.texSubImage2D(i.TEXTURE_2D,we,0,0,oe.width,oe.height,Re,H,oe.data):t.texImage2D(i.TEXTURE_2D,we,ue,oe.width,oe.height,0,Re,H,oe.data);E.generateMipmaps=!1}else Le?(Be&&t.texStorage2D(i.TEXTURE_2D,pt,ue,he.width,he.height),tt&&Zt(E,he,Re,H)):t.texImage2D(i.TEXTURE_2D,0,ue,he.width,he.height,0,Re,H,he.data);else if(E.isCompressedTexture)if(E.isCompressedArrayTexture){Le&&Be&&t.texStorage3D(i.TEXTURE_2D_ARRAY,pt,ue,ke[0].width,ke[0].height,he.depth);for(let we=0,Je=ke.length;we<Je;we++)if(oe=ke[we],E.format!==jt)if(Re!==null)if(Le){if(tt)if(E.layerUpdates.size>0){let mt=gd(oe.width,oe.height,E.format,E.type);for(let Ge of E.layerUpdates){let Mt=oe.data.subarray(Ge*mt/oe.data.BYTES_PER_ELEMENT,(Ge+1)*mt/oe.data.BYTES_PER_ELEMENT);t.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,we,0,0,Ge,oe.width,oe.height,1,Re,Mt)}}else t.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,we,0,0,0,oe.width,oe.height,he.depth,Re,oe.data)}else t.compressedTexImage3D(i.TEXTURE_2D_ARRAY,we,ue,oe.width,oe.height,he.depth,0,oe.data,0,0);else nt("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else Le?tt&&t.texSubImage3D(i.TEXTURE_2D_ARRAY,we,0,0,0,oe.width,oe.height,he.depth,Re,H,oe.data):t.texImage3D(i.TEXTURE_2D_ARRAY,we,ue,oe.width,oe.height,he.depth,0,Re,H,oe.data);E.layerUpdates.size>0&&E.clearLayerUpdates()}else{Le&&Be&&t.texStorage2D(i.TEXTURE_2D,pt,ue,ke[0].width,ke[0].height);for(let we=0,Je=ke.length;we<Je;we++)oe=ke[we],E.format!==jt?Re!==null?Le?tt&&t.compressedTexSubImage2D(i.TEXTURE_2D,we,0,0,oe.width,oe.height,Re,oe.data):t.compressedTexImage2D(i.TEXTURE_2D,we,ue,oe.width,oe.height,0,oe.data):nt("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):Le?tt&&t.texSubImage2D(i.TEXTURE_2D,we,0,0,oe.width,oe.height,Re,H,oe.data):t.texImage2D(i.TEXTURE_2D,we,ue,oe.width,oe.height,0,Re,H,oe.data)}else if(E.isDataArrayTexture)if(Le){if(Be&&t.texStorage3D(i.TEXTURE_2D_ARRAY,pt,ue,he.width,he.height,he.depth),tt)if(E.layerUpdates.size>0){let we=gd(he.width,he.height,E.format,E.type);for(let Je of E.layerUpdates){let mt=he.data.subarray(Je*we/he.data.BYTES_PER_ELEMENT,(Je+1)*we/he.data.BYTES_PER_ELEMENT);t.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,Je,he.width,he.height,1,Re,H,mt)}E.clearLayerUpdates()}else t.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,0,he.width,he.height,he.depth,Re,H,he.data)}else t.texImage3D(i.TEXTURE_2D_ARRAY,0,ue,he.width,he.height,he.depth,0,Re,H,he.data);else if(E.isData3DTexture)Le?(Be&&t.texStorage3D(i.TEXTURE_3D,pt,ue,he.width,he.height,he.depth),tt&&t.texSubImage3D(i.TEXTURE_3D,0,0,0,0,he.width,he.height,he.depth,Re,H,he.data)):t.texImage3D(i.TEXTURE_3D,0,ue,he.width,he.height,he.depth,0,Re,H,he.data);else if(E.isFramebufferTexture){if(Be)if(Le)t.texStorage2D(i.TEXTURE_2D,pt,ue,he.width,he.height);else{let we=he.width,Je=he.height;for(let mt=0;mt<pt;mt++)t.texImage2D(i.TEXTURE_2D,mt,ue,we,Je,0,Re,H,null),we>>=1,Je>>=1}}else if(E.isHTMLTexture){if("texElementImage2D"in i){let we=i.canvas;if(we.hasAttribute("layoutsubtree")||we.setAttribute("layoutsubtree","true"),he.parentNode!==we){we.appendChild(he),h.add(E),we.onpaint=Je=>{let mt=Je.changedElements;for(let Ge of h)mt.includes(Ge.image)&&(Ge.needsUpdate=!0)},we.requestPaint();return}if(i.texElementImage2D.length===3)i.texElementImage2D(i.TEXTURE_2D,i.RGBA8,he);else{let mt=i.RGBA,Ge=i.RGBA,Mt=i.UNSIGNED_BYTE;i.texElementImage2D(i.TEXTURE_2D,0,mt,Ge,Mt,he)}i.texParameteri(i.TEXTURE_2D,i.TEXTURE_MIN_FILTER,i.LINEAR),i.texParameteri(i.TEXTURE_2D,i.TEXTURE_WRAP_S,i.CLAMP_TO_EDGE),i.texParameteri(i.TEXTURE_2D,i.TEXTURE_WRAP_T,i.CLAMP_TO_EDGE)}}else if(ke.length>0){if(Le&&Be){let we=lt(ke[0]);t.texStorage2D(i.TEXTURE_2D,pt,ue,we.width,we.height)}for(let we=0,Je=ke.length;we<Je;we++)oe=ke[we],Le?tt&&t.texSubImage2D(i.TEXTURE_2D,we,0,0,Re,H,oe):t.texImage2D(i.TEXTURE_2D,we,ue,Re,H,oe);E.generateMipmaps=!1}else if(Le){if(Be){let we=lt(he);t.texStorage2D(i.TEXTURE_2D,pt,ue,we.width,we.height)}tt&&t.texSubImage2D(i.TEXTURE_2D,0,0,0,Re,H,he)}else t.texImage2D(i.TEXTURE_2D,0,ue,Re,H,he);T(E)&&E.mipmapsAutoUpdate===!0&&M(be),Fe.__version=Ne.version,E.onUpdate&&E.onUpdate(E)}F.__version=E.version}function mn(F,E,ee){if(E.image.length!==6)return;let be=bt(F,E),me=E.source;t.bindTexture(i.TEXTURE_CUBE_MAP,F.__webglTexture,i.TEXTURE0+ee);let Ne=n.get(me);if(me.version!==Ne.__version||be===!0){t.activeTexture(i.TEXTURE0+ee);let Fe=Rt.getPrimaries(Rt.workingColorSpace),ae=E.colorSpace===cs?null:Rt.getPrimaries(E.colorSpace),he=E.colorSpace===cs||Fe===ae?i.NONE:i.BROWSER_DEFAULT_WEBGL;t.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,E.flipY),t.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,E.premultiplyAlpha),t.pixelStorei(i.UNPACK_ALIGNMENT,E.unpackAlignment),t.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,he);let Re=E.isCompressedTexture||E.image[0].isCompressedTexture,H=E.image[0]&&E.image[0].isDataTexture,ue=[];for(let Ge=0;Ge<6;Ge++)!Re&&!H?ue[Ge]=S(E.image[Ge],!0,r.maxCubemapSize):ue[Ge]=H?E.image[Ge].image:E.image[Ge],ue[Ge]=je(E,ue[Ge]);let oe=ue[0],ke=s.convert(E.format,E.colorSpace),Le=s.convert(E.type),Be=R(E.internalFormat,ke,Le,E.normalized,E.colorSpace),tt=E.isVideoTexture!==!0,pt=Ne.__version===void 0||be===!0,we=me.dataReady,Je=A(E,oe);St(i.TEXTURE_CUBE_MAP,E);let mt;if(E.isDepthTexture){if(Be=y(E.format===as,E.type),pt)if(tt)t.texStorage2D(i.TEXTURE_CUBE_MAP,1,Be,oe.width,oe.height);else for(let Ge=0;Ge<6;Ge++)t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ge,0,Be,oe.width,oe.height,0,ke,Le,null)}else if(Re){tt&&pt&&t.texStorage2D(i.TEXTURE_CUBE_MAP,Je,Be,oe.width,oe.height);for(let Ge=0;Ge<6;Ge++){mt=ue[Ge].mipmaps;for(let Mt=0;Mt<mt.length;Mt++){let nn=mt[Mt];E.format!==jt?ke!==null?tt?we&&t.compressedTexSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ge,Mt,0,0,nn.width,nn.height,ke,nn.data):t.compressedTexImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ge,Mt,Be,nn.width,nn.height,0,nn.data):nt("WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):tt?we&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ge,Mt,0,0,nn.width,nn.height,ke,Le,nn.data):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ge,Mt,Be,nn.width,nn.height,0,ke,Le,nn.data)}}}else{if(mt=E.mipmaps,tt&&pt){mt.length>0&&Je++;let Ge=lt(ue[0]);t.texStorage2D(i.TEXTURE_CUBE_MAP,Je,Be,Ge.width,Ge.height)}for(let Ge=0;Ge<6;Ge++)if(H){tt?we&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ge,0,0,0,ue[Ge].width,ue[Ge].height,ke,Le,ue[Ge].data):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ge,0,Be,ue[Ge].width,ue[Ge].height,0,ke,Le,ue[Ge].data);for(let Mt=0;Mt<mt.length;Mt++){let jn=mt[Mt].image[Ge].image;tt?we&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ge,Mt+1,0,0,jn.width,jn.height,ke,Le,jn.data):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ge,Mt+1,Be,jn.width,jn.height,0,ke,Le,jn.data)}}else{tt?we&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ge,0,0,0,ke,Le,ue[Ge]):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ge,0,Be,ke,Le,ue[Ge]);for(let Mt=0;Mt<mt.length;Mt++){let nn=mt[Mt];tt?we&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ge,Mt+1,0,0,ke,Le,nn.image[Ge]):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Ge,Mt+1,Be,ke,Le,nn.image[Ge])}}}T(E)&&E.mipmapsAutoUpdate===!0&&M(i.TEXTURE_CUBE_MAP),Ne.__version=me.version,E.onUpdate&&E.onUpdate(E)}F.__version=E.version}function Xt(F,E,ee,be,me,Ne){let Fe=s.convert(ee.format,ee.colorSpace),ae=s.convert(ee.type),he=R(ee.internalFormat,Fe,ae,ee.normalized,ee.colorSpace),Re=n.get(E),H=n.get(ee);if(H.__renderTarget=E,!Re.__hasExternalTextures){let ue=Math.max(1,E.width>>Ne),oe=Math.max(1,E.height>>Ne);me===i.TEXTURE_3D||me===i.TEXTURE_2D_ARRAY?t.texImage3D(me,Ne,he,ue,oe,E.depth,0,Fe,ae,null):t.texImage2D(me,Ne,he,ue,oe,0,Fe,ae,null)}t.bindFramebuffer(i.FRAMEBUFFER,F),De(E)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,be,me,H.__webglTexture,0,yt(E)):(me===i.TEXTURE_2D||me>=i.TEXTURE_CUBE_MAP_POSITIVE_X&&me<=i.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&i.framebufferTexture2D(i.FRAMEBUFFER,be,me,H.__webglTexture,Ne),t.bindFramebuffer(i.FRAMEBUFFER,null)}function Dn(F,E,ee){if(i.bindRenderbuffer(i.RENDERBUFFER,F),E.depthBuffer){let be=E.depthTexture,me=be&&be.isDepthTexture?be.type:null,Ne=y(E.stencilBuffer,me),Fe=E.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;De(E)?a.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,yt(E),Ne,E.width,E.height):ee?i.renderbufferStorageMultisample(i.RENDERBUFFER,yt(E),Ne,E.width,E.height):i.renderbufferStorage(i.RENDERBUFFER,Ne,E.width,E.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,Fe,i.RENDERBUFFER,F)}else{let be=E.textures;for(let me=0;me<be.length;me++){let Ne=be[me],Fe=s.convert(Ne.format,Ne.colorSpace),ae=s.convert(Ne.type),he=R(Ne.internalFormat,Fe,ae,Ne.normalized,Ne.colorSpace);De(E)?a.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,yt(E),he,E.width,E.height):ee?i.renderbufferStorageMultisample(i.RENDERBUFFER,yt(E),he,E.width,E.height):i.renderbufferStorage(i.RENDERBUFFER,he,E.width,E.height)}}i.bindRenderbuffer(i.RENDERBUFFER,null)}function Pt(F,E,ee){let be=E.isWebGLCubeRenderTarget===!0;if(t.bindFramebuffer(i.FRAMEBUFFER,F),!(E.depthTexture&&E.depthTexture.isDepthTexture))throw new Error("THREE.WebGLTextures: renderTarget.depthTexture must be an instance of THREE.DepthTexture.");let me=n.get(E.depthTexture);me.__renderTarget=E;let Ne=be?E.depthTexture.image[0]:E.depthTexture.image;(!me.__webglTexture||Ne.width!==E.width||Ne.height!==E.height)&&(Ne.width=E.width,Ne.height=E.height,E.depthTexture.needsUpdate=!0),be?ye(E.depthTexture,0):Ee(E.depthTexture,0);let Fe=me.__webglTexture,ae=yt(E),he=be?i.TEXTURE_CUBE_MAP_POSITIVE_X+ee:i.TEXTURE_2D,Re=E.depthTexture.format===as?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;if(E.depthTexture.format===jr)De(E)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,Re,he,Fe,0,ae):i.framebufferTexture2D(i.FRAMEBUFFER,Re,he,Fe,0);else if(E.depthTexture.format===as)De(E)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,Re,he,Fe,0,ae):i.framebufferTexture2D(i.FRAMEBUFFER,Re,he,Fe,0);else throw new Error("THREE.WebGLTextures: Unknown depthTexture format.")}function Tn(F){let E=n.get(F),ee=F.isWebGLCubeRenderTarget===!0;if(E.__boundDepthTexture!==F.depthTexture){let be=F.depthTexture;if(E.__depthDisposeCallback&&E.__depthDisposeCallback(),be){let me=()=>{delete E.__boundDepthTexture,delete E.__depthDisposeCallback,be.removeEventListener("dispose",me)};be.addEventListener("dispose",me),E.__depthDisposeCallback=me}E.__boundDepthTexture=be}if(F.depthTexture&&!E.__autoAllocateDepthBuffer)if(ee)for(let be=0;be<6;be++)Pt(E.__webglFramebuffer[be],F,be);else F.texture.mipmaps.length>0?Pt(E.__webglFramebuffer[0],F,0):Pt(E.__webglFramebuffer,F,0);else if(ee){E.__webglDepthbuffer=[];for(let be=0;be<6;be++)if(t.bindFramebuffer(i.FRAMEBUFFER,E.__webglFramebuffer[be]),E.__webglDepthbuffer[be]===void 0)E.__webglDepthbuffer[be]=i.createRenderbuffer(),Dn(E.__webglDepthbuffer[be],F,!1);else{let me=F.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,Ne=E.__webglDepthbuffer[be];i.bindRenderbuffer(i.RENDERBUFFER,Ne),i.framebufferRenderbuffer(i.FRAMEBUFFER,me,i.RENDERBUFFER,Ne)}}else if(F.texture.mipmaps.length>0?t.bindFramebuffer(i.FRAMEBUFFER,E.__webglFramebuffer[0]):t.bindFramebuffer(i.FRAMEBUFFER,E.__webglFramebuffer),E.__webglDepthbuffer===void 0)E.__webglDepthbuffer=i.createRenderbuffer(),Dn(E.__webglDepthbuffer,F,!1);else{let me=F.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,Ne=E.__webglDepthbuffer;i.bindRenderbuffer(i.RENDERBUFFER,Ne),i.framebufferRenderbuffer(i.FRAMEBUFFER,me,i.RENDERBUFFER,Ne)}t.bindFramebuffer(i.FRAMEBUFFER,null)}function ln(F,E,ee){let be=n.get(F);E!==void 0&&Xt(be.__webglFramebuffer,F,F.texture,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,0),ee!==void 0&&Tn(F)}function An(F){let E=F.texture,ee=n.get(F),be=n.get(E);F.addEventListener("dispose",q),V(F);let me=F.textures,Ne=F.isWebGLCubeRenderTarget===!0,Fe=me.length>1;if(Fe||(be.__webglTexture===void 0&&(be.__webglTexture=i.createTexture()),be.__version=E.version,o.memory.textures++),Ne){ee.__webglFramebuffer=[];for(let ae=0;ae<6;ae++)if(E.mipmaps.length>0){ee.__webglFramebuffer[ae]=[];for(let he=0;he<E.mipmaps.length;he++)ee.__webglFramebuffer[ae][he]=i.createFramebuffer()}else ee.__webglFramebuffer[ae]=i.createFramebuffer()}else{if(E.mipmaps.length>0){ee.__webglFramebuffer=[];for(let ae=0;ae<E.mipmaps.length;ae++)ee.__webglFramebuffer[ae]=i.createFramebuffer()}else ee.__webglFramebuffer=i.createFramebuffer();if(Fe)for(let ae=0,he=me.length;ae<he;ae++){let Re=n.get(me[ae]);Re.__webglTexture===void 0&&(Re.__webglTexture=i.createTexture(),o.memory.textures++)}if(F.samples>0&&De(F)===!1){ee.__webglMultisampledFramebuffer=i.createFramebuffer(),ee.__webglColorRenderbuffer=[],t.bindFramebuffer(i.FRAMEBUFFER,ee.__webglMultisampledFramebuffer);for(let ae=0;ae<me.length;ae++){let he=me[ae];ee.__webglColorRenderbuffer[ae]=i.createRenderbuffer(),i.bindRenderbuffer(i.RENDERBUFFER,ee.__webglColorRenderbuffer[ae]);let Re=s.convert(he.format,he.colorSpace),H=s.convert(he.type),ue=R(he.internalFormat,Re,H,he.normalized,he.colorSpace,F.isXRRenderTarget===!0),oe=yt(F);i.renderbufferStorageMultisample(i.RENDERBUFFER,oe,ue,F.width,F.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+ae,i.RENDERBUFFER,ee.__webglColorRenderbuffer[ae])}i.bindRenderbuffer(i.RENDERBUFFER,null),F.depthBuffer&&(ee.__webglDepthRenderbuffer=i.createRenderbuffer(),Dn(ee.__webglDepthRenderbuffer,F,!0)),t.bindFramebuffer(i.FRAMEBUFFER,null)}}if(Ne){t.bindTexture(i.TEXTURE_CUBE_MAP,be.__webglTexture),St(i.TEXTURE_CUBE_MAP,E);for(let ae=0;ae<6;ae++)if(E.mipmaps.length>0)for(let he=0;he<E.mipmaps.length;he++)Xt(ee.__webglFramebuffer[ae][he],F,E,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+ae,he);else Xt(ee.__webglFramebuffer[ae],F,E,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+ae,0);T(E)?M(i.TEXTURE_CUBE_MAP):E.mipmaps.length>0&&i.texParameteri(i.TEXTURE_CUBE_MAP,i.TEXTURE_MAX_LEVEL,E.mipmaps.length-1),t.unbindTexture()}else if(Fe){for(let ae=0,he=me.length;ae<he;ae++){let Re=me[ae],H=n.get(Re),ue=i.TEXTURE_2D;(F.isWebGL3DRenderTarget||F.isWebGLArrayRenderTarget)&&(ue=F.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),t.bindTexture(ue,H.__webglTexture),St(ue,Re),Xt(ee.__webglFramebuffer,F,Re,i.COLOR_ATTACHMENT0+ae,ue,0),T(Re)&&M(ue)}t.unbindTexture()}else{let ae=i.TEXTURE_2D;if((F.isWebGL3DRenderTarget||F.isWebGLArrayRenderTarget)&&(ae=F.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),t.bindTexture(ae,be.__webglTexture),St(ae,E),E.mipmaps.length>0)for(let he=0;he<E.mipmaps.length;he++)Xt(ee.__webglFramebuffer[he],F,E,i.COLOR_ATTACHMENT0,ae,he);else Xt(ee.__webglFramebuffer,F,E,i.COLOR_ATTACHMENT0,ae,0);T(E)?M(ae):E.mipmaps.length>0&&i.texParameteri(ae,i.TEXTURE_MAX_LEVEL,E.mipmaps.length-1),t.unbindTexture()}F.depthBuffer&&Tn(F)}function G(F){let E=F.textures;for(let ee=0,be=E.length;ee<be;ee++){let me=E[ee];if(T(me)&&me.mipmapsAutoUpdate===!0){let Ne=P(F),Fe=n.get(me).__webglTexture;t.bindTexture(Ne,Fe),M(Ne),t.unbindTexture()}}}let He=[];function ct(F){if(F.samples>0){if(De(F)===!1){let E=F.textures,ee=F.width,be=F.height,me=i.COLOR_BUFFER_BIT,Ne=F.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,Fe=n.get(F),ae=E.length>1;if(ae)for(let Re=0;Re<E.length;Re++)t.bindFramebuffer(i.FRAMEBUFFER,Fe.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+Re,i.RENDERBUFFER,null),t.bindFramebuffer(i.FRAMEBUFFER,Fe.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+Re,i.TEXTURE_2D,null,0);t.bindFramebuffer(i.READ_FRAMEBUFFER,Fe.__webglMultisampledFramebuffer),F.texture.mipmaps.length>0?t.bindFramebuffer(i.DRAW_FRAMEBUFFER,Fe.__webglFramebuffer[0]):t.bindFramebuffer(i.DRAW_FRAMEBUFFER,Fe.__webglFramebuffer);for(let Re=0;Re<E.length;Re++){if(F.resolveDepthBuffer&&(F.depthBuffer&&(me|=i.DEPTH_BUFFER_BIT),F.stencilBuffer&&F.resolveStencilBuffer&&(me|=i.STENCIL_BUFFER_BIT)),ae){i.framebufferRenderbuffer(i.READ_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.RENDERBUFFER,Fe.__webglColorRenderbuffer[Re]);let H=n.get(E[Re]).__webglTexture;i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,H,0)}i.blitFramebuffer(0,0,ee,be,0,0,ee,be,me,i.NEAREST),l===!0&&(He.length=0,He.push(i.COLOR_ATTACHMENT0+Re),F.depthBuffer&&F.storeMultisampledDepthBuffer===!1&&He.push(Ne),i.invalidateFramebuffer(i.READ_FRAMEBUFFER,He))}if(t.bindFramebuffer(i.READ_FRAMEBUFFER,null),t.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),ae)for(let Re=0;Re<E.length;Re++){t.bindFramebuffer(i.FRAMEBUFFER,Fe.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+Re,i.RENDERBUFFER,Fe.__webglColorRenderbuffer[Re]);let H=n.get(E[Re]).__webglTexture;t.bindFramebuffer(i.FRAMEBUFFER,Fe.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+Re,i.TEXTURE_2D,H,0)}t.bindFramebuffer(i.DRAW_FRAMEBUFFER,Fe.__webglMultisampledFramebuffer)}else if(F.depthBuffer&&F.storeMultisampledDepthBuffer===!1&&l){let E=F.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;i.invalidateFramebuffer(i.DRAW_FRAMEBUFFER,[E])}}}function yt(F){return Math.min(r.maxSamples,F.samples)}function De(F){let E=n.get(F);return F.samples>0&&e.has("WEBGL_multisampled_render_to_texture")===!0&&E.__useRenderToTexture!==!1}function Kt(F){let E=o.render.frame;u.get(F)!==E&&(u.set(F,E),F.update())}function je(F,E){let ee=F.colorSpace,be=F.format,me=F.type;return F.isCompressedTexture===!0||F.isVideoTexture===!0||ee!==dn&&ee!==cs&&(Rt.getTransfer(ee)===Yt?(be!==jt||me!==bi)&&nt("WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):_t("WebGLTextures: Unsupported texture color space:",ee)),E}function lt(F){return typeof HTMLImageElement<"u"&&F instanceof HTMLImageElement?(c.width=F.naturalWidth||F.width,c.height=F.naturalHeight||F.height):typeof VideoFrame<"u"&&F instanceof VideoFrame?(c.width=F.displayWidth,c.height=F.displayHeight):(c.width=F.width,c.height=F.height),c}this.allocateTextureUnit=pe,this.resetTextureUnits=re,this.getTextureUnits=de,this.setTextureUnits=ge,this.setTexture2D=Ee,this.setTexture2DArray=Pe,this.setTexture3D=Oe,this.setTextureCube=ye,this.rebindTextures=ln,this.setupRenderTarget=An,this.updateRenderTargetMipmap=G,this.updateMultisampleRenderTarget=ct,this.setupDepthRenderbuffer=Tn,this.setupFrameBufferTexture=Xt,this.useMultisampledRTT=De,this.dispose=W}function u2(i,e){function t(n,r=cs){let s,o=Rt.getTransfer(r);if(n===bi)return i.UNSIGNED_BYTE;if(n===cu)return i.UNSIGNED_SHORT_4_4_4_4;if(n===uu)return i.UNSIGNED_SHORT_5_5_5_1;if(n===ed)return i.UNSIGNED_INT_5_9_9_9_REV;if(n===td)return i.UNSIGNED_INT_10F_11F_11F_REV;if(n===jf)return i.BYTE;if(n===Qf)return i.SHORT;if(n===pa)return i.UNSIGNED_SHORT;if(n===lu)return i.INT;if(n===ur)return i.UNSIGNED_INT;if(n===Nt)return i.FLOAT;if(n===tn)return i.HALF_FLOAT;if(n===nd)return i.ALPHA;if(n===id)return i.RGB;if(n===jt)return i.RGBA;if(n===jr)return i.DEPTH_COMPONENT;if(n===as)return i.DEPTH_STENCIL;if(n===ls)return i.RED;if(n===hu)return i.RED_INTEGER;if(n===ai)return i.RG;if(n===fu)return i.RG_INTEGER;if(n===du)return i.RGBA_INTEGER;if(n===Al||n===El||n===Rl||n===Cl)if(o===Yt)if(s=e.get("WEBGL_compressed_texture_s3tc_srgb"),s!==null){if(n===Al)return s.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(n===El)return s.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(n===Rl)return s.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(n===Cl)return s.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(s=e.get("WEBGL_compressed_texture_s3tc"),s!==null){if(n===Al)return s.COMPRESSED_RGB_S3TC_DXT1_EXT;if(n===El)return s.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(n===Rl)return s.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(n===Cl)return s.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(n===pu||n===mu||n===gu||n===_u)if(s=e.get("WEBGL_compressed_texture_pvrtc"),s!==null){if(n===pu)return s.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(n===mu)return s.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(n===gu)return s.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(n===_u)return s.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(n===xu||n===vu||n===yu||n===bu||n===wu||n===Il||n===Su)if(s=e.get("WEBGL_compressed_texture_etc"),s!==null){if(n===xu||n===vu)return o===Yt?s.COMPRESSED_SRGB8_ETC2:s.COMPRESSED_RGB8_ETC2;if(n===yu)return o===Yt?s.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:s.COMPRESSED_RGBA8_ETC2_EAC;if(n===bu)return s.COMPRESSED_R11_EAC;if(n===wu)return s.COMPRESSED_SIGNED_R11_EAC;if(n===Il)return s.COMPRESSED_RG11_EAC;if(n===Su)return s.COMPRESSED_SIGNED_RG11_EAC}else return null;if(n===Mu||n===Tu||n===Au||n===Eu||n===Ru||n===Cu||n===Iu||n===Pu||n===Lu||n===Nu||n===Du||n===Fu||n===Uu||n===Ou)if(s=e.get("WEBGL_compressed_texture_astc"),s!==null){if(n===Mu)return o===Yt?s.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:s.COMPRESSED_RGBA_ASTC_4x4_KHR;if(n===Tu)return o===Yt?s.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:s.COMPRESSED_RGBA_ASTC_5x4_KHR;if(n===Au)return o===Yt?s.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:s.COMPRESSED_RGBA_ASTC_5x5_KHR;if(n===Eu)return o===Yt?s.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:s.COMPRESSED_RGBA_ASTC_6x5_KHR;if(n===Ru)return o===Yt?s.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:s.COMPRESSED_RGBA_ASTC_6x6_KHR;if(n===Cu)return o===Yt?s.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:s.COMPRESSED_RGBA_ASTC_8x5_KHR;if(n===Iu)return o===Yt?s.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:s.COMPRESSED_RGBA_ASTC_8x6_KHR;if(n===Pu)return o===Yt?s.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:s.COMPRESSED_RGBA_ASTC_8x8_KHR;if(n===Lu)return o===Yt?s.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:s.COMPRESSED_RGBA_ASTC_10x5_KHR;if(n===Nu)return o===Yt?s.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:s.COMPRESSED_RGBA_ASTC_10x6_KHR;if(n===Du)return o===Yt?s.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:s.COMPRESSED_RGBA_ASTC_10x8_KHR;if(n===Fu)return o===Yt?s.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:s.COMPRESSED_RGBA_ASTC_10x10_KHR;if(n===Uu)return o===Yt?s.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:s.COMPRESSED_RGBA_ASTC_12x10_KHR;if(n===Ou)return o===Yt?s.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:s.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(n===Bu||n===zu||n===ku)if(s=e.get("EXT_texture_compression_bptc"),s!==null){if(n===Bu)return o===Yt?s.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:s.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(n===zu)return s.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(n===ku)return s.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(n===Vu||n===Hu||n===Pl||n===Gu)if(s=e.get("EXT_texture_compression_rgtc"),s!==null){if(n===Vu)return s.COMPRESSED_RED_RGTC1_EXT;if(n===Hu)return s.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(n===Pl)return s.COMPRESSED_RED_GREEN_RGTC2_EXT;if(n===Gu)return s.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return n===mo?i.UNSIGNED_INT_24_8:i[n]!==void 0?i[n]:null}return{convert:t}}var h2=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,f2=`
uniform sampler2DArray depthColor;
uniform float depthWidth;
uniform float depthHeight;

void main() {

	vec2 coord = vec2( gl_FragCoord.x / depthWidth, gl_FragCoord.y / depthHeight );

	if ( coord.x >= 1.0 ) {

		gl_FragDepth = texture( depthColor, vec3( coord.x - 1.0, coord.y, 1 ) ).r;

	} else {

		gl_FragDepth = texture( depthColor, vec3( coord.x, coord.y, 0 ) ).r;

	}

}`,Td=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(e,t){if(this.texture===null){let n=new ml(e.texture);(e.depthNear!==t.depthNear||e.depthFar!==t.depthFar)&&(this.depthNear=e.depthNear,this.depthFar=e.depthFar),this.texture=n}}getMesh(e){if(this.texture!==null&&this.mesh===null){let t=e.cameras[0].viewport,n=new Cr({vertexShader:h2,fragmentShader:f2,uniforms:{depthColor:{value:this.texture},depthWidth:{value:t.z},depthHeight:{value:t.w}}});this.mesh=new In(new gl(20,20),n)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},Ad=class extends Tr{constructor(e,t){super();let n=this,r=null,s=1,o=null,a="local-floor",l=1,c=null,u=null,h=null,f=null,d=null,m=null,b=typeof XRWebGLBinding<"u",g=new Td,_={},S=t.getContextAttributes(),T=null,M=null,P=[],R=[],y=new xt,A=null,V=null,z=new ei;z.viewport=new Ot;let D=new ei;D.viewport=new Ot;let q=[z,D],Y=new iu,U=null,W=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(se){let Ee=P[se];return Ee===void 0&&(Ee=new ta,P[se]=Ee),Ee.getTargetRaySpace()},this.getControllerGrip=function(se){let Ee=P[se];return Ee===void 0&&(Ee=new ta,P[se]=Ee),Ee.getGripSpace()},this.getHand=function(se){let Ee=P[se];return Ee===void 0&&(Ee=new ta,P[se]=Ee),Ee.getHandSpace()};function K(se){let Ee=R.indexOf(se.inputSource);if(Ee===-1)return;let Pe=P[Ee];Pe!==void 0&&(Pe.update(se.inputSource,se.frame,c||o),Pe.dispatchEvent({type:se.type,data:se.inputSource}))}function $(){r.removeEventListener("select",K),r.removeEventListener("selectstart",K),r.removeEventListener("selectend",K),r.removeEventListener("squeeze",K),r.removeEventListener("squeezestart",K),r.removeEventListener("squeezeend",K),r.removeEventListener("end",$),r.removeEventListener("inputsourceschange",xe);for(let se=0;se<P.length;se++){let Ee=R[se];Ee!==null&&(R[se]=null,P[se].disconnect(Ee))}U=null,W=null,g.reset();for(let se in _)delete _[se];if(e.setRenderTarget(T),d=null,f=null,h=null,r=null,M=null,pe.stop(),n.isPresenting=!1,e.setPixelRatio(A),e.setSize(y.width,y.height,!1),V!==null){let se=V.camera;se.fov=V.fov,se.zoom=V.zoom,se.updateProjectionMatrix(),V=null}n.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(se){s=se,n.isPresenting===!0&&nt("WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(se){a=se,n.isPresenting===!0&&nt("WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return c||o},this.setReferenceSpace=function(se){c=se},this.getBaseLayer=function(){return f!==null?f:d},this.getBinding=function(){return h===null&&b&&(h=new XRWebGLBinding(r,t)),h},this.getFrame=function(){return m},this.getSession=function(){return r},this.setSession=async function(se){if(r=se,r!==null){if(T=e.getRenderTarget(),r.addEventListener("select",K),r.addEventListener("selectstart",K),r.addEventListener("selectend",K),r.addEventListener("squeeze",K),r.addEventListener("squeezestart",K),r.addEventListener("squeezeend",K),r.addEventListener("end",$),r.addEventListener("inputsourceschange",xe),S.xrCompatible!==!0&&await t.makeXRCompatible(),A=e.getPixelRatio(),e.getSize(y),b&&"createProjectionLayer"in XRWebGLBinding.prototype){let Pe=null,Oe=null,ye=null;S.depth&&(ye=S.stencil?t.DEPTH24_STENCIL8:t.DEPTH_COMPONENT24,Pe=S.stencil?as:jr,Oe=S.stencil?mo:ur);let Ke={colorFormat:t.RGBA8,depthFormat:ye,scaleFactor:s};h=this.getBinding(),f=h.createProjectionLayer(Ke),r.updateRenderState({layers:[f]}),e.setPixelRatio(1),e.setSize(f.textureWidth,f.textureHeight,!1),M=new Zn(f.textureWidth,f.textureHeight,{format:jt,type:bi,depthTexture:new cr(f.textureWidth,f.textureHeight,Oe,void 0,void 0,void 0,void 0,void 0,void 0,Pe),stencilBuffer:S.stencil,colorSpace:e.outputColorSpace,samples:S.antialias?4:0,resolveDepthBuffer:f.ignoreDepthValues===!1,resolveStencilBuffer:f.ignoreDepthValues===!1,storeMultisampledDepthBuffer:f.ignoreDepthValues===!1,storeMultisampledStencilBuffer:f.ignoreDepthValues===!1})}else{let Pe={antialias:S.antialias,alpha:!0,depth:S.depth,stencil:S.stencil,framebufferScaleFactor:s};d=new XRWebGLLayer(r,t,Pe),r.updateRenderState({baseLayer:d}),e.setPixelRatio(1),e.setSize(d.framebufferWidth,d.framebufferHeight,!1),M=new Zn(d.framebufferWidth,d.framebufferHeight,{format:jt,type:bi,colorSpace:e.outputColorSpace,stencilBuffer:S.stencil,resolveDepthBuffer:d.ignoreDepthValues===!1,resolveStencilBuffer:d.ignoreDepthValues===!1,storeMultisampledDepthBuffer:d.ignoreDepthValues===!1,storeMultisampledStencilBuffer:d.ignoreDepthValues===!1})}M.isXRRenderTarget=!0,this.setFoveation(l),c=null,o=await r.requestReferenceSpace(a),pe.setContext(r),pe.start(),n.isPresenting=!0,n.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(r!==null)return r.environmentBlendMode},this.getDepthTexture=function(){return g.getDepthTexture()};function xe(se){for(let Ee=0;Ee<se.removed.length;Ee++){let Pe=se.removed[Ee],Oe=R.indexOf(Pe);Oe>=0&&(R[Oe]=null,P[Oe].disconnect(Pe))}for(let Ee=0;Ee<se.added.length;Ee++){let Pe=se.added[Ee],Oe=R.indexOf(Pe);if(Oe===-1){for(let Ke=0;Ke<P.length;Ke++)if(Ke>=R.length){R.push(Pe),Oe=Ke;break}else if(R[Ke]===null){R[Ke]=Pe,Oe=Ke;break}if(Oe===-1)break}let ye=P[Oe];ye&&ye.connect(Pe)}}function ne(se,Ee){Ee===null?se.matrixWorld.copy(se.matrix):se.matrixWorld.multiplyMatrices(Ee.matrixWorld,se.matrix),se.matrixWorldInverse.copy(se.matrixWorld).invert()}this.updateCamera=function(se){if(r===null)return;let Ee=se.near,Pe=se.far;g.texture!==null&&(g.depthNear>0&&(Ee=g.depthNear),g.depthFar>0&&(Pe=g.depthFar)),Y.near=D.near=z.near=Ee,Y.far=D.far=z.far=Pe,(U!==Y.near||W!==Y.far)&&(r.updateRenderState({depthNear:Y.near,depthFar:Y.far}),U=Y.near,W=Y.far),Y.layers.mask=se.layers.mask|6,z.layers.mask=Y.layers.mask&-5,D.layers.mask=Y.layers.mask&-3;let Oe=se.parent,ye=Y.cameras;ne(Y,Oe);for(let Ke=0;Ke<ye.length;Ke++)ne(ye[Ke],Oe);Y.projectionMatrix.copy(z.projectionMatrix),Y.projectionMatrixInverse.copy(z.projectionMatrixInverse),V===null&&se.isPerspectiveCamera&&(V={camera:se,fov:se.fov,zoom:se.zoom}),re(se,Y,Oe)};function re(se,Ee,Pe){Pe===null?se.matrix.copy(Ee.matrixWorld):(se.matrix.copy(Pe.matrixWorld),se.matrix.invert(),se.matrix.multiply(Ee.matrixWorld)),se.matrix.decompose(se.position,se.quaternion,se.scale),se.updateMatrixWorld(!0),se.projectionMatrix.copy(Ee.projectionMatrix),se.projectionMatrixInverse.copy(Ee.projectionMatrixInverse),se.isPerspectiveCamera&&(se.fov=no*2*Math.atan(1/se.projectionMatrix.elements[5]),se.zoom=1)}this.getCamera=function(){return Y},this.getFoveation=function(){if(!(f===null&&d===null))return l},this.setFoveation=function(se){l=se,f!==null&&(f.fixedFoveation=se),d!==null&&d.fixedFoveation!==void 0&&(d.fixedFoveation=se)},this.hasDepthSensing=function(){return g.texture!==null},this.getDepthSensingMesh=function(){return g.getMesh(Y)},this.getCameraTexture=function(se){return _[se]};let de=null;function ge(se,Ee){if(u=Ee.getViewerPose(c||o),m=Ee,u!==null){let Pe=u.views;d!==null&&(e.setRenderTargetFramebuffer(M,d.framebuffer),e.setRenderTarget(M));let Oe=!1;Pe.length!==Y.cameras.length&&(Y.cameras.length=0,Oe=!0);for(let et=0;et<Pe.length;et++){let St=Pe[et],bt=null;if(d!==null)bt=d.getViewport(St);else{let Zt=h.getViewSubImage(f,St);bt=Zt.viewport,et===0&&(e.setRenderTargetTextures(M,Zt.colorTexture,Zt.depthStencilTexture),e.setRenderTarget(M))}let vt=q[et];vt===void 0&&(vt=new ei,vt.layers.enable(et),vt.viewport=new Ot,q[et]=vt),vt.matrix.fromArray(St.transform.matrix),vt.matrix.decompose(vt.position,vt.quaternion,vt.scale),vt.projectionMatrix.fromArray(St.projectionMatrix),vt.projectionMatrixInverse.copy(vt.projectionMatrix).invert(),vt.viewport.set(bt.x,bt.y,bt.width,bt.height),et===0&&(Y.matrix.copy(vt.matrix),Y.matrix.decompose(Y.position,Y.quaternion,Y.scale)),Oe===!0&&Y.cameras.push(vt)}let ye=r.enabledFeatures;if(ye&&ye.includes("depth-sensing")&&r.depthUsage=="gpu-optimized"&&b){h=n.getBinding();let et=h.getDepthInformation(Pe[0]);et&&et.isValid&&et.texture&&g.init(et,r.renderState)}if(ye&&ye.includes("camera-access")&&b){e.state.unbindTexture(),h=n.getBinding();for(let et=0;et<Pe.length;et++){let St=Pe[et].camera;if(St){let bt=_[St];bt||(bt=new ml,_[St]=bt);let vt=h.getCameraImage(St);bt.sourceTexture=vt}}}}for(let Pe=0;Pe<P.length;Pe++){let Oe=R[Pe],ye=P[Pe];Oe!==null&&ye!==void 0&&ye.update(Oe,Ee,c||o)}de&&de(se,Ee),Ee.detectedPlanes&&n.dispatchEvent({type:"planesdetected",data:Ee}),m=null}let pe=new Lg;pe.setAnimationLoop(ge),this.setAnimationLoop=function(se){de=se},this.dispose=function(){}}},d2=new it,Hg=new dt;Hg.set(-1,0,0,0,1,0,0,0,1);function p2(i,e){function t(g,_){g.matrixAutoUpdate===!0&&g.updateMatrix(),_.value.copy(g.matrix)}function n(g,_){_.color.getRGB(g.fogColor.value,dd(i)),_.isFog?(g.fogNear.value=_.near,g.fogFar.value=_.far):_.isFogExp2&&(g.fogDensity.value=_.density)}function r(g,_,S,T,M){_.isNodeMaterial?_.uniformsNeedUpdate=!1:_.isMeshBasicMaterial?s(g,_):_.isMeshLambertMaterial?(s(g,_),_.envMap&&(g.envMapIntensity.value=_.envMapIntensity)):_.isMeshToonMaterial?(s(g,_),h(g,_)):_.isMeshPhongMaterial?(s(g,_),u(g,_),_.envMap&&(g.envMapIntensity.value=_.envMapIntensity)):_.isMeshStandardMaterial?(s(g,_),f(g,_),_.isMeshPhysicalMaterial&&d(g,_,M)):_.isMeshMatcapMaterial?(s(g,_),m(g,_)):_.isMeshDepthMaterial?s(g,_):_.isMeshDistanceMaterial?(s(g,_),b(g,_)):_.isMeshNormalMaterial?s(g,_):_.isLineBasicMaterial?(o(g,_),_.isLineDashedMaterial&&a(g,_)):_.isPointsMaterial?l(g,_,S,T):_.isSpriteMaterial?c(g,_):_.isShadowMaterial?(g.color.value.copy(_.color),g.opacity.value=_.opacity):_.isShaderMaterial&&(_.uniformsNeedUpdate=!1)}function s(g,_){g.opacity.value=_.opacity,_.color&&g.diffuse.value.copy(_.color),_.emissive&&g.emissive.value.copy(_.emissive).multiplyScalar(_.emissiveIntensity),_.map&&(g.map.value=_.map,t(_.map,g.mapTransform)),_.alphaMap&&(g.alphaMap.value=_.alphaMap,t(_.alphaMap,g.alphaMapTransform)),_.bumpMap&&(g.bumpMap.value=_.bumpMap,t(_.bumpMap,g.bumpMapTransform),g.bumpScale.value=_.bumpScale,_.side===mi&&(g.bumpScale.value*=-1)),_.normalMap&&(g.normalMap.value=_.normalMap,t(_.normalMap,g.normalMapTransform),g.normalScale.value.copy(_.normalScale),_.side===mi&&g.normalScale.value.negate()),_.displacementMap&&(g.displacementMap.value=_.displacementMap,t(_.displacementMap,g.displacementMapTransform),g.displacementScale.value=_.displacementScale,g.displacementBias.value=_.displacementBias),_.emissiveMap&&(g.emissiveMap.value=_.emissiveMap,t(_.emissiveMap,g.emissiveMapTransform)),_.specularMap&&(g.specularMap.value=_.specularMap,t(_.specularMap,g.specularMapTransform)),_.alphaTest>0&&(g.alphaTest.value=_.alphaTest);let S=e.get(_),T=S.envMap,M=S.envMapRotation;T&&(g.envMap.value=T,g.envMapRotation.value.setFromMatrix4(d2.makeRotationFromEuler(M)).transpose(),T.isCubeTexture&&T.isRenderTargetTexture===!1&&g.envMapRotation.value.premultiply(Hg),g.reflectivity.value=_.reflectivity,g.ior.value=_.ior,g.refractionRatio.value=_.refractionRatio),_.lightMap&&(g.lightMap.value=_.lightMap,g.lightMapIntensity.value=_.lightMapIntensity,t(_.lightMap,g.lightMapTransform)),_.aoMap&&(g.aoMap.value=_.aoMap,g.aoMapIntensity.value=_.aoMapIntensity,t(_.aoMap,g.aoMapTransform))}function o(g,_){g.diffuse.value.copy(_.color),g.opacity.value=_.opacity,_.map&&(g.map.value=_.map,t(_.map,g.mapTransform))}function a(g,_){g.dashSize.value=_.dashSize,g.totalSize.value=_.dashSize+_.gapSize,g.scale.value=_.scale}function l(g,_,S,T){g.diffuse.value.copy(_.color),g.opacity.value=_.opacity,g.size.value=_.size*S,g.scale.value=T*.5,_.map&&(g.map.value=_.map,t(_.map,g.uvTransform)),_.alphaMap&&(g.alphaMap.value=_.alphaMap,t(_.alphaMap,g.alphaMapTransform)),_.alphaTest>0&&(g.alphaTest.value=_.alphaTest)}function c(g,_){g.diffuse.value.copy(_.color),g.opacity.value=_.opacity,g.rotation.value=_.rotation,_.map&&(g.map.value=_.map,t(_.map,g.mapTransform)),_.alphaMap&&(g.alphaMap.value=_.alphaMap,t(_.alphaMap,g.alphaMapTransform)),_.alphaTest>0&&(g.alphaTest.value=_.alphaTest)}function u(g,_){g.specular.value.copy(_.specular),g.shininess.value=Math.max(_.shininess,1e-4)}function h(g,_){_.gradientMap&&(g.gradientMap.value=_.gradientMap)}function f(g,_){g.metalness.value=_.metalness,_.metalnessMap&&(g.metalnessMap.value=_.metalnessMap,t(_.metalnessMap,g.metalnessMapTransform)),g.roughness.value=_.roughness,_.roughnessMap&&(g.roughnessMap.value=_.roughnessMap,t(_.roughnessMap,g.roughnessMapTransform)),_.envMap&&(g.envMapIntensity.value=_.envMapIntensity)}function d(g,_,S){g.ior.value=_.ior,_.diffuseRoughness>0&&(g.diffuseRoughness.value=_.diffuseRoughness,_.diffuseRoughnessMap&&(g.diffuseRoughnessMap.value=_.diffuseRoughnessMap,t(_.diffuseRoughnessMap,g.diffuseRoughnessMapTransform))),_.sheen>0&&(g.sheenColor.value.copy(_.sheenColor).multiplyScalar(_.sheen),g.sheenRoughness.value=_.sheenRoughness,_.sheenColorMap&&(g.sheenColorMap.value=_.sheenColorMap,t(_.sheenColorMap,g.sheenColorMapTransform)),_.sheenRoughnessMap&&(g.sheenRoughnessMap.value=_.sheenRoughnessMap,t(_.sheenRoughnessMap,g.sheenRoughnessMapTransform))),_.clearcoat>0&&(g.clearcoat.value=_.clearcoat,g.clearcoatRoughness.value=_.clearcoatRoughness,_.clearcoatMap&&(g.clearcoatMap.value=_.clearcoatMap,t(_.clearcoatMap,g.clearcoatMapTransform)),_.clearcoatRoughnessMap&&(g.clearcoatRoughnessMap.value=_.clearcoatRoughnessMap,t(_.clearcoatRoughnessMap,g.clearcoatRoughnessMapTransform)),_.clearcoatNormalMap&&(g.clearcoatNormalMap.value=_.clearcoatNormalMap,t(_.clearcoatNormalMap,g.clearcoatNormalMapTransform),g.clearcoatNormalScale.value.copy(_.clearcoatNormalScale),_.side===mi&&g.clearcoatNormalScale.value.negate())),_.dispersion>0&&(g.dispersion.value=_.dispersion),_.retroreflectivity>0&&(g.retroreflectivity.value=_.retroreflectivity),_.iridescence>0&&(g.iridescence.value=_.iridescence,g.iridescenceIOR.value=_.iridescenceIOR,g.iridescenceThicknessMinimum.value=_.iridescenceThicknessMinimum,g.iridescenceThicknessMaximum.value=_.iridescenceThicknessMaximum,_.iridescenceMap&&(g.iridescenceMap.value=_.iridescenceMap,t(_.iridescenceMap,g.iridescenceMapTransform)),_.iridescenceThicknessMap&&(g.iridescenceThicknessMap.value=_.iridescenceThicknessMap,t(_.iridescenceThicknessMap,g.iridescenceThicknessMapTransform))),_.transmission>0&&(g.transmission.value=_.transmission,g.transmissionSamplerMap.value=S.texture,g.transmissionSamplerSize.value.set(S.width,S.height),_.transmissionMap&&(g.transmissionMap.value=_.transmissionMap,t(_.transmissionMap,g.transmissionMapTransform)),g.thickness.value=_.thickness,_.thicknessMap&&(g.thicknessMap.value=_.thicknessMap,t(_.thicknessMap,g.thicknessMapTransform)),g.attenuationDistance.value=_.attenuationDistance,g.attenuationColor.value.copy(_.attenuationColor)),_.anisotropy>0&&(g.anisotropyVector.value.set(_.anisotropy*Math.cos(_.anisotropyRotation),_.anisotropy*Math.sin(_.anisotropyRotation)),_.anisotropyMap&&(g.anisotropyMap.value=_.anisotropyMap,t(_.anisotropyMap,g.anisotropyMapTransform))),g.specularIntensity.value=_.specularIntensity,g.specularColor.value.copy(_.specularColor),_.specularColorMap&&(g.specularColorMap.value=_.specularColorMap,t(_.specularColorMap,g.specularColorMapTransform)),_.specularIntensityMap&&(g.specularIntensityMap.value=_.specularIntensityMap,t(_.specularIntensityMap,g.specularIntensityMapTransform))}function m(g,_){_.matcap&&(g.matcap.value=_.matcap)}function b(g,_){let S=e.get(_).light;g.referencePosition.value.setFromMatrixPosition(S.matrixWorld),g.nearDistance.value=S.shadow.camera.near,g.farDistance.value=S.shadow.camera.far}return{refreshFogUniforms:n,refreshMaterialUniforms:r}}function m2(i,e,t,n){let r={},s={};function o(S,T){let M=T.program;n.uniformBlockBinding(S,M,r[S.id])}function a(S,T){let M=r[S.id];M===void 0&&(m(S),M=l(S),r[S.id]=M,S.addEventListener("dispose",g));let P=T.program;n.updateUBOMapping(S,P);let R=e.render.frame;s[S.id]!==R&&(c(S),s[S.id]=R)}function l(S){let T=i.createBuffer(),M=S.__size,P=S.usage;return i.bindBuffer(i.UNIFORM_BUFFER,T),i.bufferData(i.UNIFORM_BUFFER,M,P),i.bindBuffer(i.UNIFORM_BUFFER,null),T}function c(S){let T=r[S.id],M=S.uniforms,P=S.__cache;i.bindBuffer(i.UNIFORM_BUFFER,T);for(let R=0,y=M.length;R<y;R++){let A=M[R];if(Array.isArray(A))for(let V=0,z=A.length;V<z;V++)u(A[V],R,V,P);else u(A,R,0,P)}i.bindBuffer(i.UNIFORM_BUFFER,null)}function u(S,T,M,P){if(f(S,T,M,P)===!0){let R=S.__offset,y=S.value;if(Array.isArray(y)){let A=0;for(let V=0;V<y.length;V++){let z=y[V],D=b(z,!0);h(z,S.__data,A),A+=D.storage/Float32Array.BYTES_PER_ELEMENT}}else h(y,S.__data,0);i.bufferSubData(i.UNIFORM_BUFFER,R,S.__data)}}function h(S,T,M){typeof S=="number"||typeof S=="boolean"?T[M]=S:S.isMatrix3?(T[M]=S.elements[0],T[M+1]=S.elements[1],T[M+2]=S.elements[2],T[M+3]=0,T[M+4]=S.elements[3],T[M+5]=S.elements[4],T[M+6]=S.elements[5],T[M+7]=0,T[M+8]=S.elements[6],T[M+9]=S.elements[7],T[M+10]=S.elements[8],T[M+11]=0):ArrayBuffer.isView(S)?T.set(S.subarray(0,T.length-M),M):S.toArray(T,M)}function f(S,T,M,P){let R=S.value,y=T+"_"+M;if(Array.isArray(R)){P[y]===void 0&&(P[y]=[]);let A=P[y],V=!1;for(let z=0;z<R.length;z++)d(R[z],A,z)===!0&&(V=!0);return V}return d(R,P,y)}function d(S,T,M){if(T[M]===void 0)return typeof S=="number"||typeof S=="boolean"?T[M]=S:ArrayBuffer.isView(S)?T[M]=S.slice():T[M]=S.clone(),!0;{let P=T[M];if(typeof S=="number"||typeof S=="boolean"){if(P!==S)return T[M]=S,!0}else{if(ArrayBuffer.isView(S))return!0;if(P.equals(S)===!1)return P.copy(S),!0}}return!1}function m(S){let T=S.uniforms,M=0,P=16;for(let y=0,A=T.length;y<A;y++){let V=Array.isArray(T[y])?T[y]:[T[y]];for(let z=0,D=V.length;z<D;z++){let q=V[z],Y=Array.isArray(q.value)?q.value:[q.value],U=Array.isArray(T[y])||Array.isArray(q.value),W=M;for(let $=0,xe=Y.length;$<xe;$++){let ne=Y[$],re=b(ne,U),de=M%P,ge=de%re.boundary,pe=de+ge;M+=ge,pe!==0&&P-pe<re.storage&&(M+=P-pe),$===0&&(W=M),M+=re.storage}let K=q.type==="int"?Int32Array:q.type==="uint"?Uint32Array:Float32Array;q.__data=new K((M-W)/Float32Array.BYTES_PER_ELEMENT),q.__offset=W}}let R=M%P;return R>0&&(M+=P-R),S.__size=M,S.__cache={},this}function b(S,T){let M={boundary:0,storage:0};return typeof S=="number"||typeof S=="boolean"?(M.boundary=4,M.storage=4):S.isVector2?(M.boundary=8,M.storage=8):S.isVector3||S.isColor?(M.boundary=16,M.storage=12):S.isVector4?(M.boundary=16,M.storage=16):S.isMatrix3?(M.boundary=16,M.storage=48):S.isMatrix4?(M.boundary=16,M.storage=64):S.isTexture?nt("WebGLRenderer: Texture samplers can not be part of an uniforms group."):ArrayBuffer.isView(S)?(M.boundary=16,M.storage=S.byteLength):nt("WebGLRenderer: Unsupported uniform value type.",S),T===!0&&(M.boundary=16,M.storage=Math.ceil(M.storage/16)*16),M}function g(S){let T=S.target;T.removeEventListener("dispose",g),i.deleteBuffer(r[T.id]),delete r[T.id],delete s[T.id]}function _(){for(let S in r)i.deleteBuffer(r[S]);r={},s={}}return{bind:o,update:a,dispose:_}}var g2=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]),Dr=null;function _2(){return Dr===null&&(Dr=new oi(g2,16,16,ai,tn),Dr.name="DFG_LUT",Dr.minFilter=qt,Dr.magFilter=qt,Dr.wrapS=si,Dr.wrapT=si,Dr.generateMipmaps=!1,Dr.needsUpdate=!0),Dr}var Zu=class{constructor(e={}){let{canvas:t=ig(),context:n=null,depth:r=!0,stencil:s=!1,alpha:o=!1,antialias:a=!1,premultipliedAlpha:l=!0,preserveDrawingBuffer:c=!1,powerPreference:u="default",failIfMajorPerformanceCaveat:h=!1,reversedDepthBuffer:f=!1,outputBufferType:d=bi}=e;this.isWebGLRenderer=!0;let m;if(n!==null){if(typeof WebGLRenderingContext<"u"&&n instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");m=n.getContextAttributes().alpha}else m=o;let b=d,g=new Set([du,fu,hu]),_=new Set([bi,ur,pa,mo,cu,uu]),S=new Uint32Array(4),T=new Int32Array(4),M={textures:[],min:[],max:[],resolution:[]},P=null,R=null,y=[],A=[],V=null;this.domElement=t,this.debug={checkShaderErrors:!0,diagnostics:{keywords:!1},onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=Lr,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let z=this,D=!1,q=null,Y=null,U=null,W=null;this._outputColorSpace=Ln;let K=0,$=0,xe=null,ne=-1,re=null,de=new Ot,ge=new Ot,pe=null,se=new ht(0),Ee=0,Pe=t.width,Oe=t.height,ye=1,Ke=null,ft=null,et=new Ot(0,0,Pe,Oe),St=new Ot(0,0,Pe,Oe),bt=!1,vt=new Ds,Zt=new Xc,kt=!1,mn=!1,Xt=new it,Dn=new J,Pt=new Ot,Tn={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},ln=!1;function An(){return xe===null?ye:1}let G=n;function He(p,v){return t.getContext(p,v)}let ct,yt,De,Kt,je,lt,F,E,ee,be,me,Ne,Fe,ae,he,Re,H,ue,oe,ke,Le,Be,tt;try{let p={alpha:!0,depth:r,stencil:s,antialias:a,premultipliedAlpha:l,preserveDrawingBuffer:c,powerPreference:u,failIfMajorPerformanceCaveat:h};if("setAttribute"in t&&t.setAttribute("data-engine",`three.js r${"187"}`),t.addEventListener("webglcontextlost",Je,!1),t.addEventListener("webglcontextrestored",mt,!1),t.addEventListener("webglcontextcreationerror",Ge,!1),G===null){let v="webgl2";if(G=He(v,p),G===null)throw He(v)?new Error("THREE.WebGLRenderer: Error creating WebGL context with your selected attributes."):new Error("THREE.WebGLRenderer: Error creating WebGL context.")}pt()}catch(p){throw t.removeEventListener("webglcontextlost",Je,!1),t.removeEventListener("webglcontextrestored",mt,!1),t.removeEventListener("webglcontextcreationerror",Ge,!1),_t("WebGLRenderer: "+p.message),p}function pt(){ct=new RS(G),ct.init(),Le=new u2(G,ct),yt=new _S(G,ct,e,Le),De=new l2(G,ct),yt.reversedDepthBuffer&&f&&De.buffers.depth.setReversed(!0),Y=G.createFramebuffer(),U=G.createFramebuffer(),W=G.createFramebuffer(),Kt=new PS(G),je=new $M,lt=new c2(G,ct,De,je,yt,Le,Kt),F=new ES(z),E=new Ny(G),Be=new mS(G,E),ee=new CS(G,E,Kt,Be),be=new NS(G,ee,E,Be,Kt),ue=new LS(G,yt,lt),he=new xS(je),me=new YM(z,F,ct,yt,Be,he),Ne=new p2(z,je),Fe=new KM,ae=new n2(ct),H=new pS(z,F,De,be,m,l),Re=new a2(z,be,yt),tt=new m2(G,Kt,yt,De),oe=new gS(G,ct,Kt),ke=new IS(G,ct,Kt),Kt.programs=me.programs,z.capabilities=yt,z.extensions=ct,z.properties=je,z.renderLists=Fe,z.shadowMap=Re,z.state=De,z.info=Kt}b!==bi&&(V=new FS(b,t.width,t.height,a,r,s));let we=new Ad(z,G);this.xr=we,this.getContext=function(){return G},this.getContextAttributes=function(){return G.getContextAttributes()},this.forceContextLoss=function(){let p=ct.get("WEBGL_lose_context");p&&p.loseContext()},this.forceContextRestore=function(){let p=ct.get("WEBGL_lose_context");p&&p.restoreContext()},this.getPixelRatio=function(){return ye},this.setPixelRatio=function(p){p!==void 0&&(ye=p,this.setSize(Pe,Oe,!1))},this.getSize=function(p){return p.set(Pe,Oe)},this.setSize=function(p,v,C=!0){if(we.isPresenting){nt("WebGLRenderer: Can't change size while VR device is presenting.");return}Pe=p,Oe=v,t.width=Math.floor(p*ye),t.height=Math.floor(v*ye),C===!0&&(t.style.width=p+"px",t.style.height=v+"px"),V!==null&&V.setSize(t.width,t.height),this.setViewport(0,0,p,v)},this.getDrawingBufferSize=function(p){return p.set(Pe*ye,Oe*ye).floor()},this.setDrawingBufferSize=function(p,v,C){Pe=p,Oe=v,ye=C,t.width=Math.floor(p*C),t.height=Math.floor(v*C),this.setViewport(0,0,p,v)},this.setEffects=function(p){if(b===bi){_t("WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.");return}if(p){for(let v=0;v<p.length;v++)if(p[v].isOutputPass===!0){nt("WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.");break}}V.setEffects(p||[])},this.getCurrentViewport=function(p){return p.copy(de)},this.getViewport=function(p){return p.copy(et)},this.setViewport=function(p,v,C,L){p.isVector4?et.set(p.x,p.y,p.z,p.w):et.set(p,v,C,L),De.viewport(de.copy(et).multiplyScalar(An()).round())},this.getScissor=function(p){return p.copy(St)},this.setScissor=function(p,v,C,L){p.isVector4?St.set(p.x,p.y,p.z,p.w):St.set(p,v,C,L),De.scissor(ge.copy(St).multiplyScalar(An()).round())},this.getScissorTest=function(){return bt},this.setScissorTest=function(p){De.setScissorTest(bt=p)},this.setOpaqueSort=function(p){Ke=p},this.setTransparentSort=function(p){ft=p},this.getClearColor=function(p){return p.copy(H.getClearColor())},this.setClearColor=function(){H.setClearColor(...arguments)},this.getClearAlpha=function(){return H.getClearAlpha()},this.setClearAlpha=function(){H.setClearAlpha(...arguments)},this.clear=function(p=!0,v=!0,C=!0){let L=0;if(p){let O=!1;if(xe!==null){let N=xe.texture.format;O=g.has(N)}if(O){let N=xe.texture.type,j=_.has(N),X=H.getClearColor(),Q=H.getClearAlpha(),te=X.r,fe=X.g,le=X.b;j?(S[0]=te,S[1]=fe,S[2]=le,S[3]=Q,G.clearBufferuiv(G.COLOR,0,S)):(T[0]=te,T[1]=fe,T[2]=le,T[3]=Q,G.clearBufferiv(G.COLOR,0,T))}else L|=G.COLOR_BUFFER_BIT}v&&(L|=G.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),C&&(L|=G.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),L!==0&&G.clear(L)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(p){p.setRenderer(this),q=p},this.dispose=function(){t.removeEventListener("webglcontextlost",Je,!1),t.removeEventListener("webglcontextrestored",mt,!1),t.removeEventListener("webglcontextcreationerror",Ge,!1),H.dispose(),Fe.dispose(),ae.dispose(),lt.dispose(),je.dispose(),F.dispose(),be.dispose(),ee.dispose(),Be.dispose(),tt.dispose(),me.dispose(),we.dispose(),we.removeEventListener("sessionstart",Xs),we.removeEventListener("sessionend",zi),ji.stop()};function Je(p){p.preventDefault(),rl("WebGLRenderer: Context Lost."),D=!0}function mt(){rl("WebGLRenderer: Context Restored."),D=!1;let p=Kt.autoReset,v=Re.enabled,C=Re.autoUpdate,L=Re.needsUpdate,O=Re.type;pt(),Kt.autoReset=p,Re.enabled=v,Re.autoUpdate=C,Re.needsUpdate=L,Re.type=O}function Ge(p){_t("WebGLRenderer: A WebGL context could not be created. Reason: ",p.statusMessage)}function Mt(p){let v=p.target;v.removeEventListener("dispose",Mt),nn(v)}function nn(p){jn(p),je.remove(p)}function jn(p){let v=je.get(p).programs;v!==void 0&&(v.forEach(function(C){me.releaseProgram(C)}),p.isShaderMaterial&&me.releaseShaderCache(p))}this.renderBufferDirect=function(p,v,C,L,O,N){v===null&&(v=Tn);let j=O.isMesh&&O.matrixWorld.determinantAffine()<0,X=vs(p,v,C,L,O);De.setMaterial(L,j);let Q=C.index,te=1;if(L.wireframe===!0){if(Q=ee.getWireframeAttribute(C),Q===void 0)return;te=2}let fe=C.drawRange,le=C.attributes.position,ce=fe.start*te,Se=(fe.start+fe.count)*te;N!==null&&(ce=Math.max(ce,N.start*te),Se=Math.min(Se,(N.start+N.count)*te)),Q!==null?(ce=Math.max(ce,0),Se=Math.min(Se,Q.count)):le!=null&&(ce=Math.max(ce,0),Se=Math.min(Se,le.count));let Te=Se-ce;if(Te<0||Te===1/0)return;Be.setup(O,L,X,C,Q);let Ae,Ve=oe;if(Q!==null&&(Ae=E.get(Q),Ve=ke,Ve.setIndex(Ae)),O.isMesh)L.wireframe===!0?(De.setLineWidth(L.wireframeLinewidth*An()),Ve.setMode(G.LINES)):Ve.setMode(G.TRIANGLES);else if(O.isLine){let rt=L.linewidth;rt===void 0&&(rt=1),De.setLineWidth(rt*An()),O.isLineSegments?Ve.setMode(G.LINES):O.isLineLoop?Ve.setMode(G.LINE_LOOP):Ve.setMode(G.LINE_STRIP)}else O.isPoints?Ve.setMode(G.POINTS):O.isSprite&&Ve.setMode(G.TRIANGLES);if(O.isBatchedMesh)if(ct.get("WEBGL_multi_draw"))Ve.renderMultiDraw(O._multiDrawStarts,O._multiDrawCounts,O._multiDrawCount);else{let rt=O._multiDrawStarts,ve=O._multiDrawCounts,ot=O._multiDrawCount,Ce=Q?E.get(Q).bytesPerElement:1,Xe=je.get(L).currentProgram.getUniforms();for(let We=0;We<ot;We++)Xe.setValue(G,"_gl_DrawID",We),Ve.render(rt[We]/Ce,ve[We])}else if(O.isInstancedMesh)Ve.renderInstances(ce,Te,O.count);else if(C.isInstancedBufferGeometry){let rt=C._maxInstanceCount!==void 0?C._maxInstanceCount:1/0,ve=Math.min(C.instanceCount,rt);Ve.renderInstances(ce,Te,ve)}else Ve.render(ce,Te)};function Ws(p,v,C,L){q!==null&&p.isNodeMaterial&&q.setObject(L,p),kt===!0&&he.setState(p,C,!1),p.transparent===!0&&p.side===Xi&&p.forceSinglePass===!1?(p.side=mi,p.needsUpdate=!0,ci(p,v,L),p.side=Pr,p.needsUpdate=!0,ci(p,v,L),p.side=Xi):ci(p,v,L)}this.compile=function(p,v,C=null){C===null&&(C=p),q!==null&&q.renderStart(p,v,C),R=ae.get(C),R.init(v),A.push(R),C.traverseVisible(function(O){O.isLight&&O.layers.test(v.layers)&&(R.pushLight(O),O.castShadow&&R.pushShadow(O))}),p!==C&&p.traverseVisible(function(O){O.isLight&&O.layers.test(v.layers)&&(R.pushLight(O),O.castShadow&&R.pushShadow(O))}),R.setupLights(),q!==null&&q.updateLights(R.state.lightsArray),mn=this.localClippingEnabled,kt=he.init(this.clippingPlanes,mn),kt===!0&&he.setGlobalState(this.clippingPlanes,v),q!==null&&Re.render(R.state.shadowsArray,C,v);let L=new Set;return p.traverse(function(O){if(!(O.isMesh||O.isPoints||O.isLine||O.isSprite))return;let N=O.material;if(N)if(Array.isArray(N))for(let j=0;j<N.length;j++){let X=N[j];Ws(X,C,v,O),L.add(X)}else Ws(N,C,v,O),L.add(N)}),R=A.pop(),q!==null&&q.renderEnd(),L},this.compileAsync=function(p,v,C=null){let L=this.compile(p,v,C);return new Promise(O=>{function N(){if(L.forEach(function(j){let Q=je.get(j).currentProgram;(Q===void 0||Q.isReady())&&L.delete(j)}),L.size===0){O(p);return}setTimeout(N,10)}ct.get("KHR_parallel_shader_compile")!==null?N():setTimeout(N,10)})};let _s=null;function ka(p){_s&&_s(p)}function Xs(){ji.stop()}function zi(){ji.start()}let ji=new Lg;ji.setAnimationLoop(ka),typeof self<"u"&&ji.setContext(self),this.setAnimationLoop=function(p){_s=p,we.setAnimationLoop(p),p===null?ji.stop():ji.start()},we.addEventListener("sessionstart",Xs),we.addEventListener("sessionend",zi),this.render=function(p,v){if(v!==void 0&&v.isCamera!==!0){_t("WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(D===!0)return;q!==null&&q.renderStart(p,v);let C=we.enabled===!0&&we.isPresenting===!0,L=V!==null&&(xe===null||C)&&V.begin(z,xe);if(p.matrixWorldAutoUpdate===!0&&p.updateMatrixWorld(),v.parent===null&&v.matrixWorldAutoUpdate===!0&&v.updateMatrixWorld(),we.enabled===!0&&we.isPresenting===!0&&(V===null||V.isCompositing()===!1)&&(we.cameraAutoUpdate===!0&&we.updateCamera(v),v=we.getCamera()),p.isScene===!0&&p.onBeforeRender(z,p,v,xe),R=ae.get(p,A.length),R.init(v),R.state.textureUnits=lt.getTextureUnits(),A.push(R),Xt.multiplyMatrices(v.projectionMatrix,v.matrixWorldInverse),v.isArrayCamera?Zt.setFromArrayCamera(v):vt.setFromProjectionMatrix(Xt,Wi,v.reversedDepth),mn=this.localClippingEnabled,kt=he.init(this.clippingPlanes,mn),P=Fe.get(p,y.length),P.init(),y.push(P),this.info.render.frame++,we.enabled===!0&&we.isPresenting===!0){let j=z.xr.getDepthSensingMesh();j!==null&&Qi(j,v,-1/0,z.sortObjects)}Qi(p,v,0,z.sortObjects),P.finish(),q!==null&&q.updateLights(R.state.lightsArray),z.sortObjects===!0&&P.sort(Ke,ft),ln=we.enabled===!1||we.isPresenting===!1||we.hasDepthSensing()===!1,ln&&H.addToRenderList(P,p),this.info.autoReset===!0&&this.info.reset(),kt===!0&&he.beginShadows();let O=R.state.shadowsArray;if(Re.render(O,p,v),kt===!0&&he.endShadows(),(L&&V.hasRenderPass())===!1){let j=P.opaque,X=P.transmissive;if(R.setupLights(),v.isArrayCamera){let Q=v.cameras;if(X.length>0)for(let te=0,fe=Q.length;te<fe;te++){let le=Q[te];Mi(j,X,p,le)}ln&&H.render(p);for(let te=0,fe=Q.length;te<fe;te++){let le=Q[te];xs(P,p,le,le.viewport)}}else X.length>0&&Mi(j,X,p,v),ln&&H.render(p),xs(P,p,v)}xe!==null&&$===0&&(lt.updateMultisampleRenderTarget(xe),lt.updateRenderTargetMipmap(xe)),L&&V.end(z),p.isScene===!0&&p.onAfterRender(z,p,v),Be.resetDefaultState(),ne=-1,re=null,A.pop(),A.length>0?(R=A[A.length-1],lt.setTextureUnits(R.state.textureUnits),kt===!0&&he.setGlobalState(z.clippingPlanes,R.state.camera)):R=null,y.pop(),y.length>0?P=y[y.length-1]:P=null,q!==null&&q.renderEnd()};function Qi(p,v,C,L){if(p.visible===!1)return;if(p.layers.test(v.layers)){if(p.isGroup)C=p.renderOrder;else if(p.isLOD)p.autoUpdate===!0&&p.update(v);else if(p.isLight)R.pushLight(p),p.castShadow&&R.pushShadow(p);else if(p.isSprite){let j=v.isArrayCamera?Zt:vt;if(!p.frustumCulled||p.intersectsFrustum(j)){L&&Pt.setFromMatrixPosition(p.matrixWorld).applyMatrix4(Xt);let X=be.update(p),Q=p.material;Q.visible&&P.push(p,X,Q,C,Pt.z,null,v)}}else if(p.isMesh||p.isLine||p.isPoints){let j=v.isArrayCamera?Zt:vt;if(!p.frustumCulled||p.intersectsFrustum(j)){let X=be.update(p),Q=p.material;if(L&&(p.boundingSphere!==void 0?(p.boundingSphere===null&&p.computeBoundingSphere(),Pt.copy(p.boundingSphere.center)):(X.boundingSphere===null&&X.computeBoundingSphere(),Pt.copy(X.boundingSphere.center)),Pt.applyMatrix4(p.matrixWorld).applyMatrix4(Xt)),Array.isArray(Q)){let te=X.groups;for(let fe=0,le=te.length;fe<le;fe++){let ce=te[fe],Se=Q[ce.materialIndex];Se&&Se.visible&&P.push(p,X,Se,C,Pt.z,ce,v)}}else Q.visible&&P.push(p,X,Q,C,Pt.z,null,v)}}}let N=p.children;for(let j=0,X=N.length;j<X;j++)Qi(N[j],v,C,L)}function xs(p,v,C,L){let{opaque:O,transmissive:N,transparent:j}=p;R.setupLightsView(C),kt===!0&&he.setGlobalState(z.clippingPlanes,C),L&&De.viewport(de.copy(L)),O.length>0&&cn(O,v,C),N.length>0&&cn(N,v,C),j.length>0&&cn(j,v,C),De.buffers.depth.setTest(!0),De.buffers.depth.setMask(!0),De.buffers.color.setMask(!0),De.setPolygonOffset(!1)}function Mi(p,v,C,L){if((C.isScene===!0?C.overrideMaterial:null)!==null)return;if(R.state.transmissionRenderTarget[L.id]===void 0){let ce=ct.has("EXT_color_buffer_half_float")||ct.has("EXT_color_buffer_float");R.state.transmissionRenderTarget[L.id]=new Zn(1,1,{generateMipmaps:!0,type:ce?tn:bi,minFilter:Fi,samples:Math.max(4,yt.samples),stencilBuffer:s,resolveDepthBuffer:!1,resolveStencilBuffer:!1,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,colorSpace:Rt.workingColorSpace})}let N=R.state.transmissionRenderTarget[L.id],j=L.viewport||de;N.setSize(j.z*z.transmissionResolutionScale,j.w*z.transmissionResolutionScale);let X=z.getRenderTarget(),Q=z.getActiveCubeFace(),te=z.getActiveMipmapLevel();z.setRenderTarget(N),z.getClearColor(se),Ee=z.getClearAlpha(),Ee<1&&z.setClearColor(16777215,.5),z.clear(),ln&&H.render(C);let fe=z.toneMapping;z.toneMapping=Lr;let le=L.viewport;if(L.viewport!==void 0&&(L.viewport=void 0),R.setupLightsView(L),kt===!0&&he.setGlobalState(z.clippingPlanes,L),cn(p,C,L),lt.updateMultisampleRenderTarget(N),lt.updateRenderTargetMipmap(N),ct.has("WEBGL_multisampled_render_to_texture")===!1){let ce=!1;for(let Se=0,Te=v.length;Se<Te;Se++){let Ae=v[Se],{object:Ve,geometry:rt,material:ve,group:ot}=Ae;if(ve.side===Xi&&Ve.layers.test(L.layers)){let Ce=ve.side;ve.side=mi,ve.needsUpdate=!0,xn(Ve,C,L,rt,ve,ot),ve.side=Ce,ve.needsUpdate=!0,ce=!0}}ce===!0&&(lt.updateMultisampleRenderTarget(N),lt.updateRenderTargetMipmap(N))}z.setRenderTarget(X,Q,te),z.setClearColor(se,Ee),le!==void 0&&(L.viewport=le),z.toneMapping=fe}function cn(p,v,C){let L=v.isScene===!0?v.overrideMaterial:null;for(let O=0,N=p.length;O<N;O++){let j=p[O],{object:X,geometry:Q,group:te}=j,fe=j.material;fe.allowOverride===!0&&L!==null&&(fe=L),X.layers.test(C.layers)&&xn(X,v,C,Q,fe,te)}}function xn(p,v,C,L,O,N){q!==null&&O.isNodeMaterial&&q.setObject(p,O),p.onBeforeRender(z,v,C,L,O,N),p.modelViewMatrix.multiplyMatrices(C.matrixWorldInverse,p.matrixWorld),p.normalMatrix.getNormalMatrix(p.modelViewMatrix),O.onBeforeRender(z,v,C,L,p,N),O.transparent===!0&&O.side===Xi&&O.forceSinglePass===!1?(O.side=mi,O.needsUpdate=!0,z.renderBufferDirect(C,v,L,O,p,N),O.side=Pr,O.needsUpdate=!0,z.renderBufferDirect(C,v,L,O,p,N),O.side=Xi):z.renderBufferDirect(C,v,L,O,p,N),p.onAfterRender(z,v,C,L,O,N)}function vn(p){let v=0;for(let C of p)C.texture!==null&&v++;return v}function ci(p,v,C){v.isScene!==!0&&(v=Tn);let L=je.get(p),O=R.state.lights,N=R.state.shadowsArray,j=O.state.version,X=me.getParameters(p,O.state,N,v,C,R.state.lightProbeGridArray),Q=me.getProgramCacheKey(X),te=L.programs;L.environment=p.isMeshStandardMaterial||p.isMeshLambertMaterial||p.isMeshPhongMaterial?v.environment:null,L.fog=v.fog;let fe=p.isMeshStandardMaterial||p.isMeshLambertMaterial&&!p.envMap||p.isMeshPhongMaterial&&!p.envMap;L.envMap=F.get(p.envMap||L.environment,fe),L.envMapRotation=L.environment!==null&&p.envMap===null?v.environmentRotation:p.envMapRotation,te===void 0&&(p.addEventListener("dispose",Mt),te=new Map,L.programs=te,L.programVariants=new Map);let le=te.get(Q);if(le!==void 0){if(L.currentProgram===le&&L.lightsStateVersion===j)return _r(p,X),le}else X.uniforms=me.getUniforms(p),q!==null&&p.isNodeMaterial&&q.build(p,C,X),p.onBeforeCompile(X,z),le=me.acquireProgram(X,Q),te.set(Q,le),L.uniforms=X.uniforms;let ce=L.uniforms;return(!p.isShaderMaterial&&!p.isRawShaderMaterial||p.clipping===!0)&&(ce.clippingPlanes=he.uniform),_r(p,X),L.needsLights=Pn(p),L.lightsStateVersion=j,L.needsLights&&(ce.ambientLightColor.value=O.state.ambient,ce.lightProbe.value=O.state.probe,ce.sunLights.value=O.state.sun,ce.sunLightShadows.value=O.state.sunShadow,ce.directionalLights.value=O.state.directional,ce.directionalLightShadows.value=O.state.directionalShadow,ce.spotLights.value=O.state.spot,ce.spotLightShadows.value=O.state.spotShadow,ce.rectAreaLights.value=O.state.rectArea,ce.ltc_1.value=O.state.rectAreaLTC1,ce.ltc_2.value=O.state.rectAreaLTC2,ce.pointLights.value=O.state.point,ce.pointLightShadows.value=O.state.pointShadow,ce.hemisphereLights.value=O.state.hemi,ce.sunShadowMatrix.value=O.state.sunShadowMatrix,ce.sunShadowCascade.value=O.state.sunShadowCascade,ce.directionalShadowMatrix.value=O.state.directionalShadowMatrix,ce.spotLightMatrix.value=O.state.spotLightMatrix,ce.spotLightMap.value=O.state.spotLightMap,ce.pointShadowMatrix.value=O.state.pointShadowMatrix),L.numLightProbeGrids=vn(R.state.lightProbeGridArray),L.currentProgram=le,L.uniformsList=null,le}function Hn(p,v,C,L,O){let N=je.get(p),j=N.currentProgram.id+","+L+","+O,X=N.programVariants.get(j);return X===void 0?(X=ci(p,v,C),N.programVariants.set(j,X)):(N.currentProgram=X,N.uniformsList=null,N.outputColorSpace=L,N.toneMapping=O),X}function gr(p){if(p.uniformsList===null){let v=p.currentProgram.getUniforms();p.uniformsList=ga.seqWithValue(v.seq,p.uniforms)}return p.uniformsList}function _r(p,v){let C=je.get(p);C.outputColorSpace=v.outputColorSpace,C.batching=v.batching,C.batchingColor=v.batchingColor,C.instancing=v.instancing,C.instancingColor=v.instancingColor,C.instancingMorph=v.instancingMorph,C.skinning=v.skinning,C.morphTargets=v.morphTargets,C.morphNormals=v.morphNormals,C.morphColors=v.morphColors,C.morphTargetsCount=v.morphTargetsCount,C.numClippingPlanes=v.numClippingPlanes,C.numIntersection=v.numClipIntersection,C.vertexAlphas=v.vertexAlphas,C.vertexTangents=v.vertexTangents,C.toneMapping=v.toneMapping}function vs(p,v,C,L,O){v.isScene!==!0&&(v=Tn),lt.resetTextureUnits();let N=v.fog,j=L.isMeshStandardMaterial||L.isMeshLambertMaterial||L.isMeshPhongMaterial?v.environment:null,X=xe===null?z.outputColorSpace:xe.isXRRenderTarget===!0?xe.texture.colorSpace:Rt.workingColorSpace,Q=L.isMeshStandardMaterial||L.isMeshLambertMaterial&&!L.envMap||L.isMeshPhongMaterial&&!L.envMap,te=F.get(L.envMap||j,Q),fe=L.vertexColors===!0&&!!C.attributes.color&&C.attributes.color.itemSize===4,le=!!C.attributes.tangent&&(!!L.normalMap||L.anisotropy>0),ce=!!C.morphAttributes.position,Se=!!C.morphAttributes.normal,Te=!!C.morphAttributes.color,Ae=Lr;L.toneMapped&&(xe===null||xe.isXRRenderTarget===!0)&&(Ae=z.toneMapping);let Ve=C.morphAttributes.position||C.morphAttributes.normal||C.morphAttributes.color,rt=Ve!==void 0?Ve.length:0,ve=je.get(L),ot=R.state.lights;if(kt===!0&&(mn===!0||p!==re)){let at=p===re&&L.id===ne;he.setState(L,p,at)}let Ce=!1,Xe=!1;L.version===ve.__version?ve.needsLights&&ve.lightsStateVersion!==ot.state.version||O.isBatchedMesh&&ve.batching===!1||!O.isBatchedMesh&&ve.batching===!0||O.isBatchedMesh&&ve.batchingColor===!0&&O._colorsTexture===null||O.isBatchedMesh&&ve.batchingColor===!1&&O._colorsTexture!==null||O.isInstancedMesh&&ve.instancing===!1||!O.isInstancedMesh&&ve.instancing===!0||O.isSkinnedMesh&&ve.skinning===!1||!O.isSkinnedMesh&&ve.skinning===!0||O.isInstancedMesh&&ve.instancingColor===!0&&O.instanceColor===null||O.isInstancedMesh&&ve.instancingColor===!1&&O.instanceColor!==null||O.isInstancedMesh&&ve.instancingMorph===!0&&O.morphTexture===null||O.isInstancedMesh&&ve.instancingMorph===!1&&O.morphTexture!==null||ve.envMap!==te||L.fog===!0&&ve.fog!==N||ve.numClippingPlanes!==void 0&&(ve.numClippingPlanes!==he.numPlanes||ve.numIntersection!==he.numIntersection)||ve.vertexAlphas!==fe||ve.vertexTangents!==le||ve.morphTargets!==ce||ve.morphNormals!==Se||ve.morphColors!==Te||ve.morphTargetsCount!==rt||ve.numLightProbeGrids!==vn(R.state.lightProbeGridArray)?Ce=!0:(ve.outputColorSpace!==X||ve.toneMapping!==Ae)&&(Xe=!0):(Ce=!0,ve.__version=L.version);let We=ve.currentProgram;(Ce===!0||Xe===!0)&&(We=Xe===!0?Hn(L,v,O,X,Ae):ci(L,v,O),q&&L.isNodeMaterial&&q.onUpdateProgram(L,We,ve));let Ft=!1,Tt=!1,ut=!1,qe=We.getUniforms(),At=ve.uniforms;if(De.useProgram(We.program)&&(Ft=!0,Tt=!0,ut=!0),L.id!==ne&&(ne=L.id,Tt=!0),Ft||re!==p){De.buffers.depth.getReversed()&&p.reversedDepth!==!0&&(p._reversedDepth=!0,p.updateProjectionMatrix()),qe.setValue(G,"projectionMatrix",p.projectionMatrix),qe.setValue(G,"viewMatrix",p.matrixWorldInverse);let Vt=qe.map.cameraPosition;Vt!==void 0&&Vt.setValue(G,Dn.setFromMatrixPosition(p.matrixWorld)),yt.logarithmicDepthBuffer&&qe.setValue(G,"logDepthBufFC",2/(Math.log(p.far+1)/Math.LN2)),(L.isMeshPhongMaterial||L.isMeshToonMaterial||L.isMeshLambertMaterial||L.isMeshBasicMaterial||L.isMeshStandardMaterial||L.isShaderMaterial)&&qe.setValue(G,"isOrthographic",p.isOrthographicCamera===!0),re!==p&&(re=p,Tt=!0,ut=!0)}if(ve.needsLights&&(ot.state.sunShadowMap.length>0&&qe.setValue(G,"sunShadowMap",ot.state.sunShadowMap,lt),ot.state.directionalShadowMap.length>0&&qe.setValue(G,"directionalShadowMap",ot.state.directionalShadowMap,lt),ot.state.spotShadowMap.length>0&&qe.setValue(G,"spotShadowMap",ot.state.spotShadowMap,lt),ot.state.pointShadowMap.length>0&&qe.setValue(G,"pointShadowMap",ot.state.pointShadowMap,lt)),O.isSkinnedMesh){qe.setOptional(G,O,"bindMatrix"),qe.setOptional(G,O,"bindMatrixInverse");let at=O.skeleton;at&&(at.boneTexture===null&&at.computeBoneTexture(),qe.setValue(G,"boneTexture",at.boneTexture,lt))}O.isBatchedMesh&&(qe.setOptional(G,O,"batchingTexture"),qe.setValue(G,"batchingTexture",O._matricesTexture,lt),qe.setOptional(G,O,"batchingIdTexture"),qe.setValue(G,"batchingIdTexture",O._indirectTexture,lt),qe.setOptional(G,O,"batchingColorTexture"),O._colorsTexture!==null&&qe.setValue(G,"batchingColorTexture",O._colorsTexture,lt));let Jt=C.morphAttributes;if((Jt.position!==void 0||Jt.normal!==void 0||Jt.color!==void 0)&&ue.update(O,C,We),(Tt||ve.receiveShadow!==O.receiveShadow)&&(ve.receiveShadow=O.receiveShadow,qe.setValue(G,"receiveShadow",O.receiveShadow)),(L.isMeshStandardMaterial||L.isMeshLambertMaterial||L.isMeshPhongMaterial)&&L.envMap===null&&v.environment!==null&&(At.envMapIntensity.value=v.environmentIntensity),At.dfgLUT!==void 0&&(At.dfgLUT.value=_2()),Tt){if(qe.setValue(G,"toneMappingExposure",z.toneMappingExposure),ve.needsLights&&yn(At,ut),N&&L.fog===!0&&Ne.refreshFogUniforms(At,N),Ne.refreshMaterialUniforms(At,L,ye,Oe,R.state.transmissionRenderTarget[p.id]),ve.needsLights&&ve.numLightProbeGrids>0){let at=M,Vt=0;for(let bn of R.state.lightProbeGridArray)bn.texture!==null&&(at.textures[Vt]=bn.texture,at.min[Vt]=bn.boundingBox.min,at.max[Vt]=bn.boundingBox.max,at.resolution[Vt]=bn.resolution,Vt++);for(let bn in at)at[bn].length=Vt;At.probesSH.value=at.textures,At.probesMin.value=at.min,At.probesMax.value=at.max,At.probesResolution.value=at.resolution}ga.upload(G,gr(ve),At,lt)}if(L.isShaderMaterial&&L.uniformsNeedUpdate===!0&&(ga.upload(G,gr(ve),At,lt),L.uniformsNeedUpdate=!1),L.isSpriteMaterial&&qe.setValue(G,"center",O.center),qe.setValue(G,"modelViewMatrix",O.modelViewMatrix),qe.setValue(G,"normalMatrix",O.normalMatrix),qe.setValue(G,"modelMatrix",O.matrixWorld),L.uniformsGroups!==void 0){let at=L.uniformsGroups;for(let Vt=0,bn=at.length;Vt<bn;Vt++){let xr=at[Vt];tt.update(xr,We),tt.bind(xr,We)}}return We}function yn(p,v){p.ambientLightColor.needsUpdate=v,p.lightProbe.needsUpdate=v,p.sunLights.needsUpdate=v,p.sunLightShadows.needsUpdate=v,p.directionalLights.needsUpdate=v,p.directionalLightShadows.needsUpdate=v,p.pointLights.needsUpdate=v,p.pointLightShadows.needsUpdate=v,p.spotLights.needsUpdate=v,p.spotLightShadows.needsUpdate=v,p.rectAreaLights.needsUpdate=v,p.hemisphereLights.needsUpdate=v}function Pn(p){return p.isMeshLambertMaterial||p.isMeshToonMaterial||p.isMeshPhongMaterial||p.isMeshStandardMaterial||p.isShadowMaterial||p.isShaderMaterial&&p.lights===!0}this.getActiveCubeFace=function(){return K},this.getActiveMipmapLevel=function(){return $},this.getRenderTarget=function(){return xe},this.setRenderTargetTextures=function(p,v,C){let L=je.get(p);L.__autoAllocateDepthBuffer=p.resolveDepthBuffer===!1,L.__autoAllocateDepthBuffer===!1&&(L.__useRenderToTexture=!1),je.get(p.texture).__webglTexture=v,je.get(p.depthTexture).__webglTexture=L.__autoAllocateDepthBuffer?void 0:C,L.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(p,v){let C=je.get(p);C.__webglFramebuffer=v,C.__useDefaultFramebuffer=v===void 0},this.setRenderTarget=function(p,v=0,C=0){xe=p,K=v,$=C;let L=null,O=!1,N=!1;if(p){let X=je.get(p);if(X.__useDefaultFramebuffer!==void 0){De.bindFramebuffer(G.FRAMEBUFFER,X.__webglFramebuffer),de.copy(p.viewport),ge.copy(p.scissor),pe=p.scissorTest,De.viewport(de),De.scissor(ge),De.setScissorTest(pe),ne=-1;return}else if(X.__webglFramebuffer===void 0)lt.setupRenderTarget(p);else if(X.__hasExternalTextures)lt.rebindTextures(p,je.get(p.texture).__webglTexture,je.get(p.depthTexture).__webglTexture);else if(p.depthBuffer){let fe=p.depthTexture;if(X.__boundDepthTexture!==fe){if(fe!==null&&je.has(fe)&&(p.width!==fe.image.width||p.height!==fe.image.height))throw new Error("THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.");lt.setupDepthRenderbuffer(p)}}let Q=p.texture;(Q.isData3DTexture||Q.isDataArrayTexture||Q.isCompressedArrayTexture)&&(N=!0);let te=je.get(p).__webglFramebuffer;p.isWebGLCubeRenderTarget?(Array.isArray(te[v])?L=te[v][C]:L=te[v],O=!0):p.samples>0&&lt.useMultisampledRTT(p)===!1?L=je.get(p).__webglMultisampledFramebuffer:Array.isArray(te)?L=te[C]:L=te,de.copy(p.viewport),ge.copy(p.scissor),pe=p.scissorTest}else de.copy(et).multiplyScalar(ye).floor(),ge.copy(St).multiplyScalar(ye).floor(),pe=bt;if(C!==0&&(L=Y),De.bindFramebuffer(G.FRAMEBUFFER,L)&&De.drawBuffers(p,L),De.viewport(de),De.scissor(ge),De.setScissorTest(pe),O){let X=je.get(p.texture);G.framebufferTexture2D(G.FRAMEBUFFER,G.COLOR_ATTACHMENT0,G.TEXTURE_CUBE_MAP_POSITIVE_X+v,X.__webglTexture,C)}else if(N){let X=v;for(let Q=0;Q<p.textures.length;Q++){let te=je.get(p.textures[Q]);G.framebufferTextureLayer(G.FRAMEBUFFER,G.COLOR_ATTACHMENT0+Q,te.__webglTexture,C,X)}}else if(p!==null&&C!==0){let X=je.get(p.texture);G.framebufferTexture2D(G.FRAMEBUFFER,G.COLOR_ATTACHMENT0,G.TEXTURE_2D,X.__webglTexture,C)}ne=-1};function x(p){let v=je.get(p);return(v.__readFormat!==p.format||v.__readType!==p.type)&&(v.__readFormat=p.format,v.__readType=p.type,v.__formatReadable=yt.textureFormatReadable(p.format),v.__typeReadable=yt.textureTypeReadable(p.type)),v}this.readRenderTargetPixels=function(p,v,C,L,O,N,j,X=0){if(!(p&&p.isWebGLRenderTarget)){_t("WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let Q=je.get(p).__webglFramebuffer;if(p.isWebGLCubeRenderTarget&&j!==void 0&&(Q=Q[j],Array.isArray(Q)&&(Q=Q[0])),Q){De.bindFramebuffer(G.FRAMEBUFFER,Q);try{let te=p.textures[X],fe=te.format,le=te.type;p.textures.length>1&&G.readBuffer(G.COLOR_ATTACHMENT0+X);let ce=x(te);if(ce.__formatReadable===!1){_t("WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(ce.__typeReadable===!1){_t("WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}v>=0&&v<=p.width-L&&C>=0&&C<=p.height-O&&G.readPixels(v,C,L,O,Le.convert(fe),Le.convert(le),N)}finally{let te=xe!==null?je.get(xe).__webglFramebuffer:null;De.bindFramebuffer(G.FRAMEBUFFER,te)}}},this.readRenderTargetPixelsAsync=async function(p,v,C,L,O,N,j,X=0){if(!(p&&p.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let Q=je.get(p).__webglFramebuffer;if(p.isWebGLCubeRenderTarget&&j!==void 0&&(Q=Q[j],Array.isArray(Q)&&(Q=Q[0])),Q)if(v>=0&&v<=p.width-L&&C>=0&&C<=p.height-O){De.bindFramebuffer(G.FRAMEBUFFER,Q);let te=p.textures[X],fe=te.format,le=te.type;p.textures.length>1&&G.readBuffer(G.COLOR_ATTACHMENT0+X);let ce=x(te);if(ce.__formatReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(ce.__typeReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let Se=G.createBuffer();G.bindBuffer(G.PIXEL_PACK_BUFFER,Se),G.bufferData(G.PIXEL_PACK_BUFFER,N.byteLength,G.STREAM_READ),G.readPixels(v,C,L,O,Le.convert(fe),Le.convert(le),0),G.bindBuffer(G.PIXEL_PACK_BUFFER,null);let Te=xe!==null?je.get(xe).__webglFramebuffer:null;De.bindFramebuffer(G.FRAMEBUFFER,Te);let Ae=G.fenceSync(G.SYNC_GPU_COMMANDS_COMPLETE,0);return G.flush(),await sg(G,Ae,4),G.bindBuffer(G.PIXEL_PACK_BUFFER,Se),G.getBufferSubData(G.PIXEL_PACK_BUFFER,0,N),G.bindBuffer(G.PIXEL_PACK_BUFFER,null),G.deleteBuffer(Se),G.deleteSync(Ae),N}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(p,v=null,C=0){let L=Math.pow(2,-C),O=Math.floor(p.image.width*L),N=Math.floor(p.image.height*L),j=v!==null?v.x:0,X=v!==null?v.y:0;lt.setTexture2D(p,0),G.copyTexSubImage2D(G.TEXTURE_2D,C,0,0,j,X,O,N),De.unbindTexture()},this.copyTextureToTexture=function(p,v,C=null,L=null,O=0,N=0){let j,X,Q,te,fe,le,ce,Se,Te,Ae=p.isCompressedTexture?p.mipmaps[N]:p.image;if(C!==null)j=C.max.x-C.min.x,X=C.max.y-C.min.y,Q=C.isBox3?C.max.z-C.min.z:1,te=C.min.x,fe=C.min.y,le=C.isBox3?C.min.z:0;else{let qe=Math.pow(2,-O);j=Math.floor(Ae.width*qe),X=Math.floor(Ae.height*qe),p.isDataArrayTexture?Q=Ae.depth:p.isData3DTexture?Q=Math.floor(Ae.depth*qe):Q=1,te=0,fe=0,le=0}L!==null?(ce=L.x,Se=L.y,Te=L.z):(ce=0,Se=0,Te=0);let Ve=Le.convert(v.format),rt=Le.convert(v.type),ve;v.isData3DTexture?(lt.setTexture3D(v,0),ve=G.TEXTURE_3D):v.isDataArrayTexture||v.isCompressedArrayTexture?(lt.setTexture2DArray(v,0),ve=G.TEXTURE_2D_ARRAY):(lt.setTexture2D(v,0),ve=G.TEXTURE_2D),De.activeTexture(G.TEXTURE0),De.pixelStorei(G.UNPACK_FLIP_Y_WEBGL,v.flipY),De.pixelStorei(G.UNPACK_PREMULTIPLY_ALPHA_WEBGL,v.premultiplyAlpha),De.pixelStorei(G.UNPACK_ALIGNMENT,v.unpackAlignment);let ot=De.getParameter(G.UNPACK_ROW_LENGTH),Ce=De.getParameter(G.UNPACK_IMAGE_HEIGHT),Xe=De.getParameter(G.UNPACK_SKIP_PIXELS),We=De.getParameter(G.UNPACK_SKIP_ROWS),Ft=De.getParameter(G.UNPACK_SKIP_IMAGES);De.pixelStorei(G.UNPACK_ROW_LENGTH,Ae.width),De.pixelStorei(G.UNPACK_IMAGE_HEIGHT,Ae.height),De.pixelStorei(G.UNPACK_SKIP_PIXELS,te),De.pixelStorei(G.UNPACK_SKIP_ROWS,fe),De.pixelStorei(G.UNPACK_SKIP_IMAGES,le);let Tt=p.isDataArrayTexture||p.isData3DTexture,ut=v.isDataArrayTexture||v.isData3DTexture;if(p.isDepthTexture){let qe=je.get(p),At=je.get(v),Jt=je.get(qe.__renderTarget),at=je.get(At.__renderTarget);De.bindFramebuffer(G.READ_FRAMEBUFFER,Jt.__webglFramebuffer),De.bindFramebuffer(G.DRAW_FRAMEBUFFER,at.__webglFramebuffer);for(let Vt=0;Vt<Q;Vt++)Tt&&(G.framebufferTextureLayer(G.READ_FRAMEBUFFER,G.COLOR_ATTACHMENT0,je.get(p).__webglTexture,O,le+Vt),G.framebufferTextureLayer(G.DRAW_FRAMEBUFFER,G.COLOR_ATTACHMENT0,je.get(v).__webglTexture,N,Te+Vt)),G.blitFramebuffer(te,fe,te+j,fe+X,ce,Se,ce+j,Se+X,G.DEPTH_BUFFER_BIT,G.NEAREST);De.bindFramebuffer(G.READ_FRAMEBUFFER,null),De.bindFramebuffer(G.DRAW_FRAMEBUFFER,null)}else if(O!==0||p.isRenderTargetTexture||je.has(p)){let qe=je.get(p),At=je.get(v);De.bindFramebuffer(G.READ_FRAMEBUFFER,U),De.bindFramebuffer(G.DRAW_FRAMEBUFFER,W);for(let Jt=0;Jt<Q;Jt++)Tt?G.framebufferTextureLayer(G.READ_FRAMEBUFFER,G.COLOR_ATTACHMENT0,qe.__webglTexture,O,le+Jt):G.framebufferTexture2D(G.READ_FRAMEBUFFER,G.COLOR_ATTACHMENT0,G.TEXTURE_2D,qe.__webglTexture,O),ut?G.framebufferTextureLayer(G.DRAW_FRAMEBUFFER,G.COLOR_ATTACHMENT0,At.__webglTexture,N,Te+Jt):G.framebufferTexture2D(G.DRAW_FRAMEBUFFER,G.COLOR_ATTACHMENT0,G.TEXTURE_2D,At.__webglTexture,N),O!==0?G.blitFramebuffer(te,fe,te+j,fe+X,ce,Se,ce+j,Se+X,G.COLOR_BUFFER_BIT,G.NEAREST):ut?G.copyTexSubImage3D(ve,N,ce,Se,Te+Jt,te,fe,j,X):G.copyTexSubImage2D(ve,N,ce,Se,te,fe,j,X);De.bindFramebuffer(G.READ_FRAMEBUFFER,null),De.bindFramebuffer(G.DRAW_FRAMEBUFFER,null)}else ut?p.isDataTexture||p.isData3DTexture?G.texSubImage3D(ve,N,ce,Se,Te,j,X,Q,Ve,rt,Ae.data):v.isCompressedArrayTexture?G.compressedTexSubImage3D(ve,N,ce,Se,Te,j,X,Q,Ve,Ae.data):G.texSubImage3D(ve,N,ce,Se,Te,j,X,Q,Ve,rt,Ae):p.isDataTexture?G.texSubImage2D(G.TEXTURE_2D,N,ce,Se,j,X,Ve,rt,Ae.data):p.isCompressedTexture?G.compressedTexSubImage2D(G.TEXTURE_2D,N,ce,Se,Ae.width,Ae.height,Ve,Ae.data):G.texSubImage2D(G.TEXTURE_2D,N,ce,Se,j,X,Ve,rt,Ae);De.pixelStorei(G.UNPACK_ROW_LENGTH,ot),De.pixelStorei(G.UNPACK_IMAGE_HEIGHT,Ce),De.pixelStorei(G.UNPACK_SKIP_PIXELS,Xe),De.pixelStorei(G.UNPACK_SKIP_ROWS,We),De.pixelStorei(G.UNPACK_SKIP_IMAGES,Ft),N===0&&v.generateMipmaps===!0&&v.mipmapsAutoUpdate===!0&&G.generateMipmap(ve),De.unbindTexture()},this.initRenderTarget=function(p){je.get(p).__webglFramebuffer===void 0&&lt.setupRenderTarget(p)},this.initTexture=function(p){p.isCubeTexture?lt.setTextureCube(p,0):p.isData3DTexture?lt.setTexture3D(p,0):p.isDataArrayTexture||p.isCompressedArrayTexture?lt.setTexture2DArray(p,0):lt.setTexture2D(p,0),De.unbindTexture()},this.resetState=function(){K=0,$=0,xe=null,De.reset(),Be.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return Wi}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(e){this._outputColorSpace=e;let t=this.getContext();t.drawingBufferColorSpace=Rt._getDrawingBufferColorSpace(e),t.unpackColorSpace=Rt._getUnpackColorSpace()}};var gi=class extends Error{},x2={png:"image/png",svg:"image/svg+xml"};function Gg(i){let e=i.getElementById("atlas-files"),t=e?.textContent?JSON.parse(e.textContent):null,n=t?b2(t):w2("atlas/");return v2(n,async(r,s)=>{let o=x2[r.split(".").pop()??""]??"application/octet-stream";return t?URL.createObjectURL(new Blob([await s(r)],{type:o})):`atlas/${r}`})}function v2(i,e){let t=new Map,n=async s=>{let o=await i(s);if(!o)throw new gi(`The atlas's file ${s} is missing. Copy the atlas again, or make it anew.`);let a=t.get(s),l=a?await y2(o):null;if(l&&l!==a)throw new gi(`The atlas's file ${s} is damaged: it is not what atlas.json says. Copy the atlas again, or make it anew.`);return o},r=(s,o)=>{try{return JSON.parse(new TextDecoder().decode(o))}catch{throw new gi(`The atlas's file ${s} is damaged: it is no JSON. Copy the atlas again, or make it anew.`)}};return{bytes:n,expect:s=>s.forEach(({path:o,sha256:a})=>a&&t.set(o,a)),json:async s=>r(s,await n(s)),optionalJson:async s=>{let o=await i(s);return o?r(s,o):null},url:s=>e(s,n)}}async function y2(i){if(!globalThis.crypto?.subtle)return null;let e=await crypto.subtle.digest("SHA-256",i);return Array.from(new Uint8Array(e),t=>t.toString(16).padStart(2,"0")).join("")}function b2(i){return async e=>{let t=i[e];if(t===void 0)return null;let n=atob(t),r=new Uint8Array(n.length);for(let s=0;s<n.length;s++)r[s]=n.charCodeAt(s);return r}}var w2=i=>async e=>{let t;try{t=await fetch(`${i}${e.split("/").map(encodeURIComponent).join("/")}`)}catch{throw new gi(`The atlas's file ${e} cannot be reached. Is what serves this page still running?`)}if(t.status===404)return null;if(!t.ok)throw new gi(`The atlas's file ${e} cannot be read (status ${t.status}).`);return new Uint8Array(await t.arrayBuffer())};var Sn=class extends Error{},S2=20000630,Wg=16384;async function Xg(i){try{return await M2(i)}catch(e){throw e instanceof Sn?e:new Sn(e instanceof RangeError?"it ends too early":`it is damaged (${String(e)})`)}}async function M2(i){let e=new DataView(i.buffer,i.byteOffset,i.byteLength);if(e.getUint32(0,!0)!==S2)throw new Sn("it is no EXR image");if(e.getUint32(4,!0)&6656)throw new Sn("it has tiles, deep samples or several parts, which are not read");let t=T2(i,e,8),{channels:n,compression:r,width:s,height:o}=t,l={0:1,2:1,3:16}[r];if(!l)throw new Sn(`its compression (${r}) is not read: ZIP is`);let c=n.reduce((m,b)=>m+b.bytes,0),u=n.map(m=>m.bytes===2?new Uint16Array(s*o):new Float32Array(s*o)),h=Math.ceil(o/l),f=Array.from({length:h},async(m,b)=>{let g=Number(e.getBigUint64(t.end+8*b,!0)),_=e.getInt32(g,!0)-t.top,S=e.getUint32(g+4,!0);if(_<0||_>=o||_%l)throw new Sn("its rows are out of place");let T=Math.min(l,o-_),M=T*s*c,P=i.subarray(g+8,g+8+S);if(P.length<S)throw new Sn("it ends too early");let R=r===0||S===M?P:R2(await E2(P,M));if(R.length!==M)throw new Sn("it is damaged: rows of a wrong length");return C2(R,n,u,{row:_,rows:T,width:s}),T});if((await Promise.all(f)).reduce((m,b)=>m+b,0)!==o)throw new Sn("rows are missing");return{width:s,height:o,channels:n.map(m=>m.name),half:n.every(m=>m.bytes===2),planes:u}}function T2(i,e,t){let n=t,r=()=>{let m=i.indexOf(0,n);if(m<0)throw new Sn("it ends too early");let b=new TextDecoder().decode(i.subarray(n,m));return n=m+1,b},s=[],o=-1,a=[];for(let m=r();m!=="";m=r()){r();let b=e.getUint32(n,!0),g=n+4;if(n=g,m==="channels"?s=A2(e,r,()=>n,_=>n=_):m==="compression"?o=e.getUint8(g):m==="dataWindow"&&(a=[0,4,8,12].map(_=>e.getInt32(g+_,!0))),n=g+b,n>i.length)throw new Sn("it ends too early")}if(!s.length||a.length!==4)throw new Sn("its header lacks what every image has");let[l,c,u,h]=a,[f,d]=[u-l+1,h-c+1];if(!(f>0&&d>0&&f<=Wg&&d<=Wg))throw new Sn(`its size, ${f} x ${d}, is not that of a table`);return{channels:s,compression:o,width:f,height:d,top:c,end:n}}function A2(i,e,t,n){let r=[];for(let s=e();s!=="";s=e()){let o=i.getUint32(t(),!0);if(o!==1&&o!==2)throw new Sn(`its channel ${s} holds whole numbers`);let a=[i.getUint32(t()+8,!0),i.getUint32(t()+12,!0)];if(a[0]!==1||a[1]!==1)throw new Sn(`its channel ${s} is subsampled`);r.push({name:s,bytes:o===1?2:4}),n(t()+16)}return r}async function E2(i,e){let t=new Blob([i]).stream().pipeThrough(new DecompressionStream("deflate")),n=new Uint8Array(e),r=0,s=t.getReader();for(;;){let{done:o,value:a}=await s.read();if(o)break;if(r+a.length>e)throw new Sn("it is damaged: more data than pixels");n.set(a,r),r+=a.length}if(r!==e)throw new Sn("it is damaged: less data than pixels");return n}function R2(i){for(let n=1;n<i.length;n++)i[n]=i[n-1]+i[n]-128;let e=new Uint8Array(i.length),t=i.length+1>>1;for(let n=0;n<i.length;n++)e[n]=i[n%2?t+(n>>1):n>>1];return e}function C2(i,e,t,{row:n,rows:r,width:s}){let o=new DataView(i.buffer,i.byteOffset,i.byteLength),a=0;for(let l=n;l<n+r;l++)e.forEach(({bytes:c},u)=>{let h=t[u],f=l*s;if(c===2)for(let d=0;d<s;d++,a+=2)h[f+d]=o.getUint16(a,!0);else for(let d=0;d<s;d++,a+=4)h[f+d]=o.getFloat32(a,!0)})}var qg=new DataView(new ArrayBuffer(4));function Ed(i){qg.setFloat32(0,i);let e=qg.getUint32(0),t=e>>>16&32768,n=e>>>23&255,r=e&8388607;if(n===255)return t|31744|(r?512:0);let s=n-127;if(s>15)return t|31744;if(s<-25)return t;let o=r|8388608,a=s>=-14?13:13+(-14-s),l=Math.floor(o/2**a),c=o-l*2**a,u=2**(a-1),h=c>u||c===u&&l%2===1?1:0,f=s>=-14?(s+15-1)*1024:0;return t|f+l+h}function Rd(i){let e=i&32768?-1:1,t=i>>>10&31,n=i&1023;return t===31?n?NaN:e*(1/0):t===0?e*n*2**-24:e*(1024+n)*2**(t-25)}var ju=256,I2=12;function P2(i){return i===0||!Number.isFinite(i)?1:2**Math.min(127,Math.max(-126,Math.ceil(Math.log2(i))-I2))}function kl(i){let[e,t,n]=i==="ideal"?[0,1,0]:"dielectric"in i?[i.dielectric.n<1?2:1,i.dielectric.n,0]:[2,i.conductor.n,i.conductor.k];return{material:e,index_n:t,index_k:n,permittivity:[t*t-n*n,2*t*n]}}var Zg=i=>i==="vector"?1:0;async function Qu(i,e,t,n){let r=`${e}/${t.file}`,s=await i.bytes(r);try{let o=await Xg(s);for(let a of["R","G","B"])if(!o.channels.includes(a))throw new Sn(`it has no channel ${a}`);if(o.width!==n[0]||o.height!==n[1])throw new Sn(`it is ${o.width} x ${o.height} and not ${n[0]} x ${n[1]} texels large`);return o}catch(o){let a=o instanceof Sn?o.message:String(o);throw new gi(`The atlas's file ${r} is damaged: ${a}. Copy the atlas again, or make it anew.`)}}var zl=(i,e)=>i.planes[i.channels.indexOf(e)];function Kg(i,e){if(i.every(o=>o instanceof Uint16Array))return{scale:e,bits:i};let t=i.map(o=>o instanceof Uint16Array?Float32Array.from(o,Rd):o),n=0;for(let o of t)for(let a of o)n=Math.max(n,Math.abs(a));let r=P2(n*e),s=e/r;return{scale:r,bits:t.map(o=>Uint16Array.from(o,a=>Ed(a*s)))}}var Jg=()=>({width:1,height:1,count:1,texels:new Uint16Array(4),scales:new Float32Array(ju)});function jg(i,e,t,n){if(t>ju)throw new gi(`The atlas has ${t} tables for a specimen; the page takes ${ju}.`);let r=new Uint16Array(4*i*e*t);return{width:i,height:e,count:t,texels:r,scales:new Float32Array(Math.max(n,ju))}}async function Yg(i,e,t,n,r,s){let[o,a]=n,l=jg(o,a,t.length+r,t.length);return await Promise.all(t.map(async(c,u)=>{let h=await Qu(i,e,c,n),{scale:f,bits:d}=Kg([zl(h,"R"),zl(h,"G"),zl(h,"B")],c.scale);Cd(l,u,d,[0,1,2]),l.scales[u]=f,s()})),l}function Cd(i,e,t,n){let r=i.width*i.height,s=4*r*e;t.forEach((o,a)=>{for(let l=0,c=s+n[a];l<r;l++,c+=4)i.texels[c]=o[l]})}async function $g(i,e,t,n,r,s){let o=jg(r[0],r[1],Math.ceil(n/4),n);return await Promise.all(t.map(async(a,l)=>{let c=await Qu(i,e,a,r);["R","G","B"].forEach((u,h)=>{let f=3*l+h;if(f>=n)return;let{scale:d,bits:m}=Kg([zl(c,u)],a.scale);Cd(o,Math.floor(f/4),m,[f%4]),o.scales[f]=d}),s()})),o}var Qg=(i,e)=>{let t=zl(i,e);return t instanceof Float32Array?t:Float32Array.from(t,Rd)};async function e_(i,e,t,n){let r=await Qu(i,e,t,n),s=new Float32Array(4*n[0]*n[1]);return["R","G","B"].forEach((o,a)=>{Qg(r,o).forEach((l,c)=>s[4*c+a]=l*t.scale)}),{width:n[0],height:n[1],texels:s}}async function t_(i,e,t){let{tables:n,optics:r,pigment:s}=e,{lobe:o,served:a}=n,l=e.name;if(n.tables.length===0)return null;let c=n.tables.length+(o?1+(o.cross?.patches.length??0):0),u=0,h=()=>t(++u/c),f=[n.u.samples,n.v.samples],[d,m,b]=await Promise.all([Yg(i,l,n.tables,f,a?1:0,h),o?.cross?Yg(i,l,o.cross.patches,[o.cross.u.samples,o.cross.v.samples],0,h):Jg(),o?e_(i,l,o.coherent,[o.radius.samples,o.t.samples]):{width:1,height:1,texels:new Float32Array(4)}]);if(a){let _=await Qu(i,l,a.range,f),S=a.range.scale,T=["R","G","B"].map(M=>Uint16Array.from(Qg(_,M),P=>Ed(P*S)));Cd(d,n.tables.length,T,[0,1,2])}return{params:{basis:n.basis==="taylor"?1:0,table_count:n.tables.length,cross_count:o?.cross?.patches.length??0,...kl(r.material),shadowing:r.shadowing?1:0,radius_max:o?.radius_max??0,restricted:a?1:0,grid_last:(a?.size??f[0])-1,first_column:a?.first[1]??0,first_row:a?.first[0]??0,factor:Zg(r.factor),look_up:0,pigment:s?[...s.xyz_per_sr,1]:[0,0,0,0],table_scales:d.scales,cross_scales:m.scales},tables:d,cross:m,lobe:b}}async function n_(i,e,t){let{spectral:n,optics:r}=e;if(!n)return null;let s=Math.round(4/n.shortest_nm/(n.xi_per_nm.last-n.xi_per_nm.first)*(n.xi_per_nm.samples-1))+1;if(s!==n.xi_per_nm.samples)throw new gi(`The spectral tables of ${e.name} do not reach as far as their wavelengths ask for.`);let o=n.lobe?.cross??null,a=n.images.length+(n.lobe?1:0)+(o?.images.length??0),l=0,c=()=>t(++l/a),u=e.name,[h,f,d]=await Promise.all([$g(i,u,n.images,n.tables,[s,n.eta_per_nm.samples],c),o?$g(i,u,o.images,o.patches,[o.xi_per_nm.samples,o.eta_per_nm.samples],c):Jg(),n.lobe?e_(i,u,n.lobe.power,[n.lobe.half_abs_w.samples,1]):{width:1,height:1,texels:new Float32Array(4)}]);return{params:{table_layers:h.count,cross_layers:o?f.count:0,lobe_count:n.lobe?.half_abs_w.samples??0,...kl(r.material),factor:Zg(r.factor),shadowing:r.shadowing?1:0,shortest_nm:n.shortest_nm,lobe_sigma_nm:n.lobe?.sigma_nm??0,cross_radius:o?o.xi_per_nm.last*n.shortest_nm:0,of_source:n.lobe?.sigma_grows?1:0,look_up:0,table_scales:h.scales,cross_scales:f.scales},tables:h,cross:f,lobe:d}}var i_=i=>i.json("atlas.json"),r_=(i,e)=>i.json(`${e}/specimen.json`);var L2=[.8566748838545029,.733891856627126,.6287067210378086,.5385972572236101],N2=.38196601125010515,s_=i=>i-Math.floor(i),Vl=(i,e)=>i[0]*e[0]+i[1]*e[1]+i[2]*e[2];function wi(i){let e=Math.hypot(...i);return[i[0]/e,i[1]/e,i[2]/e]}var Id=i=>L2.map(e=>s_(.5+e*i));function eh(i,e){return e<=1?[0,0]:[(i+.5)/e,2*Math.PI*s_(N2*i)]}function o_(i,e){if(e<=1)return[0,0];let[t,n]=Id(i);return[t-.5,n-.5]}function D2([i,e,t],n){if(t<-1+1e-12)return[n[0],-n[1],-n[2]];let r=1/(1+t),s=[1-i*i*r,-i*e*r,-i],o=[-i*e*r,1-e*e*r,-e];return[0,1,2].map(a=>n[0]*s[a]+n[1]*o[a]+n[2]*[i,e,t][a])}function th(i,e,[t,n]){let r=.5*e*Math.PI/180,s=t*2*Math.sin(.5*r)**2,o=Math.sqrt(s*(2-s));return D2(wi(i),[o*Math.cos(n),o*Math.sin(n),1-s])}function a_(i,e,t){let n=wi(i),r=0;for(let s=0;s<t;s++)r+=Vl(th(n,e,eh(s,t)),n);return t/r}var _o=`
in vec3 position;
out vec2 v_clip;
void main() {
  v_clip = position.xy;
  gl_Position = vec4(position.xy, 0.0, 1.0);
}
`,F2=`
uniform highp sampler2D u_sky_map;
uniform highp sampler2D u_sky_rows;
// The integral of the radiance over directions; 0 without surroundings.
uniform float u_sky;
uniform vec2 u_spin;
uniform float u_index;
const float SKY_LEVEL = 3e-3;
const float SKY_REACH = 2.0;

vec2 even_point(float index) {
  vec2 pixel = gl_FragCoord.xy;
  vec2 own = fract(sin(vec2(dot(pixel, vec2(12.9898, 78.233)), dot(pixel, vec2(39.346, 11.135)))) * 43758.5453);
  return fract(own + index * vec2(0.7548776662, 0.5698402910));
}

float row_edge(int row) { return cos(3.14159265 * float(row) / float(textureSize(u_sky_map, 0).y)); }

vec3 direction_by_light(vec2 point) {
  ivec2 size = textureSize(u_sky_map, 0);
  float target = point.y * u_sky;
  int low = 0;
  int high = size.y - 1;
  while (low < high) {
    int middle = (low + high) / 2;
    if (texelFetch(u_sky_rows, ivec2(middle, 0), 0).r <= target) low = middle + 1;
    else high = middle;
  }
  int row = low;
  float below = row == 0 ? 0.0 : texelFetch(u_sky_rows, ivec2(row - 1, 0), 0).r;
  float down = clamp((target - below) / (texelFetch(u_sky_rows, ivec2(row, 0), 0).r - below), 0.0, 1.0);
  low = 0;
  high = size.x - 1;
  while (low < high) {
    int middle = (low + high) / 2;
    if (texelFetch(u_sky_map, ivec2(middle, row), 0).g <= point.x) low = middle + 1;
    else high = middle;
  }
  float before = low == 0 ? 0.0 : texelFetch(u_sky_map, ivec2(low - 1, row), 0).g;
  float share = clamp((point.x - before) / max(texelFetch(u_sky_map, ivec2(low, row), 0).g - before, 1e-12), 0.0, 1.0);
  float y = mix(row_edge(row), row_edge(row + 1), down);
  float turn = 6.28318531 * ((float(low) + share) / float(size.x) - 0.5);
  float side = sqrt(max(0.0, 1.0 - y * y));
  return vec3(-side * sin(turn), y, side * cos(turn));
}

float sky_radiance(vec3 d) {
  ivec2 size = textureSize(u_sky_map, 0);
  int row = int(acos(clamp(d.y, -1.0, 1.0)) / 3.14159265 * float(size.y));
  float turns = atan(-d.x, d.z) / 6.28318531 + 0.5;
  return texelFetch(u_sky_map, ivec2(min(int(fract(turns) * float(size.x)), size.x - 1), min(row, size.y - 1)), 0).r;
}

// The object may have been turned about the vertical: the surroundings stay.
vec3 from_sky(vec3 d) { return vec3(u_spin.x * d.x - u_spin.y * d.z, d.y, u_spin.x * d.z + u_spin.y * d.x); }
vec3 to_sky(vec3 d) { return vec3(u_spin.x * d.x + u_spin.y * d.z, d.y, u_spin.x * d.z - u_spin.y * d.x); }

void add_sky(vec3 t, vec3 b, vec3 n, vec3 wo) {
  float ratio = 1.0 + SKY_REACH * SKY_REACH / (SKY_LEVEL * SKY_LEVEL);
  for (int k = 0; k < 2; k++) {
    vec2 point = even_point(2.0 * u_index + float(k));
    vec3 wi;
    if (k == 0) {
      vec3 d = from_sky(direction_by_light(point));
      wi = vec3(dot(t, d), dot(b, d), dot(n, d));
    } else {
      float distance = SKY_LEVEL * sqrt(pow(ratio, point.x) - 1.0);
      vec2 xy = distance * vec2(cos(6.28318531 * point.y), sin(6.28318531 * point.y)) - wo.xy;
      wi = vec3(xy, sqrt(max(0.0, 1.0 - dot(xy, xy))));
    }
    if (!(wi.z > 0.0)) continue;
    float radiance = sky_radiance(to_sky(wi.x * t + wi.y * b + wi.z * n));
    vec2 off = wi.xy + wo.xy;
    float by_lobe = wi.z / (3.14159265 * log(ratio) * (dot(off, off) + SKY_LEVEL * SKY_LEVEL));
    float irradiance = radiance / (radiance / u_sky + by_lobe);
    if (radiance > 0.0) sum += reflected(wi, wo) * irradiance * wi.z;
  }
}
`,l_=`
layout(location = 0) out highp vec4 out_value;
uniform int u_output;
uniform int u_active;
uniform int u_lights;
uniform vec4 u_light[4];
uniform vec2 u_turn;
struct Point {
  vec3 tangent;
  vec3 bitangent;
  vec3 normal;
  vec3 to_viewer;
};

vec3 sum = vec3(0.0);
vec4 directions = vec4(9.0);
// Whether there is anything here to be seen, lit or not.
bool seen = false;

float lit(int light);

void add(int light, vec3 wi, vec3 wo, float weight) {
  if (!(wi.z > 0.0 && wo.z > 0.0)) return;
  if (u_output == 1) {
    if (light == u_active) directions = vec4(wi.xy, wo.xy);
    return;
  }
  sum += reflected(wi, wo) * weight;
}

void finish() {
  out_value = u_output == 1 ? directions : vec4(sum, !seen ? -1.0 : answered ? 0.0 : 1.0);
}

${F2}
void shade(Point p) {
  seen = true;
  vec3 t = u_turn.x * p.tangent + u_turn.y * p.bitangent;
  vec3 b = u_turn.x * p.bitangent - u_turn.y * p.tangent;
  vec3 wo = vec3(dot(t, p.to_viewer), dot(b, p.to_viewer), dot(p.normal, p.to_viewer));
  for (int i = 0; i < 4; i++) {
    if (i >= u_lights) break;
    vec3 direction = u_light[i].xyz;
    vec3 wi = vec3(dot(t, direction), dot(b, direction), dot(p.normal, direction));
    if (wi.z > 0.0 && wo.z > 0.0) {
      float open = lit(i);
      if (open > 0.0) add(i, wi, wo, u_light[i].w * wi.z * open);
    }
  }
  if (u_sky > 0.0 && u_output == 0 && wo.z > 0.0) add_sky(t, b, p.normal, wo);
}
`,Pd=`
float lit(int light) { return 1.0; }
`,Ld=`
in vec2 v_clip;
uniform mat4 u_from_clip;
void camera_ray(out vec3 origin, out vec3 direction) {
  vec4 near = u_from_clip * vec4(v_clip, -1.0, 1.0);
  vec4 far = u_from_clip * vec4(v_clip, 1.0, 1.0);
  origin = near.xyz / near.w;
  direction = normalize(far.xyz / far.w - origin);
}
`;var Nd=Math.PI/180,Dd=.95,Fd={position:[0,0,5],target:[0,0,0],parallel:!0,half:1,near:1,far:9};function Ud({tilt_deg:i}){let[e,t]=[Math.sin(i*Nd),Math.cos(i*Nd)];return{tangent:[1,0,0],bitangent:[0,t,-e],normal:[0,e,t]}}var U2=1.04;function c_(i){let{tangent:e,bitangent:t}=Ud(i),n=.5*i.width_mm,r=0;for(let o of[-n,n])for(let a of[-n,n]){let l=e.map((u,h)=>o*u+a*t[h]),c=i.distance_mm/(i.distance_mm-l[2]);r=Math.max(r,c*Math.abs(l[0]),c*Math.abs(l[1]))}let{distance_mm:s}=i;return{position:[0,0,s],target:[0,0,0],parallel:!1,half:U2*r/s,near:.05*s,far:4*s}}var nh={position:[.02,.08,6],target:[.02,.08,0],parallel:!1,half:Math.tan(.5*17.4*Nd),near:3,far:9};var u_=`
${Ld}
${Pd}
void main() {
  vec3 origin, direction;
  camera_ray(origin, direction);
  float along = dot(origin, direction);
  vec3 nearest = origin - along * direction;
  float apart2 = dot(nearest, nearest);
  float radius2 = ${(Dd*Dd).toFixed(8)};
  if (apart2 < radius2) {
    vec3 place = nearest - sqrt(radius2 - apart2) * direction;
    vec3 normal = normalize(place);
    vec3 east = vec3(normal.z, 0.0, -normal.x);
    float size = length(east);
    vec3 tangent = size > 1e-9 ? east / size : vec3(1.0, 0.0, 0.0);
    shade(Point(tangent, cross(normal, tangent), normal, -direction));
  }
  finish();
}
`,h_=`
${Ld}
${Pd}
uniform vec3 u_tangent;
uniform vec3 u_bitangent;
uniform vec3 u_normal;
uniform float u_half_width;
void main() {
  vec3 origin, direction;
  camera_ray(origin, direction);
  float approach = -dot(u_normal, direction);
  if (approach > 0.0) {
    vec3 place = origin + direction * (dot(u_normal, origin) / approach);
    if (max(abs(dot(u_tangent, place)), abs(dot(u_bitangent, place))) <= u_half_width) {
      shade(Point(u_tangent, u_bitangent, u_normal, -direction));
    }
  }
  finish();
}
`;var f_=`
in vec2 v_clip;
uniform vec2 u_extent;
uniform vec2 u_offset;
vec2 picture_place() { return v_clip * u_extent + u_offset; }
float lit(int light) { return 1.0; }
`,d_=`
${f_}
uniform vec3 u_wi;
void main() {
  vec2 at = picture_place();
  float cos2 = 1.0 - dot(at, at);
  if (cos2 > 0.0) {
    seen = true;
    add(0, u_wi, vec3(at, sqrt(cos2)), 1.0);
  }
  finish();
}
`,p_=`
${f_}
uniform vec3 u_sample_normal;
uniform float u_distance;
uniform float u_half_width;
uniform float u_hole_radius;
uniform vec3 u_beam_point;
uniform vec3 u_beam_wi;
uniform float u_beam_power;
void main() {
  vec2 at = picture_place() * u_half_width;
  seen = max(abs(at.x), abs(at.y)) <= u_half_width;
  if (seen && length(at) >= u_hole_radius) {
    vec3 path = vec3(at, u_distance) - u_beam_point;
    float r2 = dot(path, path);
    vec3 to_screen = path / sqrt(r2);
    vec3 t = vec3(u_sample_normal.z, 0.0, -u_sample_normal.x);
    vec3 tt = u_turn.x * t + u_turn.y * vec3(0.0, 1.0, 0.0);
    vec3 bb = u_turn.x * vec3(0.0, 1.0, 0.0) - u_turn.y * t;
    vec3 wo = vec3(dot(tt, to_screen), dot(bb, to_screen), dot(u_sample_normal, to_screen));
    vec3 wi = vec3(u_turn.x * u_beam_wi.x + u_turn.y * u_beam_wi.y, u_turn.x * u_beam_wi.y - u_turn.y * u_beam_wi.x, u_beam_wi.z);
    add(0, wi, wo, u_beam_power * wo.z * to_screen.z / r2);
  }
  finish();
}
`;var ih=Math.PI/180;function xa(i,e){return i>=e?[i/e,1]:[1,e/i]}function va([i,e,t],n){let[r,s]=[Math.sin(n*ih),Math.cos(n*ih)];return[i*s+t*r,e,t*s-i*r]}function m_(i,e,[t,n]){let r=new it().makeRotationY((e.view.azimuth_deg-e.spin_deg)*ih).multiply(new it().makeRotationX(-e.view.elevation_deg*ih)),s=new J(...i.target),o=new J(...i.position).sub(s).applyMatrix4(r),a=new J(0,1,0).applyMatrix4(r),l=s.clone().add(o),c=new it().lookAt(l,s,a).setPosition(l),u=i.half/e.view.zoom,h=new it;if(i.parallel)h.makeOrthographic(-u*t,u*t,u*n,-u*n,i.near,i.far);else{let f=u*i.near;h.makePerspective(-f*t,f*t,f*n,-f*n,i.near,i.far)}return h.multiply(c.invert())}function g_(i,[e,t],n){return new it().makeScale(n,n,1).multiply(new it().makeTranslation(-e,-t,0)).multiply(i)}var __=`#version 300 es

precision highp float;
precision highp int;

struct Front {
    uint material;
    uint factor;
    uint shadowing;
    vec2 index;
    vec2 permittivity;
};
struct SpectralParams {
    uint table_layers;
    uint cross_layers;
    uint lobe_count;
    uint material;
    uint factor;
    uint shadowing;
    float index_n;
    float index_k;
    vec2 permittivity;
    float shortest_nm;
    float lobe_sigma_nm;
    float cross_radius;
    uint of_source;
    uint look_up;
    vec4 table_scales[64];
    vec4 cross_scales[64];
};
struct SplinePlaces {
    vec2 first;
    vec2 second;
    vec2 share;
};
const uint IDEAL = 0u;
const uint DIELECTRIC = 1u;
const uint CONDUCTOR = 2u;
const uint SCALAR = 0u;
const uint VECTOR = 1u;
const float NO_ANSWER = -1.0;
const float SHORTEST_SLACK = 1e-6;
const uint SPLINES = 1u;
const uint LINEAR = 0u;

layout(std140) uniform SpectralParams_block_0Fragment { SpectralParams _group_0_binding_0_fs; };

uniform highp sampler2DArray _group_0_binding_1_fs;

uniform highp sampler2DArray _group_0_binding_2_fs;

uniform highp sampler2D _group_0_binding_3_fs;

smooth in vec3 _vs2fs_location0;
smooth in vec3 _vs2fs_location1;
smooth in float _vs2fs_location2;
layout(location = 0) out vec4 _fs2p_location0;

vec3 wave_vector_change(vec3 wi_1, vec3 wo_1) {
    return (-(wi_1) - wo_1);
}

float geometry_factor(vec3 wi_2, vec3 wo_2) {
    float one_plus = (1.0 + dot(wi_2, wo_2));
    return ((one_plus / wi_2.z) * (one_plus / wo_2.z));
}

float v_cavity_shadowing(vec3 wi_3, vec3 wo_3) {
    vec3 sum_4 = (wi_3 + wo_3);
    vec3 m = (sum_4 / vec3(sqrt(dot(sum_4, sum_4))));
    float wo_m = dot(wo_3, m);
    if (!((wo_m > 0.0))) {
        return 0.0;
    }
    float scale = ((2.0 * m.z) / wo_m);
    return clamp(min((scale * wo_3.z), (scale * wi_3.z)), 0.0, 1.0);
}

vec2 complex_product(vec2 a, vec2 b) {
    return vec2(((a.x * b.x) - (a.y * b.y)), ((a.x * b.y) + (a.y * b.x)));
}

vec2 complex_quotient(vec2 a_1, vec2 b_1) {
    vec2 _e6 = complex_product(a_1, vec2(b_1.x, -(b_1.y)));
    return (_e6 / vec2(dot(b_1, b_1)));
}

vec2 complex_root(vec2 a_2) {
    float larger = sqrt((0.5 * (sqrt(dot(a_2, a_2)) + abs(a_2.x))));
    if ((larger == 0.0)) {
        return vec2(0.0, 0.0);
    }
    float smaller = ((0.5 * abs(a_2.y)) / larger);
    float turn = ((a_2.y >= 0.0) ? 1.0 : -1.0);
    if ((a_2.x >= 0.0)) {
        return vec2(larger, (turn * smaller));
    }
    return vec2(smaller, (turn * larger));
}

float reflectance(Front front, float cos_theta_d) {
    if ((front.material == IDEAL)) {
        return 1.0;
    }
    vec2 index_2 = front.index;
    float cos_i = clamp(cos_theta_d, 0.0, 1.0);
    vec2 _e15 = complex_product(index_2, index_2);
    vec2 _e16 = complex_quotient(vec2((1.0 - (cos_i * cos_i)), 0.0), _e15);
    vec2 _e21 = complex_root((vec2(1.0, 0.0) - _e16));
    vec2 _e22 = complex_product(index_2, _e21);
    vec2 along = vec2(cos_i, 0.0);
    vec2 _e27 = complex_quotient((along - _e22), (along + _e22));
    vec2 _e32 = complex_quotient(((index_2 * cos_i) - _e21), ((index_2 * cos_i) + _e21));
    return (0.5 * (dot(_e27, _e27) + dot(_e32, _e32)));
}

float cos_half_angle(vec3 wi_4, vec3 wo_4) {
    return sqrt(max((0.5 + (0.5 * dot(wi_4, wo_4))), 0.0));
}

float shadowing(Front front_1, vec3 wi_5, vec3 wo_5) {
    if ((front_1.shadowing == 0u)) {
        return 1.0;
    }
    float _e7 = v_cavity_shadowing(wi_5, wo_5);
    return _e7;
}

float polarised_sum(Front front_2, vec3 wi_6, vec3 wo_6) {
    float cos_phi = 1.0;
    float sin2_i = dot(wi_6.xy, wi_6.xy);
    float sin2_o = dot(wo_6.xy, wo_6.xy);
    float sines = (sqrt(sin2_i) * sqrt(sin2_o));
    if ((sines > 1e-12)) {
        cos_phi = clamp((-(dot(wi_6.xy, wo_6.xy)) / sines), -1.0, 1.0);
    }
    float _e24 = cos_phi;
    float _e25 = cos_phi;
    float cos2_phi = (_e24 * _e25);
    vec2 eps = front_2.permittivity;
    if ((front_2.material == DIELECTRIC)) {
        float a_3 = sqrt(max((eps.x - sin2_i), 0.0));
        float b_2 = sqrt(max((eps.x - sin2_o), 0.0));
        float s_i = (wi_6.z + a_3);
        float s_o = (wo_6.z + b_2);
        float p_i = ((eps.x * wi_6.z) + a_3);
        float p_o = ((eps.x * wo_6.z) + b_2);
        float ss = (1.0 / (s_i * s_o));
        float sp = (b_2 / (s_i * p_o));
        float ps = (a_3 / (p_i * s_o));
        float _e61 = cos_phi;
        float pp = ((((a_3 * b_2) * _e61) - (eps.x * sines)) / (p_i * p_o));
        float contrast = ((eps.x - 1.0) * (eps.x - 1.0));
        return (contrast * ((((cos2_phi * ss) * ss) + ((1.0 - cos2_phi) * ((sp * sp) + (ps * ps)))) + (pp * pp)));
    }
    vec2 _e90 = complex_root((eps - vec2(sin2_i, 0.0)));
    vec2 _e94 = complex_root((eps - vec2(sin2_o, 0.0)));
    vec2 s_i_1 = (_e90 + vec2(wi_6.z, 0.0));
    vec2 s_o_1 = (_e94 + vec2(wo_6.z, 0.0));
    vec2 p_i_1 = ((eps * wi_6.z) + _e90);
    vec2 p_o_1 = ((eps * wo_6.z) + _e94);
    float ss_1 = (1.0 / (dot(s_i_1, s_i_1) * dot(s_o_1, s_o_1)));
    float sp_1 = (dot(_e94, _e94) / (dot(s_i_1, s_i_1) * dot(p_o_1, p_o_1)));
    float ps_1 = (dot(_e90, _e90) / (dot(p_i_1, p_i_1) * dot(s_o_1, s_o_1)));
    vec2 _e124 = complex_product(_e90, _e94);
    float _e125 = cos_phi;
    vec2 across = ((_e124 * _e125) - (eps * sines));
    float pp_1 = (dot(across, across) / (dot(p_i_1, p_i_1) * dot(p_o_1, p_o_1)));
    vec2 less = (eps - vec2(1.0, 0.0));
    return (dot(less, less) * (((cos2_phi * ss_1) + ((1.0 - cos2_phi) * (sp_1 + ps_1))) + pp_1));
}

float diffuse_factor(Front front_3, vec3 wi_7, vec3 wo_7) {
    bool local = false;
    if ((front_3.factor == VECTOR)) {
        local = (front_3.material != IDEAL);
    } else {
        local = false;
    }
    bool _e12 = local;
    if (_e12) {
        float _e18 = polarised_sum(front_3, wi_7, wo_7);
        float _e20 = shadowing(front_3, wi_7, wo_7);
        return ((((2.0 * wi_7.z) * wo_7.z) * _e18) * _e20);
    }
    float _e22 = cos_half_angle(wi_7, wo_7);
    float _e23 = reflectance(front_3, _e22);
    float _e24 = geometry_factor(wi_7, wo_7);
    float _e26 = shadowing(front_3, wi_7, wo_7);
    return ((_e23 * _e24) * _e26);
}

float coherent_factor(Front front_4, vec3 wi_8, vec3 wo_8) {
    float _e3 = cos_half_angle(wi_8, wo_8);
    float _e4 = reflectance(front_4, _e3);
    float _e5 = shadowing(front_4, wi_8, wo_8);
    float mirror = (_e4 * _e5);
    if ((front_4.factor == VECTOR)) {
        return mirror;
    }
    float w = (wi_8.z + wo_8.z);
    float _e13 = geometry_factor(wi_8, wo_8);
    return (((mirror * _e13) / w) / w);
}

float image_radius2_(vec3 wi_9, vec3 wo_9) {
    vec2 lateral = (wi_9.xy + wo_9.xy);
    float to_horizon_i = ((wi_9.z * wi_9.z) / (1.0 + length(wi_9.xy)));
    float to_horizon_o = ((wo_9.z * wo_9.z) / (1.0 + length(wo_9.xy)));
    return (dot(lateral, lateral) + ((4.0 * to_horizon_i) * to_horizon_o));
}

float max_abs_w(float rho) {
    return sqrt(max((4.0 - (rho * rho)), 0.0));
}

float normalised_abs_w(vec3 q) {
    float _e3 = max_abs_w(length(q.xy));
    if ((_e3 == 0.0)) {
        return 0.0;
    }
    return min((abs(q.z) / _e3), 1.0);
}

vec2 texel_centred(vec2 at, uvec2 size) {
    vec2 across_1 = vec2(size);
    vec2 texel = (vec2((0.5 + (0.5 * at.x)), (0.5 - (0.5 * at.y))) * (across_1 - vec2(1.0)));
    return ((texel + vec2(0.5)) / across_1);
}

Front front_of_index(vec2 index) {
    uint material = 0u;
    bool local_1 = false;
    uint _e3 = _group_0_binding_0_fs.material;
    material = _e3;
    uint _e5 = material;
    if ((_e5 != IDEAL)) {
        if ((index.y == 0.0)) {
            local_1 = (index.x >= 1.0);
        } else {
            local_1 = false;
        }
        bool _e19 = local_1;
        material = (_e19 ? DIELECTRIC : CONDUCTOR);
    }
    uint _e21 = material;
    uint _e24 = _group_0_binding_0_fs.factor;
    uint _e27 = _group_0_binding_0_fs.shadowing;
    vec2 _e28 = complex_product(index, index);
    return Front(_e21, _e24, _e27, index, _e28);
}

Front front_factor() {
    float _e2 = _group_0_binding_0_fs.index_n;
    float _e5 = _group_0_binding_0_fs.index_k;
    vec2 index_3 = vec2(_e2, _e5);
    uint _e9 = _group_0_binding_0_fs.material;
    uint _e12 = _group_0_binding_0_fs.factor;
    uint _e15 = _group_0_binding_0_fs.shadowing;
    vec2 _e18 = _group_0_binding_0_fs.permittivity;
    return Front(_e9, _e12, _e15, index_3, _e18);
}

vec4 first_four(float x) {
    float second = (((2.0 * x) * x) - 1.0);
    return vec4(1.0, x, second, (((2.0 * x) * second) - x));
}

vec4 spline_texel(SplinePlaces places, uint layer) {
    vec4 a_4 = textureLod(_group_0_binding_1_fs, vec3(places.first, layer), 0.0);
    vec4 b_3 = textureLod(_group_0_binding_1_fs, vec3(vec2(places.second.x, places.first.y), layer), 0.0);
    vec4 c = textureLod(_group_0_binding_1_fs, vec3(vec2(places.first.x, places.second.y), layer), 0.0);
    vec4 d = textureLod(_group_0_binding_1_fs, vec3(places.second, layer), 0.0);
    return mix(mix(d, c, places.share.x), mix(b_3, a_4, places.share.x), places.share.y);
}

vec4 next_four(vec4 basis, float x_1) {
    float a_5 = (((2.0 * x_1) * basis.w) - basis.z);
    float b_4 = (((2.0 * x_1) * a_5) - basis.w);
    float c_1 = (((2.0 * x_1) * b_4) - a_5);
    return vec4(a_5, b_4, c_1, (((2.0 * x_1) * c_1) - b_4));
}

float expansion_by_splines(SplinePlaces places_1, float t) {
    vec4 basis_1 = vec4(0.0);
    float sum = 0.0;
    uint layer_1 = 0u;
    vec4 _e6 = first_four(((2.0 * t) - 1.0));
    basis_1 = _e6;
    bool loop_init = true;
    while(true) {
        if (!loop_init) {
            uint _e35 = layer_1;
            layer_1 = (_e35 + 1u);
        }
        loop_init = false;
        uint _e12 = layer_1;
        uint _e15 = _group_0_binding_0_fs.table_layers;
        if ((_e12 < _e15)) {
        } else {
            break;
        }
        {
            float _e17 = sum;
            vec4 _e18 = basis_1;
            uint _e21 = layer_1;
            vec4 _e23 = _group_0_binding_0_fs.table_scales[_e21];
            uint _e25 = layer_1;
            vec4 _e26 = spline_texel(places_1, _e25);
            sum = (_e17 + dot((_e18 * _e23), _e26));
            vec4 _e29 = basis_1;
            vec4 _e34 = next_four(_e29, ((2.0 * t) - 1.0));
            basis_1 = _e34;
        }
    }
    float _e38 = sum;
    return _e38;
}

SplinePlaces spline_places(vec2 uv) {
    vec2 size_1 = vec2(uvec2(textureSize(_group_0_binding_1_fs, 0).xy));
    vec2 texel_1 = ((uv * size_1) - vec2(0.5));
    vec2 whole = floor(texel_1);
    vec2 f = (texel_1 - whole);
    vec2 g = (vec2(1.0) - f);
    vec2 before = (((g * g) * g) / vec2(6.0));
    vec2 last = (((f * f) * f) / vec2(6.0));
    vec2 nearest = ((vec2(0.6666667) - (f * f)) + (3.0 * last));
    vec2 share = (before + nearest);
    vec2 first = ((whole - vec2(1.0)) + (nearest / share));
    vec2 second_1 = ((whole + vec2(1.0)) + (last / (vec2(1.0) - share)));
    return SplinePlaces(((first + vec2(0.5)) / size_1), ((second_1 + vec2(0.5)) / size_1), share);
}

float expansion(vec2 at_1, float t_1) {
    vec4 basis_2 = vec4(0.0);
    float sum_1 = 0.0;
    uint layer_2 = 0u;
    vec2 _e4 = texel_centred(at_1, uvec2(textureSize(_group_0_binding_1_fs, 0).xy));
    uint _e7 = _group_0_binding_0_fs.look_up;
    if ((_e7 == SPLINES)) {
        SplinePlaces _e10 = spline_places(_e4);
        float _e11 = expansion_by_splines(_e10, t_1);
        return _e11;
    }
    vec4 _e16 = first_four(((2.0 * t_1) - 1.0));
    basis_2 = _e16;
    bool loop_init_1 = true;
    while(true) {
        if (!loop_init_1) {
            uint _e48 = layer_2;
            layer_2 = (_e48 + 1u);
        }
        loop_init_1 = false;
        uint _e22 = layer_2;
        uint _e25 = _group_0_binding_0_fs.table_layers;
        if ((_e22 < _e25)) {
        } else {
            break;
        }
        {
            uint _e29 = layer_2;
            vec4 texel_2 = textureLod(_group_0_binding_1_fs, vec3(_e4, _e29), 0.0);
            float _e32 = sum_1;
            vec4 _e33 = basis_2;
            uint _e36 = layer_2;
            vec4 _e38 = _group_0_binding_0_fs.table_scales[_e36];
            sum_1 = (_e32 + dot((_e33 * _e38), texel_2));
            vec4 _e42 = basis_2;
            vec4 _e47 = next_four(_e42, ((2.0 * t_1) - 1.0));
            basis_2 = _e47;
        }
    }
    float _e51 = sum_1;
    return _e51;
}

vec4 lagrange_weights(float x_2) {
    float a_6 = (x_2 - 1.0);
    float b_5 = (x_2 - 2.0);
    float c_2 = (x_2 - 3.0);
    return vec4((((-(a_6) * b_5) * c_2) / 6.0), (((0.5 * x_2) * b_5) * c_2), (((-0.5 * x_2) * a_6) * c_2), (((x_2 * a_6) * b_5) / 6.0));
}

vec4 cross_texel(vec2 uv_1, uint layer_3) {
    bool local_2 = false;
    vec4 sum_2 = vec4(0.0, 0.0, 0.0, 0.0);
    int k = 0;
    ivec2 size_2 = ivec2(uvec2(textureSize(_group_0_binding_2_fs, 0).xy));
    uint _e7 = _group_0_binding_0_fs.look_up;
    if (!((_e7 == LINEAR))) {
        local_2 = (min(size_2.x, size_2.y) < 4);
    } else {
        local_2 = true;
    }
    bool _e19 = local_2;
    if (_e19) {
        vec4 _e23 = textureLod(_group_0_binding_2_fs, vec3(uv_1, layer_3), 0.0);
        return _e23;
    }
    vec2 at_2 = clamp(((uv_1 * vec2(size_2)) - vec2(0.5)), vec2(0.0, 0.0), vec2((size_2 - ivec2(1))));
    ivec2 first_1 = min(max((ivec2(at_2) - ivec2(1)), ivec2(0, 0)), (size_2 - ivec2(4)));
    vec4 _e52 = lagrange_weights((at_2.x - float(first_1.x)));
    vec4 _e57 = lagrange_weights((at_2.y - float(first_1.y)));
    bool loop_init_2 = true;
    while(true) {
        if (!loop_init_2) {
            int _e93 = k;
            k = (_e93 + 1);
        }
        loop_init_2 = false;
        int _e66 = k;
        if ((_e66 < 16)) {
        } else {
            break;
        }
        {
            int _e70 = k;
            int _e73 = k;
            vec4 texel_3 = texelFetch(_group_0_binding_2_fs, ivec3((first_1 + ivec2((_e70 % 4), (_e73 / 4))), int(layer_3)), 0);
            vec4 _e81 = sum_2;
            int _e82 = k;
            int _e86 = k;
            sum_2 = (_e81 + ((_e52[(_e82 % 4)] * _e57[(_e86 / 4)]) * texel_3));
        }
    }
    vec4 _e96 = sum_2;
    return _e96;
}

float cross_value(vec3 q_1, float t_2) {
    bool local_3 = false;
    vec4 basis_3 = vec4(0.0);
    float sum_3 = 0.0;
    uint layer_4 = 0u;
    uint _e4 = _group_0_binding_0_fs.cross_layers;
    if (!((_e4 == 0u))) {
        float _e17 = _group_0_binding_0_fs.cross_radius;
        local_3 = (max(abs(q_1.x), abs(q_1.y)) >= _e17);
    } else {
        local_3 = true;
    }
    bool _e20 = local_3;
    if (_e20) {
        return 0.0;
    }
    float _e25 = _group_0_binding_0_fs.cross_radius;
    vec2 _e30 = texel_centred((q_1.xy / vec2(_e25)), uvec2(textureSize(_group_0_binding_2_fs, 0).xy));
    vec4 _e35 = first_four(((2.0 * t_2) - 1.0));
    basis_3 = _e35;
    bool loop_init_3 = true;
    while(true) {
        if (!loop_init_3) {
            uint _e64 = layer_4;
            layer_4 = (_e64 + 1u);
        }
        loop_init_3 = false;
        uint _e41 = layer_4;
        uint _e44 = _group_0_binding_0_fs.cross_layers;
        if ((_e41 < _e44)) {
        } else {
            break;
        }
        {
            uint _e46 = layer_4;
            vec4 _e47 = cross_texel(_e30, _e46);
            float _e48 = sum_3;
            vec4 _e49 = basis_3;
            uint _e52 = layer_4;
            vec4 _e54 = _group_0_binding_0_fs.cross_scales[_e52];
            sum_3 = (_e48 + dot((_e49 * _e54), _e47));
            vec4 _e58 = basis_3;
            vec4 _e63 = next_four(_e58, ((2.0 * t_2) - 1.0));
            basis_3 = _e63;
        }
    }
    float _e67 = sum_3;
    return (_e67 / abs(q_1.z));
}

float lobe_shape(float radius2_, float wavelength_nm_1) {
    float _e4 = _group_0_binding_0_fs.lobe_sigma_nm;
    float scale_1 = ((6.2831855 * _e4) / wavelength_nm_1);
    return exp(((-(scale_1) * scale_1) * radius2_));
}

float power_texel(uint index_1) {
    uint columns = uvec2(textureSize(_group_0_binding_3_fs, 0).xy).x;
    vec4 _e11 = texelFetch(_group_0_binding_3_fs, ivec2(int((index_1 % columns)), int((index_1 / columns))), 0);
    return _e11.x;
}

float power_at(float abs_w) {
    uint _e3 = _group_0_binding_0_fs.lobe_count;
    uint last_1 = (_e3 - 1u);
    float at_3 = (clamp((0.5 * abs_w), 0.0, 1.0) * float(last_1));
    uint first_2 = min(uint(at_3), (last_1 - 1u));
    float _e17 = power_texel(first_2);
    float _e20 = power_texel((first_2 + 1u));
    return mix(_e17, _e20, (at_3 - float(first_2)));
}

float brdf_spectral_with(Front front_5, vec3 wi_10, vec3 wo_10, float wavelength_nm_2) {
    bool local_4 = false;
    bool local_5 = false;
    float shape = 0.0;
    if ((wi_10.z > 0.0)) {
        local_4 = (wo_10.z > 0.0);
    } else {
        local_4 = false;
    }
    bool _e13 = local_4;
    if (!(_e13)) {
        return 0.0;
    }
    float _e18 = _group_0_binding_0_fs.shortest_nm;
    float ratio = (_e18 / wavelength_nm_2);
    if ((ratio > 0.0)) {
        local_5 = (ratio <= 1.000001);
    } else {
        local_5 = false;
    }
    bool _e27 = local_5;
    if (!(_e27)) {
        return NO_ANSWER;
    }
    float r = min(ratio, 1.0);
    vec3 _e32 = wave_vector_change(wi_10, wo_10);
    vec3 q_2 = (r * _e32);
    float _e34 = normalised_abs_w(q_2);
    float _e35 = diffuse_factor(front_5, wi_10, wo_10);
    float _e39 = expansion((0.5 * q_2.xy), _e34);
    float _e40 = cross_value(q_2, _e34);
    float diffuse = (_e35 * (_e39 + _e40));
    float r2_ = (r * r);
    uint _e46 = _group_0_binding_0_fs.lobe_count;
    if ((_e46 == 0u)) {
        return ((r2_ * r2_) * diffuse);
    }
    uint _e53 = _group_0_binding_0_fs.of_source;
    bool grows = (_e53 == 1u);
    float _e58 = _group_0_binding_0_fs.shortest_nm;
    float lobe_nm = (grows ? _e58 : wavelength_nm_2);
    float _e63 = lobe_shape(dot(_e32.xy, _e32.xy), lobe_nm);
    shape = _e63;
    if ((front_5.factor == VECTOR)) {
        float _e68 = shape;
        float _e69 = image_radius2_(wi_10, wo_10);
        float _e70 = lobe_shape(_e69, lobe_nm);
        shape = (_e68 + _e70);
    }
    float _e76 = coherent_factor(front_5, wi_10, wo_10);
    float _e80 = power_at(abs(q_2.z));
    float _e82 = shape;
    return (((r2_ * r2_) * diffuse) + ((((grows ? 1.0 : r2_) * _e76) * _e80) * _e82));
}

float brdf_spectral(vec3 wi_11, vec3 wo_11, float wavelength_nm_3) {
    Front _e3 = front_factor();
    float _e4 = brdf_spectral_with(_e3, wi_11, wo_11, wavelength_nm_3);
    return _e4;
}

bool has_answer(float value) {
    return (value != NO_ANSWER);
}

void main() {
    vec3 wi = _vs2fs_location0;
    vec3 wo = _vs2fs_location1;
    float wavelength_nm = _vs2fs_location2;
    vec3 to_light = normalize(wi);
    float _e5 = brdf_spectral(to_light, normalize(wo), wavelength_nm);
    bool _e6 = has_answer(_e5);
    if (!(_e6)) {
        _fs2p_location0 = vec4(0.0, 0.0, 0.0, 1.0);
        return;
    }
    _fs2p_location0 = vec4((_e5 * max(to_light.z, 0.0)), 1.0, 0.0, 1.0);
    return;
}

`;var x_=`#version 300 es

precision highp float;
precision highp int;

struct Front {
    uint material;
    uint factor;
    uint shadowing;
    vec2 index;
    vec2 permittivity;
};
struct TableParams {
    uint basis;
    uint table_count;
    uint cross_count;
    uint material;
    uint shadowing;
    float radius_max;
    float index_n;
    float index_k;
    uint restricted;
    float grid_last;
    float first_column;
    float first_row;
    uint factor;
    uint look_up;
    vec2 permittivity;
    vec4 pigment;
    vec4 table_scales[64];
    vec4 cross_scales[64];
};
struct Recurrence {
    float first;
    float second;
    float forward;
    float back;
};
struct SplinePlaces {
    vec2 first;
    vec2 second;
    vec2 share;
};
const uint IDEAL = 0u;
const uint DIELECTRIC = 1u;
const uint CONDUCTOR = 2u;
const uint SCALAR = 0u;
const uint VECTOR = 1u;
const float NO_ANSWER = -1.0;
const uint CHEBYSHEV = 0u;
const uint TAYLOR = 1u;
const float RANGE_SLACK = 0.02;
const uint SPLINES = 1u;
const uint LINEAR = 0u;

layout(std140) uniform TableParams_block_0Fragment { TableParams _group_0_binding_0_fs; };

uniform highp sampler2DArray _group_0_binding_1_fs;

uniform highp sampler2DArray _group_0_binding_2_fs;

uniform highp sampler2D _group_0_binding_3_fs;

smooth in vec3 _vs2fs_location0;
smooth in vec3 _vs2fs_location1;
layout(location = 0) out vec4 _fs2p_location0;

vec3 wave_vector_change(vec3 wi_1, vec3 wo_1) {
    return (-(wi_1) - wo_1);
}

float geometry_factor(vec3 wi_2, vec3 wo_2) {
    float one_plus = (1.0 + dot(wi_2, wo_2));
    return ((one_plus / wi_2.z) * (one_plus / wo_2.z));
}

float v_cavity_shadowing(vec3 wi_3, vec3 wo_3) {
    vec3 sum_5 = (wi_3 + wo_3);
    vec3 m = (sum_5 / vec3(sqrt(dot(sum_5, sum_5))));
    float wo_m = dot(wo_3, m);
    if (!((wo_m > 0.0))) {
        return 0.0;
    }
    float scale = ((2.0 * m.z) / wo_m);
    return clamp(min((scale * wo_3.z), (scale * wi_3.z)), 0.0, 1.0);
}

vec2 complex_product(vec2 a, vec2 b) {
    return vec2(((a.x * b.x) - (a.y * b.y)), ((a.x * b.y) + (a.y * b.x)));
}

vec2 complex_quotient(vec2 a_1, vec2 b_1) {
    vec2 _e6 = complex_product(a_1, vec2(b_1.x, -(b_1.y)));
    return (_e6 / vec2(dot(b_1, b_1)));
}

vec2 complex_root(vec2 a_2) {
    float larger = sqrt((0.5 * (sqrt(dot(a_2, a_2)) + abs(a_2.x))));
    if ((larger == 0.0)) {
        return vec2(0.0, 0.0);
    }
    float smaller = ((0.5 * abs(a_2.y)) / larger);
    float turn = ((a_2.y >= 0.0) ? 1.0 : -1.0);
    if ((a_2.x >= 0.0)) {
        return vec2(larger, (turn * smaller));
    }
    return vec2(smaller, (turn * larger));
}

float reflectance(Front front, float cos_theta_d) {
    if ((front.material == IDEAL)) {
        return 1.0;
    }
    vec2 index = front.index;
    float cos_i = clamp(cos_theta_d, 0.0, 1.0);
    vec2 _e15 = complex_product(index, index);
    vec2 _e16 = complex_quotient(vec2((1.0 - (cos_i * cos_i)), 0.0), _e15);
    vec2 _e21 = complex_root((vec2(1.0, 0.0) - _e16));
    vec2 _e22 = complex_product(index, _e21);
    vec2 along = vec2(cos_i, 0.0);
    vec2 _e27 = complex_quotient((along - _e22), (along + _e22));
    vec2 _e32 = complex_quotient(((index * cos_i) - _e21), ((index * cos_i) + _e21));
    return (0.5 * (dot(_e27, _e27) + dot(_e32, _e32)));
}

float cos_half_angle(vec3 wi_4, vec3 wo_4) {
    return sqrt(max((0.5 + (0.5 * dot(wi_4, wo_4))), 0.0));
}

float shadowing(Front front_1, vec3 wi_5, vec3 wo_5) {
    if ((front_1.shadowing == 0u)) {
        return 1.0;
    }
    float _e7 = v_cavity_shadowing(wi_5, wo_5);
    return _e7;
}

float polarised_sum(Front front_2, vec3 wi_6, vec3 wo_6) {
    float cos_phi = 1.0;
    float sin2_i = dot(wi_6.xy, wi_6.xy);
    float sin2_o = dot(wo_6.xy, wo_6.xy);
    float sines = (sqrt(sin2_i) * sqrt(sin2_o));
    if ((sines > 1e-12)) {
        cos_phi = clamp((-(dot(wi_6.xy, wo_6.xy)) / sines), -1.0, 1.0);
    }
    float _e24 = cos_phi;
    float _e25 = cos_phi;
    float cos2_phi = (_e24 * _e25);
    vec2 eps = front_2.permittivity;
    if ((front_2.material == DIELECTRIC)) {
        float a_3 = sqrt(max((eps.x - sin2_i), 0.0));
        float b_2 = sqrt(max((eps.x - sin2_o), 0.0));
        float s_i = (wi_6.z + a_3);
        float s_o = (wo_6.z + b_2);
        float p_i = ((eps.x * wi_6.z) + a_3);
        float p_o = ((eps.x * wo_6.z) + b_2);
        float ss = (1.0 / (s_i * s_o));
        float sp = (b_2 / (s_i * p_o));
        float ps = (a_3 / (p_i * s_o));
        float _e61 = cos_phi;
        float pp = ((((a_3 * b_2) * _e61) - (eps.x * sines)) / (p_i * p_o));
        float contrast = ((eps.x - 1.0) * (eps.x - 1.0));
        return (contrast * ((((cos2_phi * ss) * ss) + ((1.0 - cos2_phi) * ((sp * sp) + (ps * ps)))) + (pp * pp)));
    }
    vec2 _e90 = complex_root((eps - vec2(sin2_i, 0.0)));
    vec2 _e94 = complex_root((eps - vec2(sin2_o, 0.0)));
    vec2 s_i_1 = (_e90 + vec2(wi_6.z, 0.0));
    vec2 s_o_1 = (_e94 + vec2(wo_6.z, 0.0));
    vec2 p_i_1 = ((eps * wi_6.z) + _e90);
    vec2 p_o_1 = ((eps * wo_6.z) + _e94);
    float ss_1 = (1.0 / (dot(s_i_1, s_i_1) * dot(s_o_1, s_o_1)));
    float sp_1 = (dot(_e94, _e94) / (dot(s_i_1, s_i_1) * dot(p_o_1, p_o_1)));
    float ps_1 = (dot(_e90, _e90) / (dot(p_i_1, p_i_1) * dot(s_o_1, s_o_1)));
    vec2 _e124 = complex_product(_e90, _e94);
    float _e125 = cos_phi;
    vec2 across = ((_e124 * _e125) - (eps * sines));
    float pp_1 = (dot(across, across) / (dot(p_i_1, p_i_1) * dot(p_o_1, p_o_1)));
    vec2 less = (eps - vec2(1.0, 0.0));
    return (dot(less, less) * (((cos2_phi * ss_1) + ((1.0 - cos2_phi) * (sp_1 + ps_1))) + pp_1));
}

float diffuse_factor(Front front_3, vec3 wi_7, vec3 wo_7) {
    bool local = false;
    if ((front_3.factor == VECTOR)) {
        local = (front_3.material != IDEAL);
    } else {
        local = false;
    }
    bool _e12 = local;
    if (_e12) {
        float _e18 = polarised_sum(front_3, wi_7, wo_7);
        float _e20 = shadowing(front_3, wi_7, wo_7);
        return ((((2.0 * wi_7.z) * wo_7.z) * _e18) * _e20);
    }
    float _e22 = cos_half_angle(wi_7, wo_7);
    float _e23 = reflectance(front_3, _e22);
    float _e24 = geometry_factor(wi_7, wo_7);
    float _e26 = shadowing(front_3, wi_7, wo_7);
    return ((_e23 * _e24) * _e26);
}

float coherent_factor(Front front_4, vec3 wi_8, vec3 wo_8) {
    float _e3 = cos_half_angle(wi_8, wo_8);
    float _e4 = reflectance(front_4, _e3);
    float _e5 = shadowing(front_4, wi_8, wo_8);
    float mirror = (_e4 * _e5);
    if ((front_4.factor == VECTOR)) {
        return mirror;
    }
    float w_2 = (wi_8.z + wo_8.z);
    float _e13 = geometry_factor(wi_8, wo_8);
    return (((mirror * _e13) / w_2) / w_2);
}

float image_radius2_(vec3 wi_9, vec3 wo_9) {
    vec2 lateral = (wi_9.xy + wo_9.xy);
    float to_horizon_i = ((wi_9.z * wi_9.z) / (1.0 + length(wi_9.xy)));
    float to_horizon_o = ((wo_9.z * wo_9.z) / (1.0 + length(wo_9.xy)));
    return (dot(lateral, lateral) + ((4.0 * to_horizon_i) * to_horizon_o));
}

float max_abs_w(float rho) {
    return sqrt(max((4.0 - (rho * rho)), 0.0));
}

float normalised_abs_w(vec3 q) {
    float _e3 = max_abs_w(length(q.xy));
    if ((_e3 == 0.0)) {
        return 0.0;
    }
    return min((abs(q.z) / _e3), 1.0);
}

vec2 texel_centred(vec2 at, uvec2 size) {
    vec2 across_1 = vec2(size);
    vec2 texel = (vec2((0.5 + (0.5 * at.x)), (0.5 - (0.5 * at.y))) * (across_1 - vec2(1.0)));
    return ((texel + vec2(0.5)) / across_1);
}

Front front_factor() {
    float _e2 = _group_0_binding_0_fs.index_n;
    float _e5 = _group_0_binding_0_fs.index_k;
    vec2 index_1 = vec2(_e2, _e5);
    uint _e9 = _group_0_binding_0_fs.material;
    uint _e12 = _group_0_binding_0_fs.factor;
    uint _e15 = _group_0_binding_0_fs.shadowing;
    vec2 _e18 = _group_0_binding_0_fs.permittivity;
    return Front(_e9, _e12, _e15, index_1, _e18);
}

vec3 pigment_xyz(vec3 wi_10, vec3 wo_10) {
    bool local_1 = false;
    if ((wi_10.z > 0.0)) {
        local_1 = (wo_10.z > 0.0);
    } else {
        local_1 = false;
    }
    bool _e11 = local_1;
    if (!(_e11)) {
        return vec3(0.0, 0.0, 0.0);
    }
    Front _e17 = front_factor();
    float _e19 = reflectance(_e17, wi_10.z);
    float _e23 = reflectance(_e17, wo_10.z);
    vec4 _e29 = _group_0_binding_0_fs.pigment;
    return (((1.0 - _e19) * (1.0 - _e23)) * _e29.xyz);
}

Recurrence shifted_values(float t) {
    float x_1 = ((2.0 * t) - 1.0);
    return Recurrence(1.0, x_1, (2.0 * x_1), 1.0);
}

Recurrence powers(float w) {
    float first = ((1.0 / w) / w);
    return Recurrence(first, (1.0 / w), w, 0.0);
}

vec2 table_place(vec2 at_1) {
    float _e14 = _group_0_binding_0_fs.grid_last;
    vec2 texel_1 = (vec2((0.5 + (0.5 * at_1.x)), (0.5 - (0.5 * at_1.y))) * _e14);
    float _e18 = _group_0_binding_0_fs.first_column;
    float _e21 = _group_0_binding_0_fs.first_row;
    return (((texel_1 - vec2(_e18, _e21)) + vec2(0.5)) / vec2(uvec2(textureSize(_group_0_binding_1_fs, 0).xy)));
}

float share_of_range(vec2 at_2, float t_1) {
    bool local_2 = false;
    bool local_3 = false;
    bool local_4 = false;
    bool local_5 = false;
    vec2 _e2 = table_place(at_2);
    vec2 half_texel = (vec2(0.5) / vec2(uvec2(textureSize(_group_0_binding_1_fs, 0).xy)));
    uint _e13 = _group_0_binding_0_fs.table_count;
    vec4 _e15 = textureLod(_group_0_binding_1_fs, vec3(_e2, _e13), 0.0);
    vec3 range = _e15.xyz;
    if (all(greaterThan(_e2, (0.99 * half_texel)))) {
        local_2 = all(greaterThan((vec2(1.0) - _e2), (0.99 * half_texel)));
    } else {
        local_2 = false;
    }
    bool inside = local_2;
    float s_1 = ((t_1 - range.x) / (range.y - range.x));
    if (inside) {
        local_3 = (range.z > 0.998);
    } else {
        local_3 = false;
    }
    bool _e44 = local_3;
    if (_e44) {
        local_4 = (s_1 >= -0.02);
    } else {
        local_4 = false;
    }
    bool _e50 = local_4;
    if (_e50) {
        local_5 = (s_1 <= 1.02);
    } else {
        local_5 = false;
    }
    bool _e56 = local_5;
    if (!(_e56)) {
        return -1.0;
    }
    return clamp(s_1, 0.0, 1.0);
}

vec4 spline_texel(SplinePlaces places, uint layer) {
    vec4 a_4 = textureLod(_group_0_binding_1_fs, vec3(places.first, layer), 0.0);
    vec4 b_3 = textureLod(_group_0_binding_1_fs, vec3(vec2(places.second.x, places.first.y), layer), 0.0);
    vec4 c = textureLod(_group_0_binding_1_fs, vec3(vec2(places.first.x, places.second.y), layer), 0.0);
    vec4 d = textureLod(_group_0_binding_1_fs, vec3(places.second, layer), 0.0);
    return mix(mix(d, c, places.share.x), mix(b_3, a_4, places.share.x), places.share.y);
}

vec3 expansion_by_splines(Recurrence basis, SplinePlaces places_1) {
    vec3 sum = vec3(0.0, 0.0, 0.0);
    float now = 0.0;
    float next = 0.0;
    uint n = 0u;
    now = basis.first;
    next = basis.second;
    bool loop_init = true;
    while(true) {
        if (!loop_init) {
            uint _e45 = n;
            n = (_e45 + 1u);
        }
        loop_init = false;
        uint _e13 = n;
        uint _e16 = _group_0_binding_0_fs.table_count;
        if ((_e13 < _e16)) {
        } else {
            break;
        }
        {
            vec3 _e18 = sum;
            float _e19 = now;
            uint _e22 = n;
            uint _e26 = n;
            float _e30 = _group_0_binding_0_fs.table_scales[(_e22 / 4u)][(_e26 % 4u)];
            uint _e32 = n;
            vec4 _e33 = spline_texel(places_1, _e32);
            sum = (_e18 + ((_e19 * _e30) * _e33.xyz));
            float _e38 = next;
            float _e41 = now;
            float after = ((basis.forward * _e38) - (basis.back * _e41));
            float _e44 = next;
            now = _e44;
            next = after;
        }
    }
    vec3 _e48 = sum;
    return _e48;
}

SplinePlaces spline_places(vec2 uv) {
    vec2 size_1 = vec2(uvec2(textureSize(_group_0_binding_1_fs, 0).xy));
    vec2 texel_2 = ((uv * size_1) - vec2(0.5));
    vec2 whole = floor(texel_2);
    vec2 f = (texel_2 - whole);
    vec2 g = (vec2(1.0) - f);
    vec2 before = (((g * g) * g) / vec2(6.0));
    vec2 last_1 = (((f * f) * f) / vec2(6.0));
    vec2 nearest = ((vec2(0.6666667) - (f * f)) + (3.0 * last_1));
    vec2 share = (before + nearest);
    vec2 first_1 = ((whole - vec2(1.0)) + (nearest / share));
    vec2 second = ((whole + vec2(1.0)) + (last_1 / (vec2(1.0) - share)));
    return SplinePlaces(((first_1 + vec2(0.5)) / size_1), ((second + vec2(0.5)) / size_1), share);
}

vec3 expansion(Recurrence basis_1, vec2 at_3) {
    vec3 sum_1 = vec3(0.0, 0.0, 0.0);
    float now_1 = 0.0;
    float next_1 = 0.0;
    uint n_1 = 0u;
    vec2 _e2 = table_place(at_3);
    uint _e5 = _group_0_binding_0_fs.look_up;
    if ((_e5 == SPLINES)) {
        SplinePlaces _e8 = spline_places(_e2);
        vec3 _e9 = expansion_by_splines(basis_1, _e8);
        return _e9;
    }
    now_1 = basis_1.first;
    next_1 = basis_1.second;
    bool loop_init_1 = true;
    while(true) {
        if (!loop_init_1) {
            uint _e56 = n_1;
            n_1 = (_e56 + 1u);
        }
        loop_init_1 = false;
        uint _e21 = n_1;
        uint _e24 = _group_0_binding_0_fs.table_count;
        if ((_e21 < _e24)) {
        } else {
            break;
        }
        {
            uint _e28 = n_1;
            vec4 _e30 = textureLod(_group_0_binding_1_fs, vec3(_e2, _e28), 0.0);
            vec3 texel_3 = _e30.xyz;
            vec3 _e32 = sum_1;
            float _e33 = now_1;
            uint _e36 = n_1;
            uint _e40 = n_1;
            float _e44 = _group_0_binding_0_fs.table_scales[(_e36 / 4u)][(_e40 % 4u)];
            sum_1 = (_e32 + ((_e33 * _e44) * texel_3));
            float _e49 = next_1;
            float _e52 = now_1;
            float after_1 = ((basis_1.forward * _e49) - (basis_1.back * _e52));
            float _e55 = next_1;
            now_1 = _e55;
            next_1 = after_1;
        }
    }
    vec3 _e59 = sum_1;
    return _e59;
}

vec4 lagrange_weights(float x) {
    float a_5 = (x - 1.0);
    float b_4 = (x - 2.0);
    float c_1 = (x - 3.0);
    return vec4((((-(a_5) * b_4) * c_1) / 6.0), (((0.5 * x) * b_4) * c_1), (((-0.5 * x) * a_5) * c_1), (((x * a_5) * b_4) / 6.0));
}

vec4 cross_texel(vec2 uv_1, uint layer_1) {
    bool local_6 = false;
    vec4 sum_2 = vec4(0.0, 0.0, 0.0, 0.0);
    int k = 0;
    ivec2 size_2 = ivec2(uvec2(textureSize(_group_0_binding_2_fs, 0).xy));
    uint _e7 = _group_0_binding_0_fs.look_up;
    if (!((_e7 == LINEAR))) {
        local_6 = (min(size_2.x, size_2.y) < 4);
    } else {
        local_6 = true;
    }
    bool _e19 = local_6;
    if (_e19) {
        vec4 _e23 = textureLod(_group_0_binding_2_fs, vec3(uv_1, layer_1), 0.0);
        return _e23;
    }
    vec2 at_7 = clamp(((uv_1 * vec2(size_2)) - vec2(0.5)), vec2(0.0, 0.0), vec2((size_2 - ivec2(1))));
    ivec2 first_2 = min(max((ivec2(at_7) - ivec2(1)), ivec2(0, 0)), (size_2 - ivec2(4)));
    vec4 _e52 = lagrange_weights((at_7.x - float(first_2.x)));
    vec4 _e57 = lagrange_weights((at_7.y - float(first_2.y)));
    bool loop_init_2 = true;
    while(true) {
        if (!loop_init_2) {
            int _e93 = k;
            k = (_e93 + 1);
        }
        loop_init_2 = false;
        int _e66 = k;
        if ((_e66 < 16)) {
        } else {
            break;
        }
        {
            int _e70 = k;
            int _e73 = k;
            vec4 texel_4 = texelFetch(_group_0_binding_2_fs, ivec3((first_2 + ivec2((_e70 % 4), (_e73 / 4))), int(layer_1)), 0);
            vec4 _e81 = sum_2;
            int _e82 = k;
            int _e86 = k;
            sum_2 = (_e81 + ((_e52[(_e82 % 4)] * _e57[(_e86 / 4)]) * texel_4));
        }
    }
    vec4 _e96 = sum_2;
    return _e96;
}

vec3 cross_expansion(Recurrence basis_2, vec2 at_4) {
    vec3 sum_3 = vec3(0.0, 0.0, 0.0);
    float now_2 = 0.0;
    float next_2 = 0.0;
    uint n_2 = 0u;
    vec2 _e4 = texel_centred(at_4, uvec2(textureSize(_group_0_binding_2_fs, 0).xy));
    now_2 = basis_2.first;
    next_2 = basis_2.second;
    bool loop_init_3 = true;
    while(true) {
        if (!loop_init_3) {
            uint _e48 = n_2;
            n_2 = (_e48 + 1u);
        }
        loop_init_3 = false;
        uint _e16 = n_2;
        uint _e19 = _group_0_binding_0_fs.cross_count;
        if ((_e16 < _e19)) {
        } else {
            break;
        }
        {
            uint _e21 = n_2;
            vec4 _e22 = cross_texel(_e4, _e21);
            vec3 texel_5 = _e22.xyz;
            vec3 _e24 = sum_3;
            float _e25 = now_2;
            uint _e28 = n_2;
            uint _e32 = n_2;
            float _e36 = _group_0_binding_0_fs.cross_scales[(_e28 / 4u)][(_e32 % 4u)];
            sum_3 = (_e24 + ((_e25 * _e36) * texel_5));
            float _e41 = next_2;
            float _e44 = now_2;
            float after_2 = ((basis_2.forward * _e41) - (basis_2.back * _e44));
            float _e47 = next_2;
            now_2 = _e47;
            next_2 = after_2;
        }
    }
    vec3 _e51 = sum_3;
    return _e51;
}

vec3 cross_value(vec3 q_1, float t_2) {
    bool local_7 = false;
    uint _e4 = _group_0_binding_0_fs.cross_count;
    if (!((_e4 == 0u))) {
        float _e17 = _group_0_binding_0_fs.radius_max;
        local_7 = (max(abs(q_1.x), abs(q_1.y)) >= _e17);
    } else {
        local_7 = true;
    }
    bool _e20 = local_7;
    if (_e20) {
        return vec3(0.0, 0.0, 0.0);
    }
    Recurrence _e25 = shifted_values(t_2);
    float _e29 = _group_0_binding_0_fs.radius_max;
    vec3 _e32 = cross_expansion(_e25, (q_1.xy / vec2(_e29)));
    return (_e32 / vec3(abs(q_1.z)));
}

vec3 sample_cubic(vec2 at_5, ivec2 last) {
    vec3 sum_4 = vec3(0.0, 0.0, 0.0);
    int k_1 = 0;
    ivec2 first_3 = min(max((ivec2(at_5) - ivec2(1)), ivec2(0, 0)), (last - ivec2(3)));
    vec4 _e17 = lagrange_weights((at_5.x - float(first_3.x)));
    vec4 _e22 = lagrange_weights((at_5.y - float(first_3.y)));
    bool loop_init_4 = true;
    while(true) {
        if (!loop_init_4) {
            int _e60 = k_1;
            k_1 = (_e60 + 1);
        }
        loop_init_4 = false;
        int _e30 = k_1;
        if ((_e30 < 16)) {
        } else {
            break;
        }
        {
            int _e35 = k_1;
            int _e40 = k_1;
            vec4 _e46 = texelFetch(_group_0_binding_3_fs, ivec2((first_3.y + (_e35 % 4)), (first_3.x + (_e40 / 4))), 0);
            vec3 texel_6 = _e46.xyz;
            vec3 _e48 = sum_4;
            int _e49 = k_1;
            int _e53 = k_1;
            sum_4 = (_e48 + ((_e22[(_e49 % 4)] * _e17[(_e53 / 4)]) * texel_6));
        }
    }
    vec3 _e63 = sum_4;
    return _e63;
}

vec3 sample_(vec2 at_6) {
    bool local_8 = false;
    ivec2 last_2 = (ivec2(uvec2(textureSize(_group_0_binding_3_fs, 0).xy)).yx - ivec2(1));
    uint _e10 = _group_0_binding_0_fs.look_up;
    if ((_e10 == SPLINES)) {
        local_8 = (min(last_2.x, last_2.y) >= 3);
    } else {
        local_8 = false;
    }
    bool _e21 = local_8;
    if (_e21) {
        vec3 _e27 = sample_cubic(clamp(at_6, vec2(0.0, 0.0), vec2(last_2)), last_2);
        return _e27;
    }
    vec2 inside_1 = clamp(at_6, vec2(0.0, 0.0), vec2(last_2));
    ivec2 first_4 = max(min(ivec2(inside_1), (last_2 - ivec2(1))), ivec2(0, 0));
    ivec2 second_1 = min((first_4 + ivec2(1)), last_2);
    vec2 share_1 = (inside_1 - vec2(first_4));
    vec4 _e53 = texelFetch(_group_0_binding_3_fs, ivec2(first_4.y, first_4.x), 0);
    vec4 _e60 = texelFetch(_group_0_binding_3_fs, ivec2(second_1.y, first_4.x), 0);
    vec3 low = mix(_e53.xyz, _e60.xyz, share_1.y);
    vec4 _e69 = texelFetch(_group_0_binding_3_fs, ivec2(first_4.y, second_1.x), 0);
    vec4 _e76 = texelFetch(_group_0_binding_3_fs, ivec2(second_1.y, second_1.x), 0);
    vec3 high = mix(_e69.xyz, _e76.xyz, share_1.y);
    return mix(low, high, share_1.x);
}

vec3 lobe_at(float radius, float w_1) {
    float _e4 = _group_0_binding_0_fs.radius_max;
    if ((radius >= _e4)) {
        return vec3(0.0, 0.0, 0.0);
    }
    vec2 last_3 = (vec2(uvec2(textureSize(_group_0_binding_3_fs, 0).xy)) - vec2(1.0));
    float _e18 = normalised_abs_w(vec3(radius, 0.0, w_1));
    float _e23 = _group_0_binding_0_fs.radius_max;
    vec3 _e28 = sample_(vec2((_e18 * last_3.y), ((radius / _e23) * last_3.x)));
    return _e28;
}

vec3 coherent_value(vec3 wi_11, vec3 wo_11, vec3 q_2) {
    vec3 value = vec3(0.0);
    float radius_1 = length(q_2.xy);
    float _e7 = _group_0_binding_0_fs.radius_max;
    if ((radius_1 >= _e7)) {
        return vec3(0.0, 0.0, 0.0);
    }
    vec3 _e14 = lobe_at(radius_1, q_2.z);
    value = _e14;
    uint _e18 = _group_0_binding_0_fs.factor;
    if ((_e18 == VECTOR)) {
        vec3 _e21 = value;
        float _e22 = image_radius2_(wi_11, wo_11);
        vec3 _e25 = lobe_at(sqrt(_e22), q_2.z);
        value = (_e21 + _e25);
    }
    Front _e27 = front_factor();
    float _e28 = coherent_factor(_e27, wi_11, wo_11);
    vec3 _e29 = value;
    return (_e28 * _e29);
}

vec3 brdf_xyz(vec3 wi_12, vec3 wo_12) {
    bool local_9 = false;
    float s = 0.0;
    Recurrence basis_3 = Recurrence(0.0, 0.0, 0.0, 0.0);
    if ((wi_12.z > 0.0)) {
        local_9 = (wo_12.z > 0.0);
    } else {
        local_9 = false;
    }
    bool _e11 = local_9;
    if (!(_e11)) {
        return vec3(0.0, 0.0, 0.0);
    }
    vec3 _e17 = wave_vector_change(wi_12, wo_12);
    float _e18 = normalised_abs_w(_e17);
    vec2 at_8 = (0.5 * _e17.xy);
    s = _e18;
    uint _e25 = _group_0_binding_0_fs.restricted;
    if ((_e25 != 0u)) {
        float _e28 = share_of_range(at_8, _e18);
        s = _e28;
        float _e29 = s;
        if ((_e29 < 0.0)) {
            return vec3(-1.0, -1.0, -1.0);
        }
    }
    float _e36 = s;
    Recurrence _e37 = shifted_values(_e36);
    basis_3 = _e37;
    uint _e41 = _group_0_binding_0_fs.basis;
    if ((_e41 == TAYLOR)) {
        Recurrence _e46 = powers(abs(_e17.z));
        basis_3 = _e46;
    }
    Front _e47 = front_factor();
    float _e48 = diffuse_factor(_e47, wi_12, wo_12);
    Recurrence _e49 = basis_3;
    vec3 _e50 = expansion(_e49, at_8);
    vec3 _e51 = cross_value(_e17, _e18);
    vec3 diffuse = (_e48 * (_e50 + _e51));
    vec3 _e54 = coherent_value(wi_12, wo_12, _e17);
    return (diffuse + _e54);
}

bool has_answer(vec3 xyz) {
    bool local_10 = false;
    bool local_11 = false;
    if ((xyz.x == NO_ANSWER)) {
        local_10 = (xyz.y == NO_ANSWER);
    } else {
        local_10 = false;
    }
    bool _e10 = local_10;
    if (_e10) {
        local_11 = (xyz.z == NO_ANSWER);
    } else {
        local_11 = false;
    }
    bool _e17 = local_11;
    return !(_e17);
}

vec3 surface_xyz(vec3 wi_13, vec3 wo_13) {
    bool local_12 = false;
    vec3 _e2 = brdf_xyz(wi_13, wo_13);
    float _e6 = _group_0_binding_0_fs.pigment.w;
    if (!((_e6 == 0.0))) {
        bool _e12 = has_answer(_e2);
        local_12 = !(_e12);
    } else {
        local_12 = true;
    }
    bool _e15 = local_12;
    if (_e15) {
        return _e2;
    }
    vec3 _e16 = pigment_xyz(wi_13, wo_13);
    return (_e2 + _e16);
}

vec3 xyz_to_linear_srgb(vec3 xyz_1) {
    return vec3(dot(vec3(3.2404542, -1.5371385, -0.4985314), xyz_1), dot(vec3(-0.969266, 1.8760108, 0.041556), xyz_1), dot(vec3(0.0556434, -0.2040259, 1.0572252), xyz_1));
}

void main() {
    vec3 wi = _vs2fs_location0;
    vec3 wo = _vs2fs_location1;
    vec3 to_light = normalize(wi);
    vec3 to_viewer = normalize(wo);
    vec3 _e4 = surface_xyz(to_light, to_viewer);
    bool _e5 = has_answer(_e4);
    if (!(_e5)) {
        _fs2p_location0 = vec4(1.0, 0.0, 1.0, 1.0);
        return;
    }
    vec3 xyz_2 = (_e4 * max(to_light.z, 0.0));
    vec3 _e16 = xyz_to_linear_srgb(xyz_2);
    _fs2p_location0 = vec4(_e16, 1.0);
    return;
}

`;var xo=["_group_0_binding_0_fs","_group_0_binding_1_fs","_group_0_binding_2_fs","_group_0_binding_3_fs"];function v_(i){let e=i.replace(/^#version.*$/m,"").replace(/layout\(std140\) uniform \w+ \{ (\w+) (\w+); \};/,"uniform $1 $2;").replace(/^(smooth|flat) in .*;$/gm,"").replace(/^layout\(location = \d+\) out .*;$/gm,""),t=e.indexOf("void main()");if(t<0)throw new Error("the translated shader has no entry point");return e.slice(0,t)}var z2=`
bool answered = true;
vec3 reflected(vec3 wi, vec3 wo) {
  vec3 xyz = surface_xyz(wi, wo);
  if (!has_answer(xyz)) {
    answered = false;
    return vec3(0.0);
  }
  return xyz;
}
`,k2=`
uniform highp sampler2D u_quadrature;
uniform int u_wavelengths;
uniform float u_structure_scale;
bool answered = true;
Front front_at(vec3 material) {
  uint kind = uint(material.z + 0.5);
  return Front(kind, _group_0_binding_0_fs.factor, _group_0_binding_0_fs.shadowing, material.xy, complex_product(material.xy, material.xy));
}
vec3 reflected(vec3 wi, vec3 wo) {
  vec3 sum = vec3(0.0);
  for (int i = 0; i < u_wavelengths; i++) {
    vec4 weight = texelFetch(u_quadrature, ivec2(i, 0), 0);
    vec3 material = texelFetch(u_quadrature, ivec2(i, 1), 0).xyz;
    float f = brdf_spectral_with(front_at(material), wi, wo, weight.x / u_structure_scale);
    if (has_answer(f)) sum += f * weight.yzw;
    else answered = false;
  }
  return sum;
}
`,V2=`
vec4 cubic_weights(float x) {
  return vec4(-(x - 1.0) * (x - 2.0) * (x - 3.0) / 6.0, x * (x - 2.0) * (x - 3.0) / 2.0, -x * (x - 1.0) * (x - 3.0) / 2.0, x * (x - 1.0) * (x - 2.0) / 6.0);
}
vec4 cubic_lookup(highp sampler2DArray layers, vec3 at, float lod) {
  ivec2 size = textureSize(layers, 0).xy;
  vec2 place = clamp(at.xy * vec2(size) - 0.5, vec2(0.0), vec2(size - 1));
  ivec2 first = clamp(ivec2(floor(place)) - 1, ivec2(0), max(size - 4, ivec2(0)));
  vec2 share = place - vec2(first);
  vec4 across = cubic_weights(share.x);
  vec4 down = cubic_weights(share.y);
  vec4 sum = vec4(0.0);
  for (int y = 0; y < 4; y++)
    for (int x = 0; x < 4; x++) sum += across[x] * down[y] * texelFetch(layers, ivec3(min(first + ivec2(x, y), size - 1), int(at.z)), 0);
  return sum;
}
`;function H2(i,e){if(e==="bilinear")return i;let t=`textureLod(${xo[1]},`,n=i.indexOf("float share_of_range("),r=n<0?-1:i.indexOf(`
}
`,n),s=l=>l.replaceAll(t,`cubic_lookup(${xo[1]},`),o=s(i.slice(0,Math.max(n,0)))+i.slice(Math.max(n,0),Math.max(r,0))+s(i.slice(Math.max(r,0)));if(!o.includes("cubic_lookup("))throw new Error("the translated shader looks nothing up in tables");let a=`precision highp int;
`;return o.replace(a,a+V2)}var G2={tables:v_(x_),spectral:v_(__)},W2={tables:z2,spectral:k2},rh=(i,e)=>H2(G2[i],e)+W2[i];var b_=new dt(3.2404542,-1.5371385,-.4985314,-.969266,1.8760108,.041556,.0556434,-.2040259,1.0572252),X2=new J(.2126729,.7151522,.072175),w_=new dt(.4122214708,.5363325363,.0514459929,.2119034982,.6806995451,.1073969566,.0883024619,.2817188376,.6299787005),S_=new dt(4.0767416621,-3.3077115913,.2309699292,-1.2684380046,2.6097574011,-.3413193965,-.0041960863,-.7034186147,1.707614701),M_=new dt(.4865709,.2656677,.1982173,.2289746,.6917385,.0792869,0,.0451134,1.0439444),Hl={rgb_from_xyz:b_,luminance:X2,lms_from_rgb:w_,rgb_from_lms:S_},y_=b_.clone().multiply(M_),T_={rgb_from_xyz:M_.clone().invert(),luminance:new J(.2289746,.6917385,.0792869),lms_from_rgb:w_.clone().multiply(y_),rgb_from_lms:y_.clone().invert().multiply(S_)},A_=`
uniform sampler2D u_xyz;
uniform sampler2D u_other;
uniform float u_exposure;
uniform int u_mode;
uniform float u_backdrop;
layout(location = 0) out highp vec4 out_value;

// The display's primaries: those of sRGB, or the wider ones of display-P3.
uniform mat3 u_rgb_from_xyz;
uniform vec3 u_luminance;
uniform mat3 u_lms_from_rgb;
uniform mat3 u_rgb_from_lms;
const mat3 LAB_FROM_ROOTS = mat3(0.2104542553, 1.9779984951, 0.0259040371, 0.7936177850, -2.4285922050, 0.7827717662, -0.0040720468, 0.4505937099, -0.8086757660);
const float HIGHLIGHT_START = 0.8;

float cube_root(float x) { return sign(x) * pow(abs(x), 1.0 / 3.0); }

// A colour's hue as the change of each cone's root with the saturation, and its saturation; none where negative.
vec4 hue_ray(vec3 rgb) {
  vec3 lms = u_lms_from_rgb * rgb;
  vec3 lab = LAB_FROM_ROOTS * vec3(cube_root(lms.x), cube_root(lms.y), cube_root(lms.z));
  float chroma = length(lab.yz);
  if (lab.x <= 0.0 || chroma <= 0.0) return vec4(-1.0);
  vec2 ab = lab.yz / chroma;
  vec3 slope = vec3(0.3963377774 * ab.x + 0.2158037573 * ab.y, -0.1055613458 * ab.x - 0.0638541728 * ab.y, -0.0894841775 * ab.x - 1.2914855480 * ab.y);
  return vec4(slope, chroma / lab.x);
}

vec3 on_ray(vec3 slope, float saturation) {
  vec3 root = 1.0 + saturation * slope;
  return u_rgb_from_lms * (root * root * root);
}

float least(vec3 v) { return min(v.x, min(v.y, v.z)); }
float most(vec3 v) { return max(v.x, max(v.y, v.z)); }

vec3 into_gamut(vec3 rgb) {
  if (least(rgb) >= 0.0) return rgb;
  float target = dot(u_luminance, rgb);
  if (target <= 0.0) return vec3(0.0);
  vec4 ray = hue_ray(rgb / most(abs(rgb)));
  if (ray.w < 0.0) return vec3(target);
  float inside = 0.0;
  float outside = ray.w;
  for (int i = 0; i < 22; i++) {
    float middle = 0.5 * (inside + outside);
    if (least(on_ray(ray.xyz, middle)) >= 0.0) inside = middle;
    else outside = middle;
  }
  vec3 found = max(on_ray(ray.xyz, inside), 0.0);
  return found * (target / dot(u_luminance, found));
}

vec3 roll_off(vec3 rgb) {
  float peak = most(rgb);
  if (peak <= HIGHLIGHT_START) return rgb;
  float d = 1.0 - HIGHLIGHT_START;
  float rolled = 1.0 - d * d / (peak + d - HIGHLIGHT_START);
  float kept = 1.0 / (1.0 + 0.15 * (peak - rolled));
  vec4 ray = hue_ray(rgb / peak);
  vec3 paled = ray.w < 0.0 ? rgb : on_ray(ray.xyz, ray.w * kept);
  return clamp(paled * (rolled / most(paled)), 0.0, 1.0);
}

vec3 encode(vec3 linear) {
  vec3 c = clamp(linear, 0.0, 1.0);
  return mix(12.92 * c, 1.055 * pow(max(c, vec3(1e-9)), vec3(1.0 / 2.4)) - 0.055, step(0.0031308, c));
}

vec3 heat(float x) {
  const vec3 stops[5] = vec3[5](vec3(0.0, 0.0, 0.016), vec3(0.333, 0.059, 0.427), vec3(0.729, 0.212, 0.333), vec3(0.976, 0.549, 0.039), vec3(0.988, 1.0, 0.643));
  float at = clamp(x, 0.0, 1.0) * 4.0;
  int first = min(int(at), 3);
  return mix(stops[first], stops[first + 1], at - float(first));
}

void main() {
  ivec2 at = ivec2(gl_FragCoord.xy);
  vec4 value = texelFetch(u_xyz, at, 0);
  if (u_mode == 2) {
    vec4 other = texelFetch(u_other, at, 0);
    out_value = vec4(heat(abs(value.y - other.y) * u_exposure * 10.0), 1.0);
    return;
  }
  vec3 rgb = u_rgb_from_xyz * (value.xyz * u_exposure);
  vec3 shown = u_mode == 1 ? encode(rgb) : encode(roll_off(into_gamut(rgb)));
  // Directions that the tables do not cover: a grey hatch.
  float hatch = step(3.0, mod(gl_FragCoord.x + gl_FragCoord.y, 6.0));
  shown = mix(shown, vec3(0.35 + 0.15 * hatch), clamp(value.a, 0.0, 1.0));
  // Beside the surface: a dim backdrop, so that dark surfaces stand out.
  vec2 size = vec2(textureSize(u_xyz, 0));
  float away = length((gl_FragCoord.xy - 0.5 * size) / max(size.x, size.y));
  vec3 backdrop = u_backdrop * mix(vec3(0.115, 0.12, 0.135), vec3(0.035, 0.038, 0.046), smoothstep(0.1, 0.75, away));
  out_value = vec4(mix(shown, backdrop, clamp(-value.a, 0.0, 1.0)), 1.0);
}
`;function q2(){let i=new _n;return i.setAttribute("position",new an(new Float32Array([-1,-1,0,3,-1,0,-1,3,0]),3)),i}function Os(i,e,t,n=!1){return new oa({glslVersion:Dl,vertexShader:`precision highp float;
${i}`,fragmentShader:e,uniforms:t,depthTest:n,depthWrite:n})}var Ur=class{constructor(e,t=q2()){this.material=e;let n=new In(t,e);n.frustumCulled=!1,this.scene.add(n),this.scene.matrixWorldAutoUpdate=!1}material;scene=new ol;camera=new lo;draw(e,t){e.setRenderTarget(t),e.render(this.scene,this.camera)}},E_=`precision highp float;
precision highp int;
precision highp sampler2D;
`,R_=()=>new Ur(Os(_o,`${E_}
uniform sampler2D u_before;
uniform sampler2D u_sample;
uniform float u_share;
layout(location = 0) out highp vec4 out_value;
void main() {
  ivec2 at = ivec2(gl_FragCoord.xy);
  out_value = mix(texelFetch(u_before, at, 0), texelFetch(u_sample, at, 0), u_share);
}`,{u_before:{value:null},u_sample:{value:null},u_share:{value:1}})),sh=()=>new Ur(Os(_o,`${E_}${A_}`,{u_xyz:{value:null},u_other:{value:null},u_exposure:{value:1},u_mode:{value:0},u_backdrop:{value:0},...Od(Hl)})),Od=i=>Object.fromEntries(Object.entries(i).map(([e,t])=>[`u_${e}`,{value:t}]));var ya=Math.PI/180,Y2={ball:u_,patch:h_,screen:p_,map:d_},ba=(i,e,t,n=!1)=>{let r=new Zn(i,e,{format:jt,type:t,depthBuffer:n});return r.texture.minFilter=r.texture.magFilter=Ut,r},oh=(i,e)=>{let t=new Zn(i,e,{depthBuffer:!1});return t.texture.minFilter=t.texture.magFilter=Ut,t};function $2(i,e){switch(i.shape){case"ball":return Fd;case"patch":return c_(i.patch);case"snake":return nh;case"model":return e?.view??Fd;case"screen":case"map":return null}}var us=class i{constructor(e,t){this.renderer=e;this.type=t;this.sums=[ba(1,1,t),ba(1,1,t)],this.sample=ba(1,1,t,!0),this.pixel=ba(1,1,t,!0)}renderer;type;programs=new Map;own={u_output:{value:0},u_active:{value:0},u_lights:{value:1},u_sky:{value:0},u_sky_map:{value:null},u_sky_rows:{value:null},u_spin:{value:new xt(1,0)},u_index:{value:0},u_light:{value:Array.from({length:4},()=>new Ot)},u_turn:{value:new xt(1,0)},u_from_clip:{value:new it},u_to_clip:{value:new it},u_extent:{value:new xt(1,1)},u_offset:{value:new xt},u_size:{value:new xt(1,1)},u_wi:{value:new J(0,0,1)},u_tangent:{value:new J},u_bitangent:{value:new J},u_normal:{value:new J},u_half_width:{value:1},u_sample_normal:{value:new J},u_distance:{value:1},u_hole_radius:{value:1},u_beam_point:{value:new J},u_beam_wi:{value:new J},u_beam_power:{value:1}};mean=R_();display=sh();sums;sample;pixel;taken=0;sky=null;primaries=Hl;width=1;height=1;get samples(){return this.taken}resize(e,t){if(!(e===this.width&&t===this.height)){[this.width,this.height]=[e,t];for(let n of[...this.sums,this.sample])n.setSize(e,t);this.restart()}}restart(){this.taken=0}static samplesOf(e){let t=e.shape==="screen"||e.lights.some(r=>r.diameter_deg>0),n=e.environment!=="none"&&C_(e);return Math.max(t?e.light_samples:1,e.pixel_samples,n?e.environment_samples:1)}step(e,t,n){let r=i.samplesOf(e),[s,o]=o_(this.taken,e.pixel_samples),a=[2*s/this.width,2*o/this.height];this.prepare(e,n,this.taken,r,a,1),this.own.u_output.value=0,this.draw(e,t,n,this.sample);let[l,c]=this.sums;this.mean.material.uniforms.u_before.value=l.texture,this.mean.material.uniforms.u_sample.value=this.sample.texture,this.mean.material.uniforms.u_share.value=1/(this.taken+1),this.mean.draw(this.renderer,c),this.sums=[c,l],this.taken+=1}show(e,t,n,r=null){let s=this.display.material.uniforms;s.u_xyz.value=this.sums[0].texture,s.u_other.value=r?.sums[0].texture??this.sums[0].texture,s.u_exposure.value=e,s.u_backdrop.value=n?0:1,Object.assign(s,Od(n?Hl:this.primaries)),s.u_mode.value=r?2:t==="clip"?1:0,this.display.draw(this.renderer,n)}values(){let{width:e,height:t}=this,n=new Float32Array(4*e*t);if(this.type===Nt)this.renderer.readRenderTargetPixels(this.sums[0],0,0,e,t,n);else throw new Error("this browser cannot read pictures of floating-point numbers");return Gl(n,e,t)}directionsAt(e,t,n,r){let[s,o]=xa(this.width,this.height);this.prepare(e,n,-1,1,[r.x/s,r.y/o],this.width),this.own.u_output.value=1,this.draw(e,t,n,this.pixel);let a=new Float32Array(4);this.renderer.readRenderTargetPixels(this.pixel,0,0,1,1,a);let[l,c,u,h]=a;if(l>2)return null;let f=(d,m)=>[d,m,Math.sqrt(Math.max(0,1-d*d-m*m))];return{wi:f(l,c),wo:f(u,h)}}draw(e,t,n,r){n?.drawShadows(this.renderer,this.own),this.own.u_size.value.set(r.width,r.height),this.program(e,t,n).draw(this.renderer,r)}prepare(e,t,n,r,s,o){let a=this.own,l=xa(this.width,this.height),c=a.u_light.value;a.u_active.value=e.shape==="map"||e.shape==="screen"?0:e.active,a.u_lights.value=Math.min(e.lights.length,4),e.lights.slice(0,4).forEach((h,f)=>{let[d,m]=I_(h,n,r);c[f].set(...va(d,-e.spin_deg),m)}),this.prepareSky(e,n),a.u_turn.value.set(Math.cos(e.turn_deg*ya),Math.sin(e.turn_deg*ya));let u=$2(e,t);if(u){let h=g_(m_(u,e,l),s,o);a.u_to_clip.value=h,a.u_from_clip.value=h.clone().invert()}a.u_extent.value.set(l[0]/o,l[1]/o),a.u_offset.value.set(s[0]*l[0],s[1]*l[1]),e.shape==="patch"&&this.preparePatch(e),e.shape==="map"&&a.u_wi.value.set(...I_(e.lights[0],n,r)[0]),e.shape==="screen"&&this.prepareScreen(e,n,r)}prepareSky(e,t){let{own:n,sky:r}=this;n.u_sky.value=r&&C_(e)?r.total:0,n.u_sky_map.value=r?.map??null,n.u_sky_rows.value=r?.rows??null,n.u_spin.value.set(Math.cos(e.spin_deg*ya),Math.sin(e.spin_deg*ya)),n.u_index.value=t}preparePatch(e){let{tangent:t,bitangent:n,normal:r}=Ud(e.patch);this.own.u_tangent.value.set(...t),this.own.u_bitangent.value.set(...n),this.own.u_normal.value.set(...r),this.own.u_half_width.value=.5*e.patch.width_mm}prepareScreen(e,t,n){let{distance_mm:r,width_mm:s,beam_mm:o,incidence_deg:a}=e.screen,[l,c]=[Math.sin(a*ya),Math.cos(a*ya)],u=.5*o,h=e.lights[0],[f,d]=t<0?[0,0]:eh(t,n),[m,b]=[Math.sqrt(f)*Math.cos(d)*u,Math.sqrt(f)*Math.sin(d)*u],[,,g,_]=t<0?[0,0,0,0]:Id(t),[S,T,M]=th([0,0,1],h.diameter_deg,[g,2*Math.PI*_]),P=this.own;P.u_sample_normal.value.set(l,0,c),P.u_distance.value=r,P.u_half_width.value=.5*s,P.u_hole_radius.value=u,P.u_beam_point.value.set(m,b,-m*l/c);let R=[c*S-l*M,T,l*S+c*M];P.u_beam_wi.value.set(...R),P.u_beam_power.value=h.irradiance*R[2]*Math.PI*u*u/c}program(e,t,n){let r=e.shape==="snake"||e.shape==="model",s=`${t.source} ${r?n?.geometry.uuid:e.shape} ${t.interpolation}`,o=this.programs.get(s);if(!o){let a=r?n?.fragment:Y2[e.shape];if(a===void 0)throw new Error(`the shape ${e.shape} is not there yet`);let l=rh(t.source,t.interpolation)+l_+a,c=Os(r?n?.vertex??"":_o,l,{...this.own},r);o=new Ur(c,r?n?.geometry:void 0),this.programs.set(s,o)}return Object.assign(o.material.uniforms,t.uniforms,r?n?.uniforms:{}),o}},C_=i=>i.shape!=="map"&&i.shape!=="screen";function I_(i,e,t){return e<0||i.diameter_deg===0?[wi(i.direction),i.irradiance]:[th(i.direction,i.diameter_deg,eh(e,t)),i.irradiance*a_(i.direction,i.diameter_deg,t)]}function Gl(i,e,t){let n=4*e,r=i.slice();for(let s=0;s<t;s++)r.set(i.subarray(s*n,(s+1)*n),(t-1-s)*n);return r}var Bd=`layout(location = 0) out highp vec4 out_value;
uniform highp sampler2D u_list;
`,Z2=`${Bd}
void main() {
  int i = int(gl_FragCoord.x);
  vec3 f = reflected(texelFetch(u_list, ivec2(i, 0), 0).xyz, texelFetch(u_list, ivec2(i, 1), 0).xyz);
  out_value = vec4(f, answered ? 1.0 : 0.0);
}
`,K2=`${Bd}
uniform vec3 u_wi;
uniform vec3 u_wo;
void main() {
  vec4 ask = texelFetch(u_list, ivec2(int(gl_FragCoord.x), 0), 0);
  float f = brdf_spectral_with(front_at(ask.yzw), u_wi, u_wo, ask.x / u_structure_scale);
  out_value = vec4(has_answer(f) ? f : 0.0, has_answer(f) ? 1.0 : 0.0, 0.0, 0.0);
}
`,J2=`${Bd}
uniform vec3 u_wi;
uniform float u_side;
void main() {
  vec2 at = 2.0 * gl_FragCoord.xy / u_side - 1.0;
  float cos2 = 1.0 - dot(at, at);
  vec3 f = cos2 > 0.0 ? reflected(u_wi, vec3(at, sqrt(cos2))) : vec3(0.0);
  out_value = vec4(f, answered ? 0.0 : 1.0);
}
`;function j2(i,e){let t=new Float32Array(4*e*i.length);i.forEach((r,s)=>t.set(r,4*e*s));let n=new oi(t,e,i.length,jt,Nt);return n.minFilter=n.magFilter=Ut,n.needsUpdate=!0,n}var ah=class{constructor(e){this.renderer=e}renderer;programs=new Map;targets=new Map;display=sh();own={u_list:{value:null},u_wi:{value:new J},u_wo:{value:new J},u_side:{value:1}};brdf(e,t){let n=[t.flatMap(({wi:s})=>[...s,0]),t.flatMap(({wo:s})=>[...s,0])],r=this.list(e,"pairs",Z2,n,t.length);return t.map((s,o)=>r[4*o+3]>.5?[r[4*o],r[4*o+1],r[4*o+2]]:null)}spectrum(e,{wi:t,wo:n},r){this.own.u_wi.value.set(...t),this.own.u_wo.value.set(...n);let s=r.flatMap(({nm:a,index_n:l,index_k:c,material:u})=>[a,l,c,u]),o=this.list(e,"spectrum",K2,[s],r.length);return Float64Array.from(r,({known:a},l)=>a&&o[4*l+1]>.5?o[4*l]:NaN)}map(e,t,n,r){this.own.u_wi.value.set(...t),this.own.u_side.value=n;let s=this.target("map",n,n);this.program(e,"map",J2).draw(this.renderer,s);let o=r??this.exposureOf(s,n,n),a=this.bytes(s,n,n,o);return{pixels:Gl(a,n,n),exposure:o}}exposureOf(e,t,n){let r=new Float32Array(4*t*n);return this.renderer.readRenderTargetPixels(e,0,0,t,n,r),zd(r)}bytes(e,t,n,r){let s=this.display.material.uniforms;s.u_xyz.value=e.texture,s.u_other.value=e.texture,s.u_exposure.value=r;let o=this.target("bytes",t,n,!0);this.display.draw(this.renderer,o);let a=new Uint8Array(4*t*n);return this.renderer.readRenderTargetPixels(o,0,0,t,n,a),a}list(e,t,n,r,s){let o=j2(r,s);this.own.u_list.value=o;let a=this.target(t,s,1);this.program(e,t,n).draw(this.renderer,a);let l=new Float32Array(4*s);return this.renderer.readRenderTargetPixels(a,0,0,s,1,l),o.dispose(),l}target(e,t,n,r=!1){let s=this.targets.get(e);return s||(s=ba(t,n,Nt),r&&(s=oh(t,n)),this.targets.set(e,s)),(s.width!==t||s.height!==n)&&s.setSize(t,n),s}program(e,t,n){let r=`${e.source} ${e.interpolation} ${t}`,s=this.programs.get(r);return s||(s=new Ur(Os(_o,rh(e.source,e.interpolation)+n,{...this.own})),this.programs.set(r,s)),Object.assign(s.material.uniforms,e.uniforms),s}},Q2=.995;function zd(i){let e=new Float32Array(i.length/4),t=0;for(let r=1;r<i.length;r+=4)i[r]>0&&Number.isFinite(i[r])&&(e[t++]=i[r]);return t?1/e.subarray(0,t).sort()[Math.ceil(Q2*t)-1]:1}function N_(i,e){let t=i.spectral?.dispersion;if(!t)return kl(i.optics.material);let n=e3(t,e);if(!n)return null;let[r,s]=n;return kl(s===0?{dielectric:{n:r}}:{conductor:{n:r,k:s}})}function e3({wavelength_nm:i,n:e,k:t},n){let r=i.length-1;if(!(n>=i[0]&&n<=i[r]))return null;let s=0;for(;s<r-1&&i[s+1]<=n;)s++;return[P_(i,e,s,n),P_(i,t,s,n)]}function P_(i,e,t,n){let r=i[t+1]-i[t],s=(n-i[t])/r,o=1-s,[a,l]=[r*L_(i,e,t),r*L_(i,e,t+1)],[c,u]=[e[t],e[t+1]];return c*(1+2*s)*o*o+u*s*s*(3-2*s)+a*s*o*o-l*s*s*o}function L_(i,e,t){let n=u=>(e[u+1]-e[u])/(i[u+1]-i[u]);if(t===0)return n(0);if(t===i.length-1)return n(t-1);let[r,s]=[n(t-1),n(t)];if(r*s<=0)return 0;let[o,a]=[i[t]-i[t-1],i[t+1]-i[t]],[l,c]=[2*a+o,a+2*o];return(l+c)/(l/r+c/s)}var Si={observerFirstNm:360,observer:[[1299e-7,3917e-9,6061e-7],[145847e-9,4393581e-12,.0006808792],[.0001638021,4929604e-12,.0007651456],[.0001840037,5532136e-12,.0008600124],[.0002066902,6208245e-12,.0009665928],[2321e-7,6965e-9,.001086],[260728e-9,7813219e-12,.001220586],[293075e-9,8767336e-12,.001372729],[329388e-9,9839844e-12,.001543579],[369914e-9,1104323e-11,.001734286],[4149e-7,1239e-8,.001946],[.0004641587,1388641e-11,.002177777],[518986e-9,1555728e-11,.002435809],[581854e-9,1744296e-11,.002731953],[.0006552347,1958375e-11,.003078064],[7416e-7,2202e-8,.003486],[.0008450296,2483965e-11,.003975227],[.0009645268,2804126e-11,.00454088],[.001094949,3153104e-11,.00515832],[.001231154,3521521e-11,.005802907],[.001368,39e-6,.006450001],[.00150205,428264e-10,.007083216],[.001642328,469146e-10,.007745488],[.001802382,515896e-10,.008501152],[.001995757,571764e-10,.009414544],[.002236,64e-6,.01054999],[.002535385,7234421e-11,.0119658],[.002892603,8221224e-11,.01365587],[.003300829,9350816e-11,.01558805],[.003753236,.0001061361,.01773015],[.004243,12e-5,.02005001],[.004762389,134984e-9,.02251136],[.005330048,151492e-9,.02520288],[.005978712,170208e-9,.02827972],[.006741117,191816e-9,.03189704],[.00765,217e-6,.03621],[.008751373,.0002469067,.04143771],[.01002888,28124e-8,.04750372],[.0114217,31852e-8,.05411988],[.01286901,.0003572667,.06099803],[.01431,396e-6,.06785001],[.01570443,.0004337147,.07448632],[.01714744,473024e-9,.08136156],[.01878122,517876e-9,.08915364],[.02074801,.0005722187,.09854048],[.02319,64e-5,.1102],[.02620736,72456e-8,.1246133],[.02978248,8255e-7,.1417017],[.03388092,94116e-8,.1613035],[.03846824,.00106988,.1832568],[.04351,.00121,.2074],[.0489956,.001362091,.2336921],[.0550226,.001530752,.2626114],[.0617188,.001720368,.2947746],[.069212,.001935323,.3307985],[.07763,.00218,.3713],[.08695811,.0024548,.4162091],[.09717672,.002764,.4654642],[.1084063,.0031178,.5196948],[.1207672,.0035264,.5795303],[.13438,.004,.6456],[.1493582,.00454624,.7184838],[.1653957,.00515932,.7967133],[.1819831,.00582928,.8778459],[.198611,.00654616,.959439],[.21477,.0073,1.0390501],[.2301868,.008086507,1.1153673],[.2448797,.00890872,1.1884971],[.2587773,.00976768,1.2581233],[.2718079,.01066443,1.3239296],[.2839,.0116,1.3856],[.2949438,.01257317,1.4426352],[.3048965,.01358272,1.4948035],[.3137873,.01462968,1.5421903],[.3216454,.01571509,1.5848807],[.3285,.01684,1.62296],[.3343513,.01800736,1.6564048],[.3392101,.01921448,1.6852959],[.3431213,.02045392,1.7098745],[.3461296,.02171824,1.7303821],[.34828,.023,1.74706],[.3495999,.02429461,1.7600446],[.3501474,.02561024,1.7696233],[.350013,.02695857,1.7762637],[.349287,.02835125,1.7804334],[.34806,.0298,1.7826],[.3463733,.03131083,1.7829682],[.3442624,.03288368,1.7816998],[.3418088,.03452112,1.7791982],[.3390941,.03622571,1.7758671],[.3362,.038,1.77211],[.3331977,.03984667,1.7682589],[.3300411,.041768,1.764039],[.3266357,.043766,1.7589438],[.3228868,.04584267,1.7524663],[.3187,.048,1.7441],[.3140251,.05024368,1.7335595],[.308884,.05257304,1.7208581],[.3032904,.05498056,1.7059369],[.2972579,.05745872,1.6887372],[.2908,.06,1.6692],[.2839701,.06260197,1.6475287],[.2767214,.06527752,1.6234127],[.2689178,.06804208,1.5960223],[.2604227,.07091109,1.564528],[.2511,.0739,1.5281],[.2408475,.077016,1.4861114],[.2298512,.0802664,1.4395215],[.2184072,.0836668,1.3898799],[.2068115,.0872328,1.3387362],[.19536,.09098,1.28764],[.1842136,.09491755,1.2374223],[.1733273,.09904584,1.1878243],[.1626881,.1033674,1.1387611],[.1522833,.1078846,1.090148],[.1421,.1126,1.0419],[.1321786,.117532,.9941976],[.1225696,.1226744,.9473473],[.1132752,.1279928,.9014531],[.1042979,.1334528,.8566193],[.09564,.13902,.8129501],[.08729955,.1446764,.7705173],[.07930804,.1504693,.7294448],[.07171776,.1564619,.6899136],[.06458099,.1627177,.6521049],[.05795001,.1693,.6162],[.05186211,.1762431,.5823286],[.04628152,.1835581,.5504162],[.04115088,.1912735,.5203376],[.03641283,.199418,.4919673],[.03201,.20802,.46518],[.0279172,.2171199,.4399246],[.0241444,.2267345,.4161836],[.020687,.2368571,.3938822],[.0175404,.2474812,.3729459],[.0147,.2586,.3533],[.01216179,.2701849,.3348578],[.00991996,.2822939,.3175521],[.00796724,.2950505,.3013375],[.006296346,.308578,.2861686],[.0049,.323,.272],[.003777173,.3384021,.2588171],[.00294532,.3546858,.2464838],[.00242488,.3716986,.2347718],[.002236293,.3892875,.2234533],[.0024,.4073,.2123],[.00292552,.4256299,.2011692],[.00383656,.4443096,.1901196],[.00517484,.4633944,.1792254],[.00698208,.4829395,.1685608],[.0093,.503,.1582],[.01214949,.5235693,.1481383],[.01553588,.544512,.1383758],[.01947752,.56569,.1289942],[.02399277,.5869653,.1200751],[.0291,.6082,.1117],[.03481485,.6293456,.1039048],[.04112016,.6503068,.09666748],[.04798504,.6708752,.08998272],[.05537861,.6908424,.08384531],[.06327,.71,.07824999],[.07163501,.7281852,.07320899],[.08046224,.7454636,.06867816],[.08973996,.7619694,.06456784],[.09945645,.7778368,.06078835],[.1096,.7932,.05725001],[.1201674,.8081104,.05390435],[.1311145,.8224962,.05074664],[.1423679,.8363068,.04775276],[.1538542,.8494916,.04489859],[.1655,.862,.04216],[.1772571,.8738108,.03950728],[.18914,.8849624,.03693564],[.2011694,.8954936,.03445836],[.2133658,.9054432,.03208872],[.2257499,.9148501,.02984],[.2383209,.9237348,.02771181],[.2510668,.9320924,.02569444],[.2639922,.9399226,.02378716],[.2771017,.9472252,.02198925],[.2904,.954,.0203],[.3038912,.9602561,.01871805],[.3175726,.9660074,.01724036],[.3314384,.9712606,.01586364],[.3454828,.9760225,.01458461],[.3597,.9803,.0134],[.3740839,.9840924,.01230723],[.3886396,.9874182,.01130188],[.4033784,.9903128,.01037792],[.4183115,.9928116,.009529306],[.4334499,.9949501,.008749999],[.4487953,.9967108,.0080352],[.464336,.9980983,.0073816],[.480064,.999112,.0067854],[.4959713,.9997482,.0062428],[.5120501,1,.005749999],[.5282959,.9998567,.0053036],[.5446916,.9993046,.0048998],[.5612094,.9983255,.0045342],[.5778215,.9968987,.0042024],[.5945,.995,.0039],[.6112209,.9926005,.0036232],[.6279758,.9897426,.0033706],[.6447602,.9864444,.0031414],[.6615697,.9827241,.0029348],[.6784,.9786,.002749999],[.6952392,.9740837,.0025852],[.7120586,.9691712,.0024386],[.7288284,.9638568,.0023094],[.7455188,.9581349,.0021968],[.7621,.952,.0021],[.7785432,.9454504,.002017733],[.7948256,.9384992,.0019482],[.8109264,.9311628,.0018898],[.8268248,.9234576,.001840933],[.8425,.9154,.0018],[.8579325,.9070064,.001766267],[.8730816,.8982772,.0017378],[.8878944,.8892048,.0017112],[.9023181,.8797816,.001683067],[.9163,.87,.001650001],[.9297995,.8598613,.001610133],[.9427984,.849392,.0015644],[.9552776,.838622,.0015136],[.9672179,.8275813,.001458533],[.9786,.8163,.0014],[.9893856,.8047947,.001336667],[.9995488,.793082,.00127],[1.0090892,.781192,.001205],[1.0180064,.7691547,.001146667],[1.0263,.757,.0011],[1.0339827,.7447541,.0010688],[1.040986,.7324224,.0010494],[1.047188,.7200036,.0010356],[1.0524667,.7074965,.0010212],[1.0567,.6949,.001],[1.0597944,.6822192,96864e-8],[1.0617992,.6694716,92992e-8],[1.0628068,.6566744,88688e-8],[1.0629096,.6438448,84256e-8],[1.0622,.631,8e-4],[1.0607352,.6181555,76096e-8],[1.0584436,.6053144,72368e-8],[1.0552244,.5924756,68592e-8],[1.0509768,.5796379,64544e-8],[1.0456,.5668,6e-4],[1.0390369,.5539611,.0005478667],[1.0313608,.5411372,4916e-7],[1.0226662,.5283528,4354e-7],[1.0130477,.5156323,.0003834667],[1.0026,.503,34e-5],[.9913675,.4904688,.0003072533],[.9793314,.4780304,28316e-8],[.9664916,.4656776,26544e-8],[.9528479,.4534032,.0002518133],[.9384,.4412,24e-5],[.923194,.42908,.0002295467],[.907244,.417036,22064e-8],[.890502,.405032,21196e-8],[.87292,.393032,.0002021867],[.8544499,.381,19e-5],[.835084,.3689184,.0001742133],[.814946,.3568272,15564e-8],[.794186,.3447768,13596e-8],[.772954,.3328176,.0001168533],[.7514,.321,1e-4],[.7295836,.3093381,8613333e-11],[.7075888,.2978504,746e-7],[.6856022,.2865936,65e-6],[.6638104,.2756245,5693333e-11],[.6424,.265,4999999e-11],[.6215149,.2547632,4416e-8],[.6011138,.2448896,3948e-8],[.5811052,.2353344,3572e-8],[.5613977,.2260528,3264e-8],[.5419,.217,3e-5],[.5225995,.2081616,2765333e-11],[.5035464,.1995488,2556e-8],[.4847436,.1911552,2364e-8],[.4661939,.1829744,2181333e-11],[.4479,.175,2e-5],[.4298613,.1672235,1813333e-11],[.412098,.1596464,162e-7],[.394644,.1522776,142e-7],[.3775333,.1451259,1213333e-11],[.3608,.1382,1e-5],[.3444563,.1315003,7733333e-12],[.3285168,.1250248,54e-7],[.3130192,.1187792,32e-7],[.2980011,.1127691,1333333e-12],[.2835,.107,0],[.2695448,.1014762,0],[.2561184,.09618864,0],[.2431896,.09112296,0],[.2307272,.08626485,0],[.2187,.0816,0],[.2070971,.07712064,0],[.1959232,.07282552,0],[.1851708,.06871008,0],[.1748323,.06476976,0],[.1649,.061,0],[.1553667,.05739621,0],[.14623,.05395504,0],[.13749,.05067376,0],[.1291467,.04754965,0],[.1212,.04458,0],[.1136397,.04175872,0],[.106465,.03908496,0],[.09969044,.03656384,0],[.09333061,.03420048,0],[.0874,.032,0],[.08190096,.02996261,0],[.07680428,.02807664,0],[.07207712,.02632936,0],[.06768664,.02470805,0],[.0636,.0232,0],[.05980685,.02180077,0],[.05628216,.02050112,0],[.05297104,.01928108,0],[.04981861,.01812069,0],[.04677,.017,0],[.04378405,.01590379,0],[.04087536,.01483718,0],[.03807264,.01381068,0],[.03540461,.01283478,0],[.0329,.01192,0],[.03056419,.01106831,0],[.02838056,.01027339,0],[.02634484,.009533311,0],[.02445275,.008846157,0],[.0227,.00821,0],[.02108429,.007623781,0],[.01959988,.007085424,0],[.01823732,.006591476,0],[.01698717,.006138485,0],[.01584,.005723,0],[.01479064,.005343059,0],[.01383132,.004995796,0],[.01294868,.004676404,0],[.0121292,.004380075,0],[.01135916,.004102,0],[.01062935,.003838453,0],[.009938846,.003589099,0],[.009288422,.003354219,0],[.008678854,.003134093,0],[.008110916,.002929,0],[.007582388,.002738139,0],[.007088746,.002559876,0],[.006627313,.002393244,0],[.006195408,.002237275,0],[.005790346,.002091,0],[.005409826,.001953587,0],[.005052583,.00182458,0],[.004717512,.00170358,0],[.004403507,.001590187,0],[.004109457,.001484,0],[.003833913,.001384496,0],[.003575748,.001291268,0],[.003334342,.001204092,0],[.003109075,.001122744,0],[.002899327,.001047,0],[.002704348,.0009765896,0],[.00252302,.0009111088,0],[.002354168,.0008501332,0],[.002196616,.0007932384,0],[.00204919,74e-5,0],[.00191096,.0006900827,0],[.001781438,64331e-8,0],[.00166011,599496e-9,0],[.001546459,.0005584547,0],[.001439971,52e-5,0],[.001340042,.0004839136,0],[.001246275,.0004500528,0],[.001158471,.0004183452,0],[.00107643,.0003887184,0],[.0009999493,3611e-7,0],[.0009287358,.0003353835,0],[.0008624332,.0003114404,0],[.0008007503,.0002891656,0],[743396e-9,.0002684539,0],[.0006900786,2492e-7,0],[.0006405156,.0002313019,0],[.0005945021,.0002146856,0],[.0005518646,.0001992884,0],[512429e-9,.0001850475,0],[.0004760213,1719e-7,0],[.0004424536,.0001597781,0],[.0004115117,.0001486044,0],[.0003829814,.0001383016,0],[.0003566491,.0001287925,0],[.0003323011,12e-5,0],[.0003097586,.0001118595,0],[.0002888871,.0001043224,0],[.0002695394,973356e-10,0],[.0002515682,9084587e-11,0],[.0002348261,848e-7,0],[219171e-9,7914667e-11,0],[.0002045258,73858e-9,0],[.0001908405,68916e-9,0],[.0001780654,6430267e-11,0],[.0001661505,6e-5,0],[.0001550236,5598187e-11,0],[.0001446219,522256e-10,0],[.0001349098,487184e-10,0],[125852e-9,4544747e-11,0],[117413e-9,424e-7,0],[.0001095515,3956104e-11,0],[.0001022245,3691512e-11,0],[9539445e-11,3444868e-11,0],[890239e-10,3214816e-11,0],[8307527e-11,3e-5,0],[7751269e-11,2799125e-11,0],[7231304e-11,2611356e-11,0],[6745778e-11,2436024e-11,0],[6292844e-11,2272461e-11,0],[5870652e-11,212e-7,0],[5477028e-11,1977855e-11,0],[5109918e-11,1845285e-11,0],[4767654e-11,1721687e-11,0],[4448567e-11,1606459e-11,0],[4150994e-11,1499e-8,0],[3873324e-11,1398728e-11,0],[3614203e-11,1305155e-11,0],[3372352e-11,1217818e-11,0],[3146487e-11,1136254e-11,0],[2935326e-11,106e-7,0],[2737573e-11,9885877e-12,0],[2552433e-11,9217304e-12,0],[2379376e-11,8592362e-12,0],[221787e-10,8009133e-12,0],[2067383e-11,74657e-10,0],[1927226e-11,6959567e-12,0],[179664e-10,6487995e-12,0],[1674991e-11,6048699e-12,0],[1561648e-11,5639396e-12,0],[1455977e-11,52578e-10,0],[1357387e-11,4901771e-12,0],[1265436e-11,456972e-11,0],[1179723e-11,4260194e-12,0],[1099844e-11,3971739e-12,0],[1025398e-11,37029e-10,0],[9559646e-12,3452163e-12,0],[8912044e-12,3218302e-12,0],[8308358e-12,30003e-10,0],[7745769e-12,2797139e-12,0],[7221456e-12,26078e-10,0],[6732475e-12,243122e-11,0],[6276423e-12,2266531e-12,0],[5851304e-12,2113013e-12,0],[5455118e-12,1969943e-12,0],[5085868e-12,18366e-10,0],[4741466e-12,171223e-11,0],[4420236e-12,1596228e-12,0],[4120783e-12,148809e-11,0],[3841716e-12,1387314e-12,0],[3581652e-12,12934e-10,0],[3339127e-12,120582e-11,0],[3112949e-12,1124143e-12,0],[2902121e-12,1048009e-12,0],[2705645e-12,977058e-12,0],[2522525e-12,91093e-11,0],[2351726e-12,849251e-12,0],[2192415e-12,791721e-12,0],[2043902e-12,73809e-11,0],[1905497e-12,68811e-11,0],[1776509e-12,64153e-11,0],[1656215e-12,59809e-11,0],[1544022e-12,557575e-12,0],[143944e-11,519808e-12,0],[1341977e-12,484612e-12,0],[1251141e-12,45181e-11,0]],stepNm:5,d65FirstNm:300,d65:[.0341,1.6643,3.2945,11.7652,20.236,28.6447,37.0535,38.5011,39.9488,42.4302,44.9117,45.775,46.6383,49.3637,52.0891,51.0323,49.9755,52.3118,54.6482,68.7015,82.7549,87.1204,91.486,92.4589,93.4318,90.057,86.6823,95.7736,104.865,110.936,117.008,117.41,117.812,116.336,114.861,115.392,115.923,112.367,108.811,109.082,109.354,108.578,107.802,106.296,104.79,106.239,107.689,106.047,104.405,104.225,104.046,102.023,100,98.1671,96.3342,96.0611,95.788,92.2368,88.6856,89.3459,90.0062,89.8026,89.5991,88.6489,87.6987,85.4936,83.2886,83.4939,83.6992,81.863,80.0268,80.1207,80.2146,81.2462,82.2778,80.281,78.2842,74.0027,69.7213,70.6652,71.6091,72.979,74.349,67.9765,61.604,65.7448,69.8856,72.4863,75.087,69.3398,63.5927,55.0054,46.4182,56.6118,66.8054,65.0941,63.3828],fluorescentFirstNm:380,fluorescent:[[1.87,2.36,2.94,3.47,5.17,19.49,6.13,6.24,7.01,7.79,8.56,43.67,16.94,10.72,11.35,11.89,12.37,12.75,13,13.15,13.23,13.17,13.13,12.85,12.52,12.2,11.83,11.5,11.22,11.05,11.03,11.18,11.53,27.74,17.05,13.55,14.33,15.01,15.52,18.29,19.55,15.48,14.91,14.15,13.22,12.19,11.12,10.03,8.95,7.96,7.02,6.2,5.42,4.73,4.15,3.64,3.2,2.81,2.47,2.18,1.93,1.72,1.67,1.43,1.29,1.19,1.08,.96,.88,.81,.77,.75,.73,.68,.69,.64,.68,.69,.61,.52,.43],[1.18,1.48,1.84,2.15,3.44,15.69,3.85,3.74,4.19,4.62,5.06,34.98,11.81,6.27,6.63,6.93,7.19,7.4,7.54,7.62,7.65,7.62,7.62,7.45,7.28,7.15,7.05,7.04,7.16,7.47,8.04,8.88,10.01,24.88,16.64,14.59,16.16,17.56,18.62,21.47,22.79,19.29,18.66,17.73,16.54,15.21,13.8,12.36,10.95,9.65,8.4,7.32,6.31,5.43,4.68,4.02,3.45,2.96,2.55,2.19,1.89,1.64,1.53,1.27,1.1,.99,.88,.76,.68,.61,.56,.54,.51,.47,.47,.43,.46,.47,.4,.33,.27],[.82,1.02,1.26,1.44,2.57,14.36,2.7,2.45,2.73,3,3.28,31.85,9.47,4.02,4.25,4.44,4.59,4.72,4.8,4.86,4.87,4.85,4.88,4.77,4.67,4.62,4.62,4.73,4.99,5.48,6.25,7.34,8.78,23.82,16.14,14.59,16.63,18.49,19.95,23.11,24.69,21.41,20.85,19.93,18.67,17.22,15.65,14.04,12.45,10.95,9.51,8.27,7.11,6.09,5.22,4.45,3.8,3.23,2.75,2.33,1.99,1.7,1.55,1.27,1.09,.96,.83,.71,.62,.54,.49,.46,.43,.39,.39,.35,.38,.39,.33,.28,.21],[.57,.7,.87,.98,2.01,13.75,1.95,1.59,1.76,1.93,2.1,30.28,8.03,2.55,2.7,2.82,2.91,2.99,3.04,3.08,3.09,3.09,3.14,3.06,3,2.98,3.01,3.14,3.41,3.9,4.69,5.81,7.32,22.59,15.11,13.88,16.33,18.68,20.64,24.28,26.26,23.28,22.94,22.14,20.91,19.43,17.74,16,14.42,12.56,10.93,9.52,8.18,7.01,6,5.11,4.36,3.69,3.13,2.64,2.24,1.91,1.7,1.39,1.18,1.03,.88,.74,.64,.54,.49,.46,.42,.37,.37,.33,.35,.36,.31,.26,.19],[1.87,2.35,2.92,3.45,5.1,18.91,6,6.11,6.85,7.58,8.31,40.76,16.06,10.32,10.91,11.4,11.83,12.17,12.4,12.54,12.58,12.52,12.47,12.2,11.89,11.61,11.33,11.1,10.96,10.97,11.16,11.54,12.12,27.78,17.73,14.47,15.2,15.77,16.1,18.54,19.5,15.39,14.64,13.72,12.69,11.57,10.45,9.35,8.29,7.32,6.41,5.63,4.9,4.26,3.72,3.25,2.83,2.49,2.19,1.93,1.71,1.52,1.48,1.26,1.13,1.05,.96,.85,.78,.72,.68,.67,.65,.61,.62,.59,.62,.64,.55,.47,.4],[1.05,1.31,1.63,1.9,3.11,14.8,3.43,3.3,3.68,4.07,4.45,32.61,10.74,5.48,5.78,6.03,6.25,6.41,6.52,6.58,6.59,6.56,6.56,6.42,6.28,6.2,6.19,6.3,6.6,7.12,7.94,9.07,10.49,25.22,17.46,15.63,17.22,18.53,19.43,21.97,23.01,19.41,18.56,17.42,16.09,14.64,13.15,11.68,10.25,8.95,7.74,6.69,5.71,4.87,4.16,3.55,3.02,2.57,2.2,1.87,1.6,1.37,1.29,1.05,.91,.81,.71,.61,.54,.48,.44,.43,.4,.37,.38,.35,.39,.41,.33,.26,.21],[2.56,3.18,3.84,4.53,6.15,19.37,7.37,7.05,7.71,8.41,9.15,44.14,17.52,11.35,12,12.58,13.08,13.45,13.71,13.88,13.95,13.93,13.82,13.64,13.43,13.25,13.08,12.93,12.78,12.6,12.44,12.33,12.26,29.52,17.05,12.44,12.58,12.72,12.83,15.46,16.75,12.83,12.67,12.45,12.19,11.89,11.6,11.35,11.12,10.95,10.76,10.42,10.11,10.04,10.02,10.11,9.87,8.65,7.27,6.44,5.83,5.41,5.04,4.57,4.12,3.77,3.46,3.08,2.73,2.47,2.25,2.06,1.9,1.75,1.62,1.54,1.45,1.32,1.17,.99,.81],[1.21,1.5,1.81,2.13,3.17,13.08,3.83,3.45,3.86,4.42,5.09,34.1,12.42,7.68,8.6,9.46,10.24,10.84,11.33,11.71,11.98,12.17,12.28,12.32,12.35,12.44,12.55,12.68,12.77,12.72,12.6,12.43,12.22,28.96,16.51,11.79,11.76,11.77,11.84,14.61,16.11,12.34,12.53,12.72,12.92,13.12,13.34,13.61,13.87,14.07,14.2,14.16,14.13,14.34,14.5,14.46,14,12.58,10.99,9.98,9.22,8.62,8.07,7.39,6.71,6.16,5.63,5.03,4.46,4.02,3.66,3.36,3.09,2.85,2.65,2.51,2.37,2.15,1.89,1.61,1.32],[.9,1.12,1.36,1.6,2.59,12.8,3.05,2.56,2.86,3.3,3.82,32.62,10.77,5.84,6.57,7.25,7.86,8.35,8.75,9.06,9.31,9.48,9.61,9.68,9.74,9.88,10.04,10.26,10.48,10.63,10.78,10.96,11.18,27.71,16.29,12.28,12.74,13.21,13.65,16.57,18.14,14.55,14.65,14.66,14.61,14.5,14.39,14.4,14.47,14.62,14.72,14.55,14.4,14.58,14.88,15.51,15.47,13.2,10.57,9.18,8.25,7.57,7.03,6.35,5.72,5.25,4.8,4.29,3.8,3.43,3.12,2.86,2.64,2.43,2.26,2.14,2.02,1.83,1.61,1.38,1.12],[1.11,.8,.62,.57,1.48,12.16,2.12,2.7,3.74,5.14,6.75,34.39,14.86,10.4,10.76,10.67,10.11,9.27,8.29,7.29,7.91,16.64,16.73,10.44,5.94,3.34,2.35,1.88,1.59,1.47,1.8,5.71,40.98,73.69,33.61,8.24,3.38,2.47,2.14,4.86,11.45,14.79,12.16,8.97,6.52,8.31,44.12,34.55,12.09,12.15,10.52,4.43,1.95,2.19,3.19,2.77,2.29,2,1.52,1.35,1.47,1.79,1.74,1.02,1.14,3.32,4.49,2.05,.49,.24,.21,.21,.24,.24,.21,.17,.21,.22,.17,.12,.09],[.91,.63,.46,.37,1.29,12.68,1.59,1.79,2.46,3.33,4.49,33.94,12.13,6.95,7.19,7.12,6.72,6.13,5.46,4.79,5.66,14.29,14.96,8.97,4.72,2.33,1.47,1.1,.89,.83,1.18,4.9,39.59,72.84,32.61,7.52,2.83,1.96,1.67,4.43,11.28,14.76,12.73,9.74,7.33,9.72,55.27,42.58,13.18,13.16,12.26,5.11,2.07,2.34,3.58,3.01,2.48,2.14,1.54,1.33,1.46,1.94,2,1.2,1.35,4.1,5.58,2.51,.57,.27,.23,.21,.24,.24,.2,.24,.32,.26,.16,.12,.09],[.96,.64,.4,.33,1.19,12.48,1.12,.94,1.08,1.37,1.78,29.05,7.9,2.65,2.71,2.65,2.49,2.33,2.1,1.91,3.01,10.83,11.88,6.88,3.43,1.49,.92,.71,.6,.63,1.1,4.56,34.4,65.4,29.48,7.16,3.08,2.47,2.27,5.09,11.96,15.32,14.27,11.86,9.28,12.31,68.53,53.02,14.67,14.38,14.71,6.46,2.57,2.75,4.18,3.44,2.81,2.42,1.64,1.36,1.49,2.14,2.34,1.42,1.61,5.04,6.98,3.19,.71,.3,.26,.23,.28,.28,.21,.17,.21,.19,.15,.1,.05]]};function kd(i,e,t,n){let r=(n-e)/t;if(!(r>=0&&r<=i.length-1))return 0;let s=Math.min(Math.floor(r),i.length-2);return i[s]+(r-s)*(i[s+1]-i[s])}function hs(i){let e=i-Si.observerFirstNm,t=Si.observer.length-1;if(!(e>=0&&e<=t))return[0,0,0];let n=Math.min(Math.floor(e),t-1),r=e-n,[s,o]=[Si.observer[n],Si.observer[n+1]];return[0,1,2].map(a=>s[a]+r*(o[a]-s[a]))}var n3=(i,e)=>i**-5/Math.expm1(14387769/(i*e)),i3=i=>{let e=t=>Math.expm1(1435e4/(2848*t));return 100*(560/i)**5*e(560)/e(i)},r3=i=>{let e=(t,n,r)=>Math.exp(-.5*((i-t)/(i<t?n:r))**2);return e(450,9,11)+.62*e(560,42,65)},s3=i=>{let e=1/(Math.sin(i*Math.PI/180)+.50572*(i+6.07995)**-1.6364);return t=>{let n=t/1e3;return n3(t,5778)*Math.exp(-e*.008735*n**-4.08)*1e15}};function lh(i,e,t){switch(i){case"D65":return{label:"D65, daylight",power:n=>kd(Si.d65,Si.d65FirstNm,Si.stepNm,n)};case"A":return{label:"A, incandescent lamp",power:i3};case"E":return{label:"E, equal power",power:()=>1};case"F11":return{label:"F11, fluorescent lamp",power:n=>kd(Si.fluorescent[10],Si.fluorescentFirstNm,Si.stepNm,n)};case"LED":return{label:"white LED",power:r3};case"sun":return{label:`sun ${t}° high`,power:s3(t)};case"laser":return{label:`laser, ${e} nm`,lines:[{nm:e,power:1}]}}}var o3=6;function ch(i,[e,t],n){if(i.lines)return D_(i.lines.map(f=>f.nm),i.lines.map(f=>hs(f.nm).map(d=>d*f.power)));let r=i.power??(()=>1),[s,o]=[1/t,1/e],a=Array.from({length:n},(f,d)=>1/(s+d/(n-1)*(o-s))),l=a.map(()=>[0,0,0]),c=Math.min(o3,n),u=Math.ceil((t-e)/.25),h=(t-e)/u;for(let f=0;f<u;f++){let d=e+(f+.5)*h,m=(1/d-s)/(o-s)*(n-1),b=Math.min(n-c,Math.max(0,Math.floor(m)-c/2+1)),g=r(d)*h,_=hs(d).map(S=>S*g);a3(m-b,c).forEach((S,T)=>{for(let M=0;M<3;M++)l[b+T][M]+=S*_[M]})}return D_(a,l)}function a3(i,e){return Array.from({length:e},(t,n)=>{let r=1;for(let s=0;s<e;s++)s!==n&&(r*=(i-s)/(n-s));return r})}function D_(i,e){let t=e.reduce((n,r)=>n+r[1],0);return{nm:i,weights:e.map(n=>n.map(r=>r/t))}}function uh(i){if(typeof i=="string"){let n=i.toUpperCase();if(n==="D65"||n==="A"||n==="E")return lh(n,0,0);throw new Error(`the light ${i} is not known to this page`)}if("lines"in i){let n=i.lines.map(({wavelength_nm:r,power:s})=>({nm:r,power:s}));return{label:`lines at ${n.map(({nm:r})=>r).join(", ")} nm`,lines:n}}if("f"in i){let n=Si.fluorescent[i.f-1];return{label:`F${i.f}`,power:r=>kd(n,Si.fluorescentFirstNm,Si.stepNm,r)}}let{wavelength_nm:e,power:t}=i.tabulated;return{label:`a light of ${e.length} wavelengths from ${e[0]} nm`,power:n=>{let r=e.findIndex(s=>s>=n);return r<0||n<e[0]?0:e[r]===n?t[r]:t[r-1]+(n-e[r-1])/(e[r]-e[r-1])*(t[r]-t[r-1])}}}function F_({sigma_nm:i,half_height_range_nm:e,shortest_nm:t,longest_nm:n},r){let s=Math.SQRT2*2*Math.PI*i*r,o=2*Math.PI*e*2,a=1/t-1/n;return Math.min(1024,Math.max(48,Math.ceil(4/3*a*Math.hypot(s,o))))}function Vd(i,e){return e.map(t=>{let n=i?N_(i,t):null;return{nm:t,material:n?.material??0,index_n:n?.index_n??1,index_k:n?.index_k??0,known:n!==null}})}function U_({spectral:i},e){return i?ch(e,[i.shortest_nm,i.longest_nm],F_(i,i.usable_radius)):null}function O_(i,{nm:e,weights:t},n){let r=Vd(i,e),s=new Float32Array(8*e.length);e.forEach((a,l)=>{s.set([a,...r[l].known?t[l]:[0,0,0]],4*l),s.set([r[l].index_n,r[l].index_k,r[l].material,0],4*(e.length+l))});let o=new oi(s,e.length,2,jt,Nt);return o.minFilter=o.magFilter=Ut,o.needsUpdate=!0,{u_quadrature:{value:o},u_wavelengths:{value:e.length},u_structure_scale:{value:n}}}var hh=class{constructor(e){this.gl=e;this.offered=e.getExtension("EXT_disjoint_timer_query_webgl2")!==null}gl;offered;query=null;ms=null;time(e){if(this.collect(),!this.offered||this.query||(this.query=this.gl.createQuery(),!this.query))return e();this.gl.beginQuery(35007,this.query),e(),this.gl.endQuery(35007)}collect(){let{gl:e,query:t}=this;!t||!e.getQueryParameter(t,e.QUERY_RESULT_AVAILABLE)||(e.getParameter(36795)||(this.ms=e.getQueryParameter(t,e.QUERY_RESULT)/1e6),e.deleteQuery(t),this.query=null)}};function B_({width:i,height:e,count:t,texels:n}){let r=new io(n,i,e,t);return r.format=jt,r.type=tn,r.minFilter=r.magFilter=qt,r.wrapS=r.wrapT=si,r.generateMipmaps=!1,r.needsUpdate=!0,r}function fh({width:i,height:e,texels:t}){let n=new oi(t,i,e,jt,Nt);return n.minFilter=n.magFilter=Ut,n.generateMipmaps=!1,n.needsUpdate=!0,n}var z_=i=>Array.from({length:i.length/4},(e,t)=>new Ot(...i.subarray(4*t,4*t+4)));function l3(i){return{...i,permittivity:new xt(...i.permittivity),..."pigment"in i?{pigment:new Ot(...i.pigment)}:{},table_scales:z_(i.table_scales),cross_scales:z_(i.cross_scales)}}function Hd(i){let e=[B_(i.tables),B_(i.cross),fh(i.lobe)],t=[l3(i.params),...e];return{uniforms:Object.fromEntries(xo.map((n,r)=>[n,{value:t[r]}])),dispose:()=>e.forEach(n=>n.dispose())}}var qi=Uint8Array,wa=Uint16Array,c3=Int32Array,k_=new qi([0,0,0,0,0,0,0,0,1,1,1,1,2,2,2,2,3,3,3,3,4,4,4,4,5,5,5,5,0,0,0,0]),V_=new qi([0,0,0,0,1,1,2,2,3,3,4,4,5,5,6,6,7,7,8,8,9,9,10,10,11,11,12,12,13,13,0,0]),u3=new qi([16,17,18,0,8,7,9,6,10,5,11,4,12,3,13,2,14,1,15]),H_=function(i,e){for(var t=new wa(31),n=0;n<31;++n)t[n]=e+=1<<i[n-1];for(var r=new c3(t[30]),n=1;n<30;++n)for(var s=t[n];s<t[n+1];++s)r[s]=s-t[n]<<5|n;return{b:t,r}},G_=H_(k_,2),W_=G_.b,h3=G_.r;W_[28]=258,h3[258]=28;var X_=H_(V_,0),f3=X_.b,e4=X_.r,Xd=new wa(32768);for(Gt=0;Gt<32768;++Gt)fs=(Gt&43690)>>1|(Gt&21845)<<1,fs=(fs&52428)>>2|(fs&13107)<<2,fs=(fs&61680)>>4|(fs&3855)<<4,Xd[Gt]=((fs&65280)>>8|(fs&255)<<8)>>1;var fs,Gt,Wl=(function(i,e,t){for(var n=i.length,r=0,s=new wa(e);r<n;++r)i[r]&&++s[i[r]-1];var o=new wa(e);for(r=1;r<e;++r)o[r]=o[r-1]+s[r-1]<<1;var a;if(t){a=new wa(1<<e);var l=15-e;for(r=0;r<n;++r)if(i[r])for(var c=r<<4|i[r],u=e-i[r],h=o[i[r]-1]++<<u,f=h|(1<<u)-1;h<=f;++h)a[Xd[h]>>l]=c}else for(a=new wa(n),r=0;r<n;++r)i[r]&&(a[r]=Xd[o[i[r]-1]++]>>15-i[r]);return a}),Xl=new qi(288);for(Gt=0;Gt<144;++Gt)Xl[Gt]=8;var Gt;for(Gt=144;Gt<256;++Gt)Xl[Gt]=9;var Gt;for(Gt=256;Gt<280;++Gt)Xl[Gt]=7;var Gt;for(Gt=280;Gt<288;++Gt)Xl[Gt]=8;var Gt,q_=new qi(32);for(Gt=0;Gt<32;++Gt)q_[Gt]=5;var Gt;var d3=Wl(Xl,9,1);var p3=Wl(q_,5,1),Gd=function(i){for(var e=i[0],t=1;t<i.length;++t)i[t]>e&&(e=i[t]);return e},hr=function(i,e,t){var n=e/8|0;return(i[n]|i[n+1]<<8)>>(e&7)&t},Wd=function(i,e){var t=e/8|0;return(i[t]|i[t+1]<<8|i[t+2]<<16)>>(e&7)},m3=function(i){return(i+7)/8|0},g3=function(i,e,t){return(e==null||e<0)&&(e=0),(t==null||t>i.length)&&(t=i.length),new qi(i.subarray(e,t))};var _3=["unexpected EOF","invalid block type","invalid length/literal","invalid distance","stream finished","no stream handler",,"no callback","invalid UTF-8 data","extra field too long","date not in range 1980-2099","filename too long","stream finishing","invalid zip data"],fr=function(i,e,t){var n=new Error(e||_3[i]);if(n.code=i,Error.captureStackTrace&&Error.captureStackTrace(n,fr),!t)throw n;return n},x3=function(i,e,t,n){var r=i.length,s=n?n.length:0;if(!r||e.f&&!e.l)return t||new qi(0);var o=!t,a=o||e.i!=2,l=e.i;o&&(t=new qi(r*3));var c=function(et){var St=t.length;if(et>St){var bt=new qi(Math.max(St*2,et));bt.set(t),t=bt}},u=e.f||0,h=e.p||0,f=e.b||0,d=e.l,m=e.d,b=e.m,g=e.n,_=r*8;do{if(!d){u=hr(i,h,1);var S=hr(i,h+1,3);if(h+=3,S)if(S==1)d=d3,m=p3,b=9,g=5;else if(S==2){var R=hr(i,h,31)+257,y=hr(i,h+10,15)+4,A=R+hr(i,h+5,31)+1;h+=14;for(var V=new qi(A),z=new qi(19),D=0;D<y;++D)z[u3[D]]=hr(i,h+D*3,7);h+=y*3;for(var q=Gd(z),Y=(1<<q)-1,U=Wl(z,q,1),D=0;D<A;){var W=U[hr(i,h,Y)];h+=W&15;var T=W>>4;if(T<16)V[D++]=T;else{var K=0,$=0;for(T==16?($=3+hr(i,h,3),h+=2,K=V[D-1]):T==17?($=3+hr(i,h,7),h+=3):T==18&&($=11+hr(i,h,127),h+=7);$--;)V[D++]=K}}var xe=V.subarray(0,R),ne=V.subarray(R);b=Gd(xe),g=Gd(ne),d=Wl(xe,b,1),m=Wl(ne,g,1)}else fr(1);else{var T=m3(h)+4,M=i[T-4]|i[T-3]<<8,P=T+M;if(P>r){l&&fr(0);break}a&&c(f+M),t.set(i.subarray(T,P),f),e.b=f+=M,e.p=h=P*8,e.f=u;continue}if(h>_){l&&fr(0);break}}a&&c(f+131072);for(var re=(1<<b)-1,de=(1<<g)-1,ge=h;;ge=h){var K=d[Wd(i,h)&re],pe=K>>4;if(h+=K&15,h>_){l&&fr(0);break}if(K||fr(2),pe<256)t[f++]=pe;else if(pe==256){ge=h,d=null;break}else{var se=pe-254;if(pe>264){var D=pe-257,Ee=k_[D];se=hr(i,h,(1<<Ee)-1)+W_[D],h+=Ee}var Pe=m[Wd(i,h)&de],Oe=Pe>>4;Pe||fr(3),h+=Pe&15;var ne=f3[Oe];if(Oe>3){var Ee=V_[Oe];ne+=Wd(i,h)&(1<<Ee)-1,h+=Ee}if(h>_){l&&fr(0);break}a&&c(f+131072);var ye=f+se;if(f<ne){var Ke=s-ne,ft=Math.min(ne,ye);for(Ke+f<0&&fr(3);f<ft;++f)t[f]=n[Ke+f]}for(;f<ye;++f)t[f]=t[f-ne]}}e.l=d,e.p=ge,e.b=f,e.f=u,d&&(u=1,e.m=b,e.d=m,e.n=g)}while(!u);return f!=t.length&&o?g3(t,0,f):t.subarray(0,f)};var v3=new qi(0);var y3=function(i,e){return((i[0]&15)!=8||i[0]>>4>7||(i[0]<<8|i[1])%31)&&fr(6,"invalid zlib data"),(i[1]>>5&1)==+!e&&fr(6,"invalid zlib data: "+(i[1]&32?"need":"unexpected")+" dictionary"),(i[1]>>3&4)+2};function Sa(i,e){return x3(i.subarray(y3(i,e&&e.dictionary),-4),{i:2},e&&e.out,e&&e.dictionary)}var b3=typeof TextDecoder<"u"&&new TextDecoder,w3=0;try{b3.decode(v3,{stream:!0}),w3=1}catch{}var ql=class extends ao{constructor(e){super(e),this.type=tn,this.outputFormat=jt,this.part=0}parse(e){let V=Math.pow(2.7182818,2.2),z=null,D=null;function q(x,p){let v=0;for(let L=0;L<65536;++L)(L==0||x[L>>3]&1<<(L&7))&&(p[v++]=L);let C=v-1;for(;v<65536;)p[v++]=0;return C}function Y(x){for(let p=0;p<16384;p++)x[p]={},x[p].len=0,x[p].lit=0,x[p].p=null}let U={l:0,c:0,lc:0};function W(x,p,v,C,L){for(;v<x;)p=p<<8|Re(C,L),v+=8;v-=x,U.l=p>>v&(1<<x)-1,U.c=p,U.lc=v}let K=new Array(59);function $(x){for(let v=0;v<=58;++v)K[v]=0;for(let v=0;v<65537;++v)K[x[v]]+=1;let p=0;for(let v=58;v>0;--v){let C=p+K[v]>>1;K[v]=p,p=C}for(let v=0;v<65537;++v){let C=x[v];C>0&&(x[v]=C|K[C]++<<6)}}function xe(x,p,v,C,L,O){let N=p,j=0,X=0;for(;C<=L;C++){if(N.value-p.value>v)return!1;W(6,j,X,x,N);let Q=U.l;if(j=U.c,X=U.lc,O[C]=Q,Q==63){if(N.value-p.value>v)throw new Error("THREE.EXRLoader: Something wrong with hufUnpackEncTable");W(8,j,X,x,N);let te=U.l+6;if(j=U.c,X=U.lc,C+te>L+1)throw new Error("THREE.EXRLoader: Something wrong with hufUnpackEncTable");for(;te--;)O[C++]=0;C--}else if(Q>=59){let te=Q-59+2;if(C+te>L+1)throw new Error("THREE.EXRLoader: Something wrong with hufUnpackEncTable");for(;te--;)O[C++]=0;C--}}$(O)}function ne(x){return x&63}function re(x){return x>>6}function de(x,p,v,C){for(;p<=v;p++){let L=re(x[p]),O=ne(x[p]);if(L>>O)throw new Error("THREE.EXRLoader: Invalid table entry");if(O>14){let N=C[L>>O-14];if(N.len)throw new Error("THREE.EXRLoader: Invalid table entry");if(N.lit++,N.p){let j=N.p;N.p=new Array(N.lit);for(let X=0;X<N.lit-1;++X)N.p[X]=j[X]}else N.p=new Array(1);N.p[N.lit-1]=p}else if(O){let N=0;for(let j=1<<14-O;j>0;j--){let X=C[(L<<14-O)+N];if(X.len||X.p)throw new Error("THREE.EXRLoader: Invalid table entry");X.len=O,X.lit=p,N++}}}return!0}let ge={c:0,lc:0};function pe(x,p,v,C){x=x<<8|Re(v,C),p+=8,ge.c=x,ge.lc=p}let se={c:0,lc:0};function Ee(x,p,v,C,L,O,N,j,X){if(x==p){C<8&&(pe(v,C,L,O),v=ge.c,C=ge.lc),C-=8;let Q=v>>C;if(Q=new Uint8Array([Q])[0],j.value+Q>X)return!1;let te=N[j.value-1];for(;Q-- >0;)N[j.value++]=te}else if(j.value<X)N[j.value++]=x;else return!1;se.c=v,se.lc=C}function Pe(x){return x&65535}function Oe(x){let p=Pe(x);return p>32767?p-65536:p}let ye={a:0,b:0};function Ke(x,p){let v=Oe(x),L=Oe(p),O=v+(L&1)+(L>>1),N=O,j=O-L;ye.a=N,ye.b=j}function ft(x,p){let v=Pe(x),C=Pe(p),L=v-(C>>1)&65535,O=C+L-32768&65535;ye.a=O,ye.b=L}function et(x,p,v,C,L,O,N){let j=N<16384,X=v>L?L:v,Q=1,te,fe;for(;Q<=X;)Q<<=1;for(Q>>=1,te=Q,Q>>=1;Q>=1;){fe=0;let le=fe+O*(L-te),ce=O*Q,Se=O*te,Te=C*Q,Ae=C*te,Ve,rt,ve,ot;for(;fe<=le;fe+=Se){let Ce=fe,Xe=fe+C*(v-te);for(;Ce<=Xe;Ce+=Ae){let We=Ce+Te,Ft=Ce+ce,Tt=Ft+Te;j?(Ke(x[Ce+p],x[Ft+p]),Ve=ye.a,ve=ye.b,Ke(x[We+p],x[Tt+p]),rt=ye.a,ot=ye.b,Ke(Ve,rt),x[Ce+p]=ye.a,x[We+p]=ye.b,Ke(ve,ot),x[Ft+p]=ye.a,x[Tt+p]=ye.b):(ft(x[Ce+p],x[Ft+p]),Ve=ye.a,ve=ye.b,ft(x[We+p],x[Tt+p]),rt=ye.a,ot=ye.b,ft(Ve,rt),x[Ce+p]=ye.a,x[We+p]=ye.b,ft(ve,ot),x[Ft+p]=ye.a,x[Tt+p]=ye.b)}if(v&Q){let We=Ce+ce;j?Ke(x[Ce+p],x[We+p]):ft(x[Ce+p],x[We+p]),Ve=ye.a,x[We+p]=ye.b,x[Ce+p]=Ve}}if(L&Q){let Ce=fe,Xe=fe+C*(v-te);for(;Ce<=Xe;Ce+=Ae){let We=Ce+Te;j?Ke(x[Ce+p],x[We+p]):ft(x[Ce+p],x[We+p]),Ve=ye.a,x[We+p]=ye.b,x[Ce+p]=Ve}}te=Q,Q>>=1}return fe}function St(x,p,v,C,L,O,N,j,X){let Q=0,te=0,fe=N,le=Math.trunc(C.value+(L+7)/8);for(;C.value<le;)for(pe(Q,te,v,C),Q=ge.c,te=ge.lc;te>=14;){let Se=Q>>te-14&16383,Te=p[Se];if(Te.len)te-=Te.len,Ee(Te.lit,O,Q,te,v,C,j,X,fe),Q=se.c,te=se.lc;else{if(!Te.p)throw new Error("THREE.EXRLoader: hufDecode issues");let Ae;for(Ae=0;Ae<Te.lit;Ae++){let Ve=ne(x[Te.p[Ae]]);for(;te<Ve&&C.value<le;)pe(Q,te,v,C),Q=ge.c,te=ge.lc;if(te>=Ve&&re(x[Te.p[Ae]])==(Q>>te-Ve&(1<<Ve)-1)){te-=Ve,Ee(Te.p[Ae],O,Q,te,v,C,j,X,fe),Q=se.c,te=se.lc;break}}if(Ae==Te.lit)throw new Error("THREE.EXRLoader: hufDecode issues")}}let ce=8-L&7;for(Q>>=ce,te-=ce;te>0;){let Se=p[Q<<14-te&16383];if(Se.len)te-=Se.len,Ee(Se.lit,O,Q,te,v,C,j,X,fe),Q=se.c,te=se.lc;else throw new Error("THREE.EXRLoader: hufDecode issues")}return!0}function bt(x,p,v,C,L,O){let N={value:0},j=v.value,X=he(p,v),Q=he(p,v);v.value+=4;let te=he(p,v);if(v.value+=4,X<0||X>=65537||Q<0||Q>=65537)throw new Error("THREE.EXRLoader: Something wrong with HUF_ENCSIZE");let fe=new Array(65537),le=new Array(16384);Y(le);let ce=C-(v.value-j);if(xe(x,v,ce,X,Q,fe),te>8*(C-(v.value-j)))throw new Error("THREE.EXRLoader: Something wrong with hufUncompress");de(fe,X,Q,le),St(fe,le,x,v,te,Q,O,L,N)}function vt(x,p,v){for(let C=0;C<v;++C)p[C]=x[p[C]]}function Zt(x){for(let p=1;p<x.length;p++){let v=x[p-1]+x[p]-128;x[p]=v}}function kt(x,p){let v=0,C=Math.floor((x.length+1)/2),L=0,O=x.length-1;for(;!(L>O||(p[L++]=x[v++],L>O));)p[L++]=x[C++]}function mn(x){let p=x.byteLength,v=new Array,C=0,L=new DataView(x);for(;p>0;){let O=L.getInt8(C++);if(O<0){let N=-O;p-=N+1;for(let j=0;j<N;j++)v.push(L.getUint8(C++))}else{let N=O;p-=2;let j=L.getUint8(C++);for(let X=0;X<N+1;X++)v.push(j)}}return v}function Xt(x,p,v,C,L,O){let N=new DataView(O.buffer),j=v[x.idx[0]].width,X=v[x.idx[0]].height,Q=3,te=Math.floor(j/8),fe=Math.ceil(j/8),le=Math.ceil(X/8),ce=j-(fe-1)*8,Se=X-(le-1)*8,Te={value:0},Ae=new Array(Q),Ve=new Array(Q),rt=new Array(Q),ve=new Array(Q),ot=new Array(Q);for(let Xe=0;Xe<Q;++Xe)ot[Xe]=p[x.idx[Xe]],Ae[Xe]=Xe<1?0:Ae[Xe-1]+fe*le,Ve[Xe]=new Float32Array(64),rt[Xe]=new Uint16Array(64),ve[Xe]=new Uint16Array(fe*64);for(let Xe=0;Xe<le;++Xe){let We=8;Xe==le-1&&(We=Se);let Ft=8;for(let ut=0;ut<fe;++ut){ut==fe-1&&(Ft=ce);for(let qe=0;qe<Q;++qe)rt[qe].fill(0),rt[qe][0]=L[Ae[qe]++],Pt(Te,C,rt[qe]),Tn(rt[qe],Ve[qe]),ln(Ve[qe]);Q==3&&An(Ve);for(let qe=0;qe<Q;++qe)yt(Ve[qe],ve[qe],ut*64)}let Tt=0;for(let ut=0;ut<Q;++ut){let qe=v[x.idx[ut]].type;for(let At=8*Xe;At<8*Xe+We;++At){Tt=ot[ut][At];for(let Jt=0;Jt<te;++Jt){let at=Jt*64+(At&7)*8;N.setUint16(Tt+0*qe,ve[ut][at+0],!0),N.setUint16(Tt+2*qe,ve[ut][at+1],!0),N.setUint16(Tt+4*qe,ve[ut][at+2],!0),N.setUint16(Tt+6*qe,ve[ut][at+3],!0),N.setUint16(Tt+8*qe,ve[ut][at+4],!0),N.setUint16(Tt+10*qe,ve[ut][at+5],!0),N.setUint16(Tt+12*qe,ve[ut][at+6],!0),N.setUint16(Tt+14*qe,ve[ut][at+7],!0),Tt+=16*qe}}if(te!=fe)for(let At=8*Xe;At<8*Xe+We;++At){let Jt=ot[ut][At]+8*te*2*qe,at=te*64+(At&7)*8;for(let Vt=0;Vt<Ft;++Vt)N.setUint16(Jt+Vt*2*qe,ve[ut][at+Vt],!0)}}}let Ce=new Uint16Array(j);N=new DataView(O.buffer);for(let Xe=0;Xe<Q;++Xe){v[x.idx[Xe]].decoded=!0;let We=v[x.idx[Xe]].type;if(v[Xe].type==2)for(let Ft=0;Ft<X;++Ft){let Tt=ot[Xe][Ft];for(let ut=0;ut<j;++ut)Ce[ut]=N.getUint16(Tt+ut*2*We,!0);for(let ut=0;ut<j;++ut)N.setFloat32(Tt+ut*2*We,Ue.fromHalfFloat(Ce[ut]),!0)}}}function Dn(x,p,v,C,L,O){let N=new DataView(O.buffer),j=v[x],X=j.width,Q=j.height,te=Math.ceil(X/8),fe=Math.ceil(Q/8),le=Math.floor(X/8),ce=X-(te-1)*8,Se=Q-(fe-1)*8,Te={value:0},Ae=0,Ve=new Float32Array(64),rt=new Uint16Array(64),ve=new Uint16Array(te*64);for(let ot=0;ot<fe;++ot){let Ce=8;ot==fe-1&&(Ce=Se);for(let Xe=0;Xe<te;++Xe)rt.fill(0),rt[0]=L[Ae++],Pt(Te,C,rt),Tn(rt,Ve),ln(Ve),yt(Ve,ve,Xe*64);for(let Xe=8*ot;Xe<8*ot+Ce;++Xe){let We=p[x][Xe];for(let Ft=0;Ft<le;++Ft){let Tt=Ft*64+(Xe&7)*8;for(let ut=0;ut<8;++ut)N.setUint16(We+ut*2*j.type,ve[Tt+ut],!0);We+=16*j.type}if(te!=le){let Ft=le*64+(Xe&7)*8;for(let Tt=0;Tt<ce;++Tt)N.setUint16(We+Tt*2*j.type,ve[Ft+Tt],!0)}}}j.decoded=!0}function Pt(x,p,v){let C,L=1;for(;L<64;)C=p[x.value],C==65280?L=64:C>>8==255?L+=C&255:(v[L]=C,L++),x.value++}function Tn(x,p){p[0]=Ue.fromHalfFloat(x[0]),p[1]=Ue.fromHalfFloat(x[1]),p[2]=Ue.fromHalfFloat(x[5]),p[3]=Ue.fromHalfFloat(x[6]),p[4]=Ue.fromHalfFloat(x[14]),p[5]=Ue.fromHalfFloat(x[15]),p[6]=Ue.fromHalfFloat(x[27]),p[7]=Ue.fromHalfFloat(x[28]),p[8]=Ue.fromHalfFloat(x[2]),p[9]=Ue.fromHalfFloat(x[4]),p[10]=Ue.fromHalfFloat(x[7]),p[11]=Ue.fromHalfFloat(x[13]),p[12]=Ue.fromHalfFloat(x[16]),p[13]=Ue.fromHalfFloat(x[26]),p[14]=Ue.fromHalfFloat(x[29]),p[15]=Ue.fromHalfFloat(x[42]),p[16]=Ue.fromHalfFloat(x[3]),p[17]=Ue.fromHalfFloat(x[8]),p[18]=Ue.fromHalfFloat(x[12]),p[19]=Ue.fromHalfFloat(x[17]),p[20]=Ue.fromHalfFloat(x[25]),p[21]=Ue.fromHalfFloat(x[30]),p[22]=Ue.fromHalfFloat(x[41]),p[23]=Ue.fromHalfFloat(x[43]),p[24]=Ue.fromHalfFloat(x[9]),p[25]=Ue.fromHalfFloat(x[11]),p[26]=Ue.fromHalfFloat(x[18]),p[27]=Ue.fromHalfFloat(x[24]),p[28]=Ue.fromHalfFloat(x[31]),p[29]=Ue.fromHalfFloat(x[40]),p[30]=Ue.fromHalfFloat(x[44]),p[31]=Ue.fromHalfFloat(x[53]),p[32]=Ue.fromHalfFloat(x[10]),p[33]=Ue.fromHalfFloat(x[19]),p[34]=Ue.fromHalfFloat(x[23]),p[35]=Ue.fromHalfFloat(x[32]),p[36]=Ue.fromHalfFloat(x[39]),p[37]=Ue.fromHalfFloat(x[45]),p[38]=Ue.fromHalfFloat(x[52]),p[39]=Ue.fromHalfFloat(x[54]),p[40]=Ue.fromHalfFloat(x[20]),p[41]=Ue.fromHalfFloat(x[22]),p[42]=Ue.fromHalfFloat(x[33]),p[43]=Ue.fromHalfFloat(x[38]),p[44]=Ue.fromHalfFloat(x[46]),p[45]=Ue.fromHalfFloat(x[51]),p[46]=Ue.fromHalfFloat(x[55]),p[47]=Ue.fromHalfFloat(x[60]),p[48]=Ue.fromHalfFloat(x[21]),p[49]=Ue.fromHalfFloat(x[34]),p[50]=Ue.fromHalfFloat(x[37]),p[51]=Ue.fromHalfFloat(x[47]),p[52]=Ue.fromHalfFloat(x[50]),p[53]=Ue.fromHalfFloat(x[56]),p[54]=Ue.fromHalfFloat(x[59]),p[55]=Ue.fromHalfFloat(x[61]),p[56]=Ue.fromHalfFloat(x[35]),p[57]=Ue.fromHalfFloat(x[36]),p[58]=Ue.fromHalfFloat(x[48]),p[59]=Ue.fromHalfFloat(x[49]),p[60]=Ue.fromHalfFloat(x[57]),p[61]=Ue.fromHalfFloat(x[58]),p[62]=Ue.fromHalfFloat(x[62]),p[63]=Ue.fromHalfFloat(x[63])}function ln(x){let p=.5*Math.cos(.7853975),v=.5*Math.cos(3.14159/16),C=.5*Math.cos(3.14159/8),L=.5*Math.cos(3*3.14159/16),O=.5*Math.cos(5*3.14159/16),N=.5*Math.cos(3*3.14159/8),j=.5*Math.cos(7*3.14159/16),X=new Array(4),Q=new Array(4),te=new Array(4),fe=new Array(4);for(let le=0;le<8;++le){let ce=le*8;X[0]=C*x[ce+2],X[1]=N*x[ce+2],X[2]=C*x[ce+6],X[3]=N*x[ce+6],Q[0]=v*x[ce+1]+L*x[ce+3]+O*x[ce+5]+j*x[ce+7],Q[1]=L*x[ce+1]-j*x[ce+3]-v*x[ce+5]-O*x[ce+7],Q[2]=O*x[ce+1]-v*x[ce+3]+j*x[ce+5]+L*x[ce+7],Q[3]=j*x[ce+1]-O*x[ce+3]+L*x[ce+5]-v*x[ce+7],te[0]=p*(x[ce+0]+x[ce+4]),te[3]=p*(x[ce+0]-x[ce+4]),te[1]=X[0]+X[3],te[2]=X[1]-X[2],fe[0]=te[0]+te[1],fe[1]=te[3]+te[2],fe[2]=te[3]-te[2],fe[3]=te[0]-te[1],x[ce+0]=fe[0]+Q[0],x[ce+1]=fe[1]+Q[1],x[ce+2]=fe[2]+Q[2],x[ce+3]=fe[3]+Q[3],x[ce+4]=fe[3]-Q[3],x[ce+5]=fe[2]-Q[2],x[ce+6]=fe[1]-Q[1],x[ce+7]=fe[0]-Q[0]}for(let le=0;le<8;++le)X[0]=C*x[16+le],X[1]=N*x[16+le],X[2]=C*x[48+le],X[3]=N*x[48+le],Q[0]=v*x[8+le]+L*x[24+le]+O*x[40+le]+j*x[56+le],Q[1]=L*x[8+le]-j*x[24+le]-v*x[40+le]-O*x[56+le],Q[2]=O*x[8+le]-v*x[24+le]+j*x[40+le]+L*x[56+le],Q[3]=j*x[8+le]-O*x[24+le]+L*x[40+le]-v*x[56+le],te[0]=p*(x[le]+x[32+le]),te[3]=p*(x[le]-x[32+le]),te[1]=X[0]+X[3],te[2]=X[1]-X[2],fe[0]=te[0]+te[1],fe[1]=te[3]+te[2],fe[2]=te[3]-te[2],fe[3]=te[0]-te[1],x[0+le]=fe[0]+Q[0],x[8+le]=fe[1]+Q[1],x[16+le]=fe[2]+Q[2],x[24+le]=fe[3]+Q[3],x[32+le]=fe[3]-Q[3],x[40+le]=fe[2]-Q[2],x[48+le]=fe[1]-Q[1],x[56+le]=fe[0]-Q[0]}function An(x){for(let p=0;p<64;++p){let v=x[0][p],C=x[1][p],L=x[2][p];x[0][p]=v+1.5747*L,x[1][p]=v-.1873*C-.4682*L,x[2][p]=v+1.8556*C}}let G=new Float32Array(1),He=new Uint32Array(G.buffer);function ct(x){G[0]=x;let p=He[0],v=p>>>16&32768,C=p&2147483647;if(C>=1199570944)return v|(C>2139095040?32256:31744);if(C<947912704)return G[0]=Math.abs(x)+.5,v|He[0]-1056964608;let L=C+4095+(C>>>13&1);return v|L-939524096>>>13}function yt(x,p,v){if(D===null){D=new Uint16Array(65536);for(let C=1;C<65536;++C){if((C&31744)===31744)continue;let L=Ue.fromHalfFloat(C),O=Math.abs(L),N=O<=1?Math.pow(O,2.2):Math.pow(V,O-1);D[C]=ct(L<0?-N:N)}}for(let C=0;C<64;++C)p[v+C]=D[ct(x[C])]}function De(x){return new DataView(x.array.buffer,x.offset.value,x.size)}function Kt(x){let p=x.viewer.buffer.slice(x.offset.value,x.offset.value+x.size),v=new Uint8Array(mn(p)),C=new Uint8Array(v.length);return Zt(v),kt(v,C),new DataView(C.buffer)}function je(x){let p=x.array.slice(x.offset.value,x.offset.value+x.size),v=Sa(p),C=new Uint8Array(v.length);return Zt(v),kt(v,C),new DataView(C.buffer)}function lt(x){let p=x.viewer,v={value:x.offset.value},C=new Uint16Array(x.columns*x.lines*(x.inputChannels.length*x.type)),L=new Uint8Array(8192),O=0,N=new Array(x.inputChannels.length);for(let Se=0,Te=x.inputChannels.length;Se<Te;Se++)N[Se]={},N[Se].start=O,N[Se].end=N[Se].start,N[Se].nx=x.columns,N[Se].ny=x.lines,N[Se].size=x.type,O+=N[Se].nx*N[Se].ny*N[Se].size;let j=Le(p,v),X=Le(p,v);if(X>=8192)throw new Error("THREE.EXRLoader: Something is wrong with PIZ_COMPRESSION BITMAP_SIZE");if(j<=X)for(let Se=0;Se<X-j+1;Se++)L[Se+j]=H(p,v);let Q=new Uint16Array(65536),te=q(L,Q),fe=he(p,v);bt(x.array,p,v,fe,C,O);for(let Se=0;Se<x.inputChannels.length;++Se){let Te=N[Se];for(let Ae=0;Ae<N[Se].size;++Ae)et(C,Te.start+Ae,Te.nx,Te.size,Te.ny,Te.nx*Te.size,te)}vt(Q,C,O);let le=0,ce=new Uint8Array(C.buffer.byteLength);for(let Se=0;Se<x.lines;Se++)for(let Te=0;Te<x.inputChannels.length;Te++){let Ae=N[Te],Ve=Ae.nx*Ae.size,rt=new Uint8Array(C.buffer,Ae.end*2,Ve*2);ce.set(rt,le),le+=Ve*2,Ae.end+=Ve}return new DataView(ce.buffer)}function F(x){let p=x.array.slice(x.offset.value,x.offset.value+x.size),v=Sa(p),C=x.inputChannels.length*x.lines*x.columns*x.totalBytes,L=new ArrayBuffer(C),O=new DataView(L),N=0,j=0,X=new Array(4);for(let Q=0;Q<x.lines;Q++)for(let te=0;te<x.inputChannels.length;te++){let fe=0;switch(x.inputChannels[te].pixelType){case 1:X[0]=N,X[1]=X[0]+x.columns,N=X[1]+x.columns;for(let ce=0;ce<x.columns;++ce){let Se=v[X[0]++]<<8|v[X[1]++];fe+=Se,O.setUint16(j,fe,!0),j+=2}break;case 2:X[0]=N,X[1]=X[0]+x.columns,X[2]=X[1]+x.columns,N=X[2]+x.columns;for(let ce=0;ce<x.columns;++ce){let Se=v[X[0]++]<<24|v[X[1]++]<<16|v[X[2]++]<<8;fe+=Se,O.setUint32(j,fe,!0),j+=4}break}}return O}function E(x){let p=x.array,v=x.offset.value,C=x.columns,L=x.lines,O=x.inputChannels,N=x.totalBytes,j=yn.compression==="B44A_COMPRESSION",X=new Uint8Array(L*C*N),Q=new Uint16Array(16),te=0;for(let fe=0;fe<O.length;fe++){let le=O[fe],ce=le.pixelType*2,Se=Math.ceil(C/le.xSampling),Te=Math.ceil(L/le.ySampling),Ae=le.xSampling===1&&le.ySampling===1;if(le.pixelType!==1){for(let ve=0;ve<Te;ve++)if(Ae){let ot=ve*C*N+te*C;for(let Ce=0;Ce<Se*ce;Ce++)X[ot+Ce]=p[v++]}else v+=Se*ce;te+=ce;continue}let Ve=Math.ceil(Se/4),rt=Math.ceil(Te/4);for(let ve=0;ve<rt;ve++)for(let ot=0;ot<Ve;ot++){if(j&&p[v+2]>=52){let Ce=p[v]<<8|p[v+1],Xe=Ce&32768?Ce&32767:~Ce&65535;Q.fill(Xe),v+=3}else{let Ce=p[v]<<8|p[v+1],Xe=p[v+2]>>2,We=32<<Xe,Ft=Ce+((p[v+2]<<4|p[v+3]>>4)&63)*(1<<Xe)-We&65535,Tt=Ft+((p[v+3]<<2|p[v+4]>>6)&63)*(1<<Xe)-We&65535,ut=Tt+(p[v+4]&63)*(1<<Xe)-We&65535,qe=Ce+(p[v+5]>>2&63)*(1<<Xe)-We&65535,At=Ft+((p[v+5]<<4|p[v+6]>>4)&63)*(1<<Xe)-We&65535,Jt=Tt+((p[v+6]<<2|p[v+7]>>6)&63)*(1<<Xe)-We&65535,at=ut+(p[v+7]&63)*(1<<Xe)-We&65535,Vt=qe+(p[v+8]>>2&63)*(1<<Xe)-We&65535,bn=At+((p[v+8]<<4|p[v+9]>>4)&63)*(1<<Xe)-We&65535,xr=Jt+((p[v+9]<<2|p[v+10]>>6)&63)*(1<<Xe)-We&65535,Ti=at+(p[v+10]&63)*(1<<Xe)-We&65535,er=Vt+(p[v+11]>>2&63)*(1<<Xe)-We&65535,ys=bn+((p[v+11]<<4|p[v+12]>>4)&63)*(1<<Xe)-We&65535,bs=xr+((p[v+12]<<2|p[v+13]>>6)&63)*(1<<Xe)-We&65535,tr=Ti+(p[v+13]&63)*(1<<Xe)-We&65535,ki=[Ce,qe,Vt,er,Ft,At,bn,ys,Tt,Jt,xr,bs,ut,at,Ti,tr];for(let Hr=0;Hr<16;Hr++)Q[Hr]=ki[Hr]&32768?ki[Hr]&32767:~ki[Hr]&65535;v+=14}if(le.pLinear){if(z===null){z=new Uint16Array(65536);for(let Ce=0;Ce<65536;Ce++)if((Ce&31744)===31744||Ce>32768)z[Ce]=0;else{let Xe=Ue.fromHalfFloat(Ce);z[Ce]=Xe<=0?0:Ue.toHalfFloat(8*Math.log(Xe))}}for(let Ce=0;Ce<16;Ce++)Q[Ce]=z[Q[Ce]]}for(let Ce=0;Ce<4;Ce++){let Xe=ve*4+Ce;if(!(Xe>=Te))for(let We=0;We<4;We++){let Ft=ot*4+We;if(Ft>=Se)continue;let Tt=Q[Ce*4+We];for(let ut=0;ut<le.ySampling;ut++){let qe=Xe*le.ySampling+ut;if(!(qe>=L))for(let At=0;At<le.xSampling;At++){let Jt=Ft*le.xSampling+At;if(Jt>=C)continue;let at=qe*C*N+te*C+Jt*2;X[at]=Tt&255,X[at+1]=Tt>>8&255}}}}}te+=2}return new DataView(X.buffer)}function ee(x){let p=x.viewer,v={value:x.offset.value},C=new Uint8Array(x.columns*x.lines*(x.inputChannels.length*x.type*2)),L={version:ue(p,v),unknownUncompressedSize:ue(p,v),unknownCompressedSize:ue(p,v),acCompressedSize:ue(p,v),dcCompressedSize:ue(p,v),rleCompressedSize:ue(p,v),rleUncompressedSize:ue(p,v),rleRawSize:ue(p,v),totalAcUncompressedCount:ue(p,v),totalDcUncompressedCount:ue(p,v),acCompression:ue(p,v)};if(L.version<2)throw new Error("THREE.EXRLoader: "+yn.compression+" version "+L.version+" is unsupported");let O=new Array,N=Le(p,v)-2;for(;N>0;){let Te=be(p.buffer,v),Ae=H(p,v),Ve=Ae>>2&3,rt=(Ae>>4)-1,ve=new Int8Array([rt])[0],ot=H(p,v);O.push({name:Te,index:ve,type:ot,compression:Ve}),N-=Te.length+3}let j=yn.channels,X=new Array(x.inputChannels.length);for(let Te=0;Te<x.inputChannels.length;++Te){let Ae=X[Te]={},Ve=j[Te];Ae.name=Ve.name,Ae.compression=0,Ae.decoded=!1,Ae.type=Ve.pixelType,Ae.pLinear=Ve.pLinear,Ae.width=x.columns,Ae.height=x.lines}let Q={idx:new Array(3)};for(let Te=0;Te<x.inputChannels.length;++Te){let Ae=X[Te],Ve=Ae.name.lastIndexOf("."),rt=Ve>=0?Ae.name.substring(Ve+1):Ae.name;for(let ve=0;ve<O.length;++ve){let ot=O[ve];rt===ot.name&&Ae.type===ot.type&&(Ae.compression=ot.compression,ot.index>=0&&(Q.idx[ot.index]=Te),Ae.offset=Te)}}let te,fe,le;if(L.acCompressedSize>0)switch(L.acCompression){case 0:te=new Uint16Array(L.totalAcUncompressedCount),bt(x.array,p,v,L.acCompressedSize,te,L.totalAcUncompressedCount);break;case 1:let Te=x.array.slice(v.value,v.value+L.totalAcUncompressedCount),Ae=Sa(Te);te=new Uint16Array(Ae.buffer),v.value+=L.totalAcUncompressedCount;break}if(L.dcCompressedSize>0){let Te={array:x.array,offset:v,size:L.dcCompressedSize};fe=new Uint16Array(je(Te).buffer),v.value+=L.dcCompressedSize}if(L.rleRawSize>0){let Te=x.array.slice(v.value,v.value+L.rleCompressedSize),Ae=Sa(Te);le=mn(Ae.buffer),v.value+=L.rleCompressedSize}let ce=0,Se=new Array(X.length);for(let Te=0;Te<Se.length;++Te)Se[Te]=new Array;for(let Te=0;Te<x.lines;++Te)for(let Ae=0;Ae<X.length;++Ae)Se[Ae].push(ce),ce+=X[Ae].width*x.type*2;Q.idx[0]!==void 0&&X[Q.idx[0]]&&Xt(Q,Se,X,te,fe,C);for(let Te=0;Te<X.length;++Te){let Ae=X[Te];if(!Ae.decoded)switch(Ae.compression){case 2:let Ve=0,rt=0;for(let ve=0;ve<x.lines;++ve){let ot=Se[Te][Ve];for(let Ce=0;Ce<Ae.width;++Ce){for(let Xe=0;Xe<2*Ae.type;++Xe)C[ot++]=le[rt+Xe*Ae.width*Ae.height];rt++}Ve++}break;case 1:Dn(Te,Se,X,te,fe,C);break;default:throw new Error("THREE.EXRLoader: unsupported channel compression")}}return new DataView(C.buffer)}function be(x,p){let v=new Uint8Array(x),C=0;for(;v[p.value+C]!=0;)C+=1;let L=new TextDecoder().decode(v.slice(p.value,p.value+C));return p.value=p.value+C+1,L}function me(x,p,v){let C=new TextDecoder().decode(new Uint8Array(x).slice(p.value,p.value+v));return p.value=p.value+v,C}function Ne(x,p){let v=ae(x,p),C=he(x,p);return[v,C]}function Fe(x,p){let v=he(x,p),C=he(x,p);return[v,C]}function ae(x,p){let v=x.getInt32(p.value,!0);return p.value=p.value+4,v}function he(x,p){let v=x.getUint32(p.value,!0);return p.value=p.value+4,v}function Re(x,p){let v=x[p.value];return p.value=p.value+1,v}function H(x,p){let v=x.getUint8(p.value);return p.value=p.value+1,v}let ue=function(x,p){let v=Number(x.getBigInt64(p.value,!0));return p.value+=8,v};function oe(x,p){let v=x.getFloat32(p.value,!0);return p.value+=4,v}function ke(x,p){return Ue.toHalfFloat(oe(x,p))}function Le(x,p){let v=x.getUint16(p.value,!0);return p.value+=2,v}function Be(x,p){return Ue.fromHalfFloat(Le(x,p))}function tt(x,p,v,C){let L=v.value,O=[];for(;v.value<L+C-1;){let N=be(p,v),j=ae(x,v),X=H(x,v);v.value+=3;let Q=ae(x,v),te=ae(x,v);O.push({name:N,pixelType:j,pLinear:X,xSampling:Q,ySampling:te})}return v.value+=1,O}function pt(x,p){let v=oe(x,p),C=oe(x,p),L=oe(x,p),O=oe(x,p),N=oe(x,p),j=oe(x,p),X=oe(x,p),Q=oe(x,p);return{redX:v,redY:C,greenX:L,greenY:O,blueX:N,blueY:j,whiteX:X,whiteY:Q}}function we(x,p){let v=["NO_COMPRESSION","RLE_COMPRESSION","ZIPS_COMPRESSION","ZIP_COMPRESSION","PIZ_COMPRESSION","PXR24_COMPRESSION","B44_COMPRESSION","B44A_COMPRESSION","DWAA_COMPRESSION","DWAB_COMPRESSION"],C=H(x,p);return v[C]}function Je(x,p){let v=ae(x,p),C=ae(x,p),L=ae(x,p),O=ae(x,p);return{xMin:v,yMin:C,xMax:L,yMax:O}}function mt(x,p){let v=["INCREASING_Y","DECREASING_Y","RANDOM_Y"],C=H(x,p);return v[C]}function Ge(x,p){let v=["ENVMAP_LATLONG","ENVMAP_CUBE"],C=H(x,p);return v[C]}function Mt(x,p){let v=["ONE_LEVEL","MIPMAP_LEVELS","RIPMAP_LEVELS"],C=["ROUND_DOWN","ROUND_UP"],L=he(x,p),O=he(x,p),N=H(x,p);return{xSize:L,ySize:O,levelMode:v[N&15],roundingMode:C[N>>4]}}function nn(x,p){let v=oe(x,p),C=oe(x,p);return[v,C]}function jn(x,p){let v=oe(x,p),C=oe(x,p),L=oe(x,p);return[v,C,L]}function Ws(x,p,v,C,L){if(C==="string"||C==="stringvector"||C==="iccProfile")return me(p,v,L);if(C==="chlist")return tt(x,p,v,L);if(C==="chromaticities")return pt(x,v);if(C==="compression")return we(x,v);if(C==="box2i")return Je(x,v);if(C==="envmap")return Ge(x,v);if(C==="tiledesc")return Mt(x,v);if(C==="lineOrder")return mt(x,v);if(C==="float")return oe(x,v);if(C==="v2f")return nn(x,v);if(C==="v3f")return jn(x,v);if(C==="int")return ae(x,v);if(C==="rational")return Ne(x,v);if(C==="timecode")return Fe(x,v);if(C==="preview"||C==="deepImageState"||C==="idmanifest")return v.value+=L,"skipped";v.value+=L}function _s(x,p){let v=Math.log2(x);return p=="ROUND_DOWN"?Math.floor(v):Math.ceil(v)}function ka(x,p,v){let C=0;switch(x.levelMode){case"ONE_LEVEL":C=1;break;case"MIPMAP_LEVELS":C=_s(Math.max(p,v),x.roundingMode)+1;break;case"RIPMAP_LEVELS":throw new Error("THREE.EXRLoader: RIPMAP_LEVELS tiles currently unsupported.")}return C}function Xs(x,p,v,C){let L=new Array(x);for(let O=0;O<x;O++){let N=1<<O,j=p/N|0;C=="ROUND_UP"&&j*N<p&&(j+=1);let X=Math.max(j,1);L[O]=(X+v-1)/v|0}return L}function zi(){let x=this,p=x.offset,v={value:0};for(let C=0;C<x.tileCount;C++){let L=ae(x.viewer,p),O=ae(x.viewer,p);p.value+=8,x.size=he(x.viewer,p);let N=L*x.blockWidth,j=O*x.blockHeight;x.columns=N+x.blockWidth>x.width?x.width-N:x.blockWidth,x.lines=j+x.blockHeight>x.height?x.height-j:x.blockHeight;let X=x.columns*x.totalBytes,te=x.size<x.lines*X?x.uncompress(x):De(x);p.value+=x.size;for(let fe=0;fe<x.lines;fe++){let le=fe*x.columns*x.totalBytes;for(let ce=0;ce<x.inputChannels.length;ce++){let Se=yn.channels[ce].name,Te=x.channelByteOffsets[Se]*x.columns,Ae=x.decodeChannels[Se];if(Ae===void 0)continue;v.value=le+Te;let Ve=(x.height-(1+j+fe))*x.outLineWidth;for(let rt=0;rt<x.columns;rt++){let ve=Ve+(rt+N)*x.outputChannels+Ae;x.byteArray[ve]=x.getter(te,v)}}}}}function ji(){let x=this,p=x.offset,v={value:0};for(let C=0;C<x.height/x.blockHeight;C++){let L=ae(x.viewer,p)-yn.dataWindow.yMin;x.size=he(x.viewer,p),x.lines=L+x.blockHeight>x.height?x.height-L:x.blockHeight;let O=x.columns*x.totalBytes,j=x.size<x.lines*O?x.uncompress(x):De(x);p.value+=x.size;for(let X=0;X<x.lines;X++){let Q=L+X,te=X*O,fe=(x.height-1-Q)*x.outLineWidth;for(let le=0;le<x.inputChannels.length;le++){let ce=yn.channels[le].name,Se=x.channelByteOffsets[ce]*x.columns,Te=x.decodeChannels[ce];if(Te!==void 0){v.value=te+Se;for(let Ae=0;Ae<x.columns;Ae++){let Ve=fe+Ae*x.outputChannels+Te;x.byteArray[Ve]=x.getter(j,v)}}}}}}function Qi(){let x=this,p=x.chunkOffsets,v={value:0};for(let C=0;C<p.length;C++){let L={value:p[C]};L.value+=4;let O=ae(x.viewer,L)-yn.dataWindow.yMin;x.size=he(x.viewer,L),x.lines=O+x.blockHeight>x.height?x.height-O:x.blockHeight;let N=x.columns*x.totalBytes,j=x.size<x.lines*N,X=x.offset;x.offset=L;let Q=j?x.uncompress(x):De(x);x.offset=X;for(let te=0;te<x.lines;te++){let fe=O+te,le=te*N,ce=(x.height-1-fe)*x.outLineWidth;for(let Se=0;Se<x.inputChannels.length;Se++){let Te=yn.channels[Se].name,Ae=x.channelByteOffsets[Te]*x.columns,Ve=x.decodeChannels[Te];if(Ve!==void 0){v.value=le+Ae;for(let rt=0;rt<x.columns;rt++){let ve=ce+rt*x.outputChannels+Ve;x.byteArray[ve]=x.getter(Q,v)}}}}}}function xs(x,p,v,C){if(v===0)return null;let L=x.slice(p,p+v);switch(C){case"NO_COMPRESSION":return new DataView(L.buffer,L.byteOffset,L.byteLength);case"RLE_COMPRESSION":{let O=new Uint8Array(mn(L.buffer.slice(L.byteOffset,L.byteOffset+L.byteLength))),N=new Uint8Array(O.length);return Zt(O),kt(O,N),new DataView(N.buffer)}case"ZIPS_COMPRESSION":{let O=Sa(L),N=new Uint8Array(O.length);return Zt(O),kt(O,N),new DataView(N.buffer)}default:throw new Error("THREE.EXRLoader: "+C+" is unsupported for deep data")}}function Mi(){let x=this,p=x.chunkOffsets,v=x.width,C=x.height,L=x.deepChannels,O=yn.compression,N=x.multiPart,j=x.decodeChannels,X=x.outputChannels,Q=x.byteArray instanceof Uint16Array,te=-1;for(let fe=0;fe<L.length;fe++)if(L[fe].name==="A"){te=fe;break}for(let fe=0;fe<p.length;fe++){let le={value:p[fe]};N&&(le.value+=4);let ce=ae(x.viewer,le)-yn.dataWindow.yMin,Se=ue(x.viewer,le),Te=ue(x.viewer,le);ue(x.viewer,le);let Ae=xs(x.array,le.value,Se,O);if(le.value+=Se,Ae===null)continue;let Ve=new Uint32Array(v);for(let We=0;We<v;We++)Ve[We]=Ae.getUint32(We*4,!0);let rt=Ve[v-1];if(rt===0){le.value+=Te;continue}let ve=xs(x.array,le.value,Te,O),ot=[],Ce=0;for(let We=0;We<L.length;We++)ot.push(Ce),Ce+=rt*L[We].bytesPerSample;let Xe=(C-1-ce)*x.outLineWidth;for(let We=0;We<v;We++){let Ft=We===0?0:Ve[We-1],ut=Ve[We]-Ft;if(ut===0)continue;let qe=new Float32Array(X),At=0;for(let at=0;at<ut;at++){let Vt=Ft+at,bn=1-At;if(bn<=0)break;let xr=1;if(te>=0){let Ti=L[te].bytesPerSample,er=ot[te]+Vt*Ti;xr=Ti===2?Ue.fromHalfFloat(ve.getUint16(er,!0)):ve.getFloat32(er,!0)}for(let Ti=0;Ti<L.length;Ti++){let er=L[Ti],ys=j[er.name];if(ys===void 0)continue;let bs=er.bytesPerSample,tr=ot[Ti]+Vt*bs,ki=bs===2?Ue.fromHalfFloat(ve.getUint16(tr,!0)):ve.getFloat32(tr,!0);qe[ys]+=ki*bn}At+=xr*bn}j.A!==void 0&&(qe[j.A]=At);let Jt=Xe+We*X;for(let at=0;at<X;at++)x.byteArray[Jt+at]=Q?Ue.toHalfFloat(qe[at]):qe[at]}}}function cn(x,p,v){let C={},L=!1;for(;;){let O=be(p,v);if(O==="")break;L=!0;let N=be(p,v),j=he(x,v),X=Ws(x,p,v,N,j);X===void 0?console.warn(`THREE.EXRLoader: Skipped unknown header attribute type '${N}'.`):C[O]=X}return L?C:null}function xn(x,p,v){if(x.getUint32(0,!0)!=20000630)throw new Error("THREE.EXRLoader: Provided file doesn't appear to be in OpenEXR format.");let C=x.getUint8(4),L=x.getUint8(5),O={singleTile:!!(L&2),longName:!!(L&4),deepFormat:!!(L&8),multiPart:!!(L&16)};v.value=8;let N=[];if(O.multiPart){for(;;){let j=cn(x,p,v);if(j===null)break;j.version=C,j.spec=O,N.push(j)}if(N.length===0)throw new Error("THREE.EXRLoader: No valid part headers found.")}else{let j=cn(x,p,v);j.version=C,j.spec=O,N.push(j)}return N}function vn(x,p,v,C,L,O){let N={size:0,viewer:p,array:v,offset:C,width:x.dataWindow.xMax-x.dataWindow.xMin+1,height:x.dataWindow.yMax-x.dataWindow.yMin+1,inputChannels:x.channels,channelByteOffsets:{},shouldExpand:!1,yCbCr:!1,totalBytes:null,columns:null,lines:null,type:null,uncompress:null,getter:null,format:null,colorSpace:dn};switch(x.compression){case"NO_COMPRESSION":N.blockHeight=1,N.uncompress=De;break;case"RLE_COMPRESSION":N.blockHeight=1,N.uncompress=Kt;break;case"ZIPS_COMPRESSION":N.blockHeight=1,N.uncompress=je;break;case"ZIP_COMPRESSION":N.blockHeight=16,N.uncompress=je;break;case"PIZ_COMPRESSION":N.blockHeight=32,N.uncompress=lt;break;case"PXR24_COMPRESSION":N.blockHeight=16,N.uncompress=F;break;case"B44_COMPRESSION":case"B44A_COMPRESSION":N.blockHeight=32,N.uncompress=E;break;case"DWAA_COMPRESSION":N.blockHeight=32,N.uncompress=ee;break;case"DWAB_COMPRESSION":N.blockHeight=256,N.uncompress=ee;break;default:throw new Error("THREE.EXRLoader: "+x.compression+" is unsupported")}let j={};for(let le of x.channels)switch(le.name){case"BY":case"RY":case"Y":case"R":case"G":case"B":case"A":j[le.name]=!0,N.type=le.pixelType}let X=!1,Q=!1;if(j.Y&&j.RY&&j.BY)N.outputChannels=4,N.yCbCr=!0;else if(j.R&&j.G&&j.B)N.outputChannels=4;else if(j.Y)N.outputChannels=1;else throw new Error("THREE.EXRLoader: file contains unsupported data channels.");switch(N.outputChannels){case 4:O==jt?(X=!j.A,N.format=jt,N.colorSpace=dn,N.outputChannels=4,N.decodeChannels={R:0,G:1,B:2,A:3}):O==ai?(N.format=ai,N.colorSpace=dn,N.outputChannels=2,N.decodeChannels={R:0,G:1}):O==ls?(N.format=ls,N.colorSpace=dn,N.outputChannels=1,N.decodeChannels={R:0}):Q=!0;break;case 1:O==jt?(X=!0,N.format=jt,N.colorSpace=dn,N.outputChannels=4,N.shouldExpand=!0,N.decodeChannels={Y:0}):O==ai?(N.format=ai,N.colorSpace=dn,N.outputChannels=2,N.shouldExpand=!0,N.decodeChannels={Y:0}):O==ls?(N.format=ls,N.colorSpace=dn,N.outputChannels=1,N.decodeChannels={Y:0}):Q=!0;break;default:Q=!0}if(Q)throw new Error("THREE.EXRLoader: invalid output format for specified file.");if(N.yCbCr&&(N.format=jt,N.outputChannels=4,N.decodeChannels={Y:0,RY:1,BY:2},X=!0),N.type==1)switch(L){case Nt:N.getter=Be;break;case tn:N.getter=Le;break}else if(N.type==2)switch(L){case Nt:N.getter=oe;break;case tn:N.getter=ke}else throw new Error("THREE.EXRLoader: unsupported pixelType "+N.type+" for "+x.compression+".");N.columns=N.width;let te=N.width*N.height*N.outputChannels;switch(L){case Nt:N.byteArray=new Float32Array(te),X&&N.byteArray.fill(1,0,te);break;case tn:N.byteArray=new Uint16Array(te),X&&N.byteArray.fill(15360,0,te);break;default:console.error("THREE.EXRLoader: unsupported type: ",L);break}let fe=0;for(let le of x.channels)N.decodeChannels[le.name]!==void 0&&(N.channelByteOffsets[le.name]=fe),fe+=le.pixelType*2;if(N.totalBytes=fe,N.outLineWidth=N.width*N.outputChannels,x.spec.deepFormat){N.deepChannels=[];let le=0;for(let ce of x.channels){let Se=ce.pixelType===0?4:ce.pixelType*2;N.deepChannels.push({name:ce.name,pixelType:ce.pixelType,bytesPerSample:Se}),le+=Se}N.deepBytesPerSample=le,N.chunkOffsets=x._chunkOffsets,N.multiPart=x.spec.multiPart,N.decode=Mi.bind(N)}else if(x.spec.singleTile){N.blockHeight=x.tiles.ySize,N.blockWidth=x.tiles.xSize;let le=ka(x.tiles,N.width,N.height),ce=Xs(le,N.width,x.tiles.xSize,x.tiles.roundingMode),Se=Xs(le,N.height,x.tiles.ySize,x.tiles.roundingMode);N.tileCount=ce[0]*Se[0];for(let Te=0;Te<le;Te++)for(let Ae=0;Ae<Se[Te];Ae++)for(let Ve=0;Ve<ce[Te];Ve++)ue(p,C);N.decode=zi.bind(N)}else if(x.spec.multiPart)N.blockWidth=N.width,N.chunkOffsets=x._chunkOffsets,N.decode=Qi.bind(N);else{N.blockWidth=N.width;let le=Math.ceil(N.height/N.blockHeight);for(let ce=0;ce<le;ce++)ue(p,C);N.decode=ji.bind(N)}return N}let ci={value:0},Hn=new DataView(e),gr=new Uint8Array(e),_r=xn(Hn,e,ci),vs=Math.max(0,Math.min(this.part,_r.length-1)),yn=_r[vs];if(yn.spec.multiPart||yn.spec.deepFormat)for(let x=0;x<_r.length;x++){let p=_r[x].chunkCount;if(x===vs){yn._chunkOffsets=[];for(let v=0;v<p;v++)yn._chunkOffsets.push(ue(Hn,ci))}else for(let v=0;v<p;v++)ue(Hn,ci)}let Pn=vn(yn,Hn,gr,ci,this.type,this.outputFormat);if(Pn.decode(),Pn.shouldExpand){let x=Pn.byteArray;if(this.outputFormat==jt)for(let p=0;p<x.length;p+=4)x[p+2]=x[p+1]=x[p];else if(this.outputFormat==ai)for(let p=0;p<x.length;p+=2)x[p+1]=x[p]}if(Pn.yCbCr){let x=Pn.byteArray,p=Pn.width*Pn.height;if(this.type===tn)for(let v=0;v<p;v++){let C=v*4,L=Ue.fromHalfFloat(x[C]),O=Ue.fromHalfFloat(x[C+1]),N=Ue.fromHalfFloat(x[C+2]),j=(1+O)*L,X=(1+N)*L,Q=(L-j*.2126-X*.0722)/.7152;x[C]=Ue.toHalfFloat(Math.max(0,j)),x[C+1]=Ue.toHalfFloat(Math.max(0,Q)),x[C+2]=Ue.toHalfFloat(Math.max(0,X))}else for(let v=0;v<p;v++){let C=v*4,L=x[C],O=x[C+1],N=x[C+2],j=(1+O)*L,X=(1+N)*L;x[C]=Math.max(0,j),x[C+1]=Math.max(0,(L-j*.2126-X*.0722)/.7152),x[C+2]=Math.max(0,X)}}return{header:yn,width:Pn.width,height:Pn.height,data:Pn.byteArray,format:Pn.format,colorSpace:Pn.colorSpace,type:this.type,minFilter:qt,magFilter:qt,generateMipmaps:!1,flipY:!1}}setDataType(e){return this.type=e,this}setOutputFormat(e){return this.outputFormat=e,this}setPart(e){return this.part=e,this}};var dh=class extends ao{constructor(e){super(e),this.type=tn}parse(e){let o=function(A,V){switch(A){case 1:throw new Error("THREE.HDRLoader: Read Error: "+(V||""));case 2:throw new Error("THREE.HDRLoader: Write Error: "+(V||""));case 3:throw new Error("THREE.HDRLoader: Bad File Format: "+(V||""));default:case 4:throw new Error("THREE.HDRLoader: Memory Error: "+(V||""))}},h=function(A,V,z){V=V||1024;let q=A.pos,Y=-1,U=0,W="",K=String.fromCharCode.apply(null,new Uint16Array(A.subarray(q,q+128)));for(;0>(Y=K.indexOf(`
`))&&U<V&&q<A.byteLength;)W+=K,U+=K.length,q+=128,K=String.fromCharCode.apply(null,new Uint16Array(A.subarray(q,q+128)));return-1<Y?(z!==!1&&(A.pos+=U+Y+1),W+K.slice(0,Y)):!1},f=function(A){let V=/^#\?(\S+)/,z=/^\s*GAMMA\s*=\s*(\d+(\.\d+)?)\s*$/,D=/^\s*EXPOSURE\s*=\s*(\d+(\.\d+)?)\s*$/,q=/^\s*FORMAT=(\S+)\s*$/,Y=/^\s*\-Y\s+(\d+)\s+\+X\s+(\d+)\s*$/,U={valid:0,string:"",comments:"",programtype:"RGBE",format:"",gamma:1,exposure:1,width:0,height:0},W,K;for((A.pos>=A.byteLength||!(W=h(A)))&&o(1,"no header found"),(K=W.match(V))||o(3,"bad initial token"),U.valid|=1,U.programtype=K[1],U.string+=W+`
`;W=h(A),W!==!1;){if(U.string+=W+`
`,W.charAt(0)==="#"){U.comments+=W+`
`;continue}if((K=W.match(z))&&(U.gamma=parseFloat(K[1])),(K=W.match(D))&&(U.exposure=parseFloat(K[1])),(K=W.match(q))&&(U.valid|=2,U.format=K[1]),(K=W.match(Y))&&(U.valid|=4,U.height=parseInt(K[1],10),U.width=parseInt(K[2],10)),U.valid&2&&U.valid&4)break}return U.valid&2||o(3,"missing format specifier"),U.valid&4||o(3,"missing image size specifier"),U},d=function(A,V,z){let D=V;if(D<8||D>32767||A[0]!==2||A[1]!==2||A[2]&128)return new Uint8Array(A);D!==(A[2]<<8|A[3])&&o(3,"wrong scanline width");let q=new Uint8Array(4*V*z);q.length||o(4,"unable to allocate buffer space");let Y=0,U=0,W=4*D,K=new Uint8Array(4),$=new Uint8Array(W),xe=z;for(;xe>0&&U<A.byteLength;){U+4>A.byteLength&&o(1),K[0]=A[U++],K[1]=A[U++],K[2]=A[U++],K[3]=A[U++],(K[0]!=2||K[1]!=2||(K[2]<<8|K[3])!=D)&&o(3,"bad rgbe scanline format");let ne=0,re;for(;ne<W&&U<A.byteLength;){re=A[U++];let ge=re>128;if(ge&&(re-=128),(re===0||ne+re>W)&&o(3,"bad scanline data"),ge){let pe=A[U++];for(let se=0;se<re;se++)$[ne++]=pe}else $.set(A.subarray(U,U+re),ne),ne+=re,U+=re}let de=D;for(let ge=0;ge<de;ge++){let pe=0;q[Y]=$[ge+pe],pe+=D,q[Y+1]=$[ge+pe],pe+=D,q[Y+2]=$[ge+pe],pe+=D,q[Y+3]=$[ge+pe],Y+=4}xe--}return q},m=function(A,V,z,D){let q=A[V+3],Y=Math.pow(2,q-128)/255;z[D+0]=A[V+0]*Y,z[D+1]=A[V+1]*Y,z[D+2]=A[V+2]*Y,z[D+3]=1},b=function(A,V,z,D){let q=A[V+3],Y=Math.pow(2,q-128)/255;z[D+0]=Ue.toHalfFloat(Math.min(A[V+0]*Y,65504)),z[D+1]=Ue.toHalfFloat(Math.min(A[V+1]*Y,65504)),z[D+2]=Ue.toHalfFloat(Math.min(A[V+2]*Y,65504)),z[D+3]=Ue.toHalfFloat(1)},g=new Uint8Array(e);g.pos=0;let _=f(g),S=_.width,T=_.height,M=d(g.subarray(g.pos),S,T),P,R,y;switch(this.type){case Nt:y=M.length/4;let A=new Float32Array(y*4);for(let z=0;z<y;z++)m(M,z*4,A,z*4);P=A,R=Nt;break;case tn:y=M.length/4;let V=new Uint16Array(y*4);for(let z=0;z<y;z++)b(M,z*4,V,z*4);P=V,R=tn;break;default:throw new Error("THREE.HDRLoader: Unsupported type: "+this.type)}return{width:S,height:T,data:P,header:_.string,gamma:_.gamma,exposure:_.exposure,type:R,colorSpace:dn,minFilter:qt,magFilter:qt,generateMipmaps:!1,flipY:!0}}setDataType(e){return this.type=e,this}};var Ma=class extends Error{};function qd(i,e,t){if(i!==2*e)throw new Ma(`It has ${i} x ${e} pixels, which is not all directions: twice as wide as high.`);let n=new Float64Array(e),r=0;for(let s=0;s<e;s++){let o=0;for(let a=0;a<i;a++){let l=t[s*i+a];if(!(l>=0&&Number.isFinite(l)))throw new Ma("It holds values that are negative or not finite.");o+=l}r+=S3(s,e,i)*o,n[s]=r}if(!(r>0))throw new Ma("It is black and lights nothing.");return{width:i,height:e,radiance:t,rows:n}}function S3(i,e,t){let n=r=>Math.cos(Math.PI*r/e);return(n(i)-n(i+1))*2*Math.PI/t}var Y_=i=>i.rows[i.height-1];function Yd(i){let{width:e,height:t,radiance:n,rows:r}=i,s=new Float32Array(4*e*t);for(let a=0;a<t;a++){let l=n.subarray(a*e,(a+1)*e),c=l.reduce((h,f)=>h+f,0),u=0;l.forEach((h,f)=>{u+=h,s.set([h,c>0?u/c:1],4*(a*e+f))})}let o=new Float32Array(4*t);return r.forEach((a,l)=>o[4*l]=a),{total:Y_(i),map:fh({width:e,height:t,texels:s}),rows:fh({width:t,height:1,texels:o})}}function $_(i){let[e,t]=[128,64],n=new Float32Array(e*t);for(let r=0;r<t;r++){let s=Math.PI*(.5-(r+.5)/t);for(let o=0;o<e;o++){let a=2*Math.PI*((o+.5)/e-.5);n[r*e+o]=i==="overcast"?M3(s):T3(s,a)}}return Z_(qd(e,t,n))}var M3=i=>i>0?(1+2*Math.sin(i))/3:.06;function T3(i,e){let t=(n,r,s,o)=>Math.abs(e-n)<r&&i>s&&i<o;return t(.9,.28,.25,.85)?1:t(-1.3,.14,0,.4)?.5:.004}function Z_(i){let e=1/Y_(i);return qd(i.width,i.height,i.radiance.map(t=>t*e))}async function K_(i){let e=await i.arrayBuffer(),t=/\.exr$/i.test(i.name)?new ql:new dh,n=t.setDataType(tn).parse(e);if(!n||!n.data||!n.width||!n.height)throw new Ma("It cannot be read.");let{data:r,width:s,height:o}=n,a=r.length/(s*o),l=new Float32Array(s*o),c=t instanceof ql;for(let u=0;u<o;u++){let h=c?o-1-u:u;for(let f=0;f<s;f++){let d=a*(h*s+f),m=[0,1,2].map(b=>Ue.fromHalfFloat(r[d+Math.min(b,a-1)]));l[u*s+f]=Math.max(0,.2126729*m[0]+.7151522*m[1]+.072175*m[2])}}return Z_(qd(s,o,l))}var ph=(1n<<64n)-1n;function A3(i,e){let t=BigInt(i)*0x10000n+BigInt(e)&ph,n=()=>{t=t+0x9e3779b97f4a7c15n&ph;let r=t;return r=(r^r>>30n)*0xbf58476d1ce4e5b9n&ph,r=(r^r>>27n)*0x94d049bb133111ebn&ph,r^=r>>31n,Number(r>>11n)/2**52-1};return[n(),n()]}function J_(i,e){let t=new Float32Array(2*i*e);for(let r=0;r<i;r++)for(let s=0;s<e;s++)t.set(A3(r,s),2*(r*e+s));let n=new oi(t,e,i,ai,Nt);return n.minFilter=n.magFilter=Ut,n.needsUpdate=!0,n}var j_=`
uniform highp sampler2D u_chance;
const float OUTLINE = 1.45;
const float RIM = 0.62;
const float RIM_SLOPE = 0.35;
const float SKIN = 0.93;
const float RISE = 0.05;
const float FLATNESS = 0.5;
const float UNEVEN = 0.02;

struct Scale {
  int ring;
  int column;
  vec2 place;
  float outline;
};

Scale on_ring(int ring, vec2 at) {
  int columns = textureSize(u_chance, 0).x;
  float shift = (ring & 1) == 1 ? 0.5 : 0.0;
  float column = floor(at.y - shift + 0.5);
  vec2 place = vec2(at.x - float(ring), 2.0 * (at.y - shift - column));
  vec2 powers = pow(max(abs(place), vec2(1e-12)), vec2(OUTLINE));
  int wrapped = int(column) - columns * int(floor(column / float(columns)));
  return Scale(ring, wrapped, place, pow(powers.x + powers.y, 1.0 / OUTLINE));
}

bool scale_slopes(vec2 at, out vec2 rise) {
  int ring = int(floor(at.x));
  Scale scale = on_ring(ring, at);
  if (scale.outline > 1.0) scale = on_ring(ring + 1, at);
  rise = vec2(0.0);
  if (scale.outline > SKIN) return false;
  ivec2 size = textureSize(u_chance, 0);
  float bend = clamp((scale.outline - RIM) / (SKIN - RIM), 0.0, 1.0);
  float fall = RIM_SLOPE * bend * bend;
  vec2 away = sign(scale.place) * pow(max(abs(scale.place), vec2(1e-12)), vec2(OUTLINE - 1.0));
  float roundness = 3.14159265 / float(size.x) * scale.place.y;
  vec2 uneven = texelFetch(u_chance, ivec2(scale.column, clamp(scale.ring, 0, size.y - 1)), 0).xy;
  rise = vec2(RISE, FLATNESS * tan(roundness)) - fall * away + UNEVEN * uneven;
  return true;
}
`;var Yl=2048,mh=`
in vec3 v_place;
uniform highp sampler2D u_shadow0;
uniform highp sampler2D u_shadow1;
uniform highp sampler2D u_shadow2;
uniform highp sampler2D u_shadow3;
uniform mat4 u_to_light[${4}];
uniform float u_texel;
vec3 shaded_place;
vec3 shaded_normal;

void shadow_place(vec3 place, vec3 normal) {
  shaded_place = place;
  shaded_normal = normal;
}

float open_at(highp sampler2D depths, vec3 at) {
  vec2 place = at.xy * float(textureSize(depths, 0).x) - 0.5;
  vec2 first = floor(place);
  vec2 share = place - first;
  float sum = 0.0;
  for (int dy = 0; dy < 2; dy++) {
    for (int dx = 0; dx < 2; dx++) {
      float depth = texelFetch(depths, ivec2(first) + ivec2(dx, dy), 0).r;
      float weight = (dx == 1 ? share.x : 1.0 - share.x) * (dy == 1 ? share.y : 1.0 - share.y);
      sum += weight * (at.z <= depth ? 1.0 : 0.0);
    }
  }
  return sum;
}

float lit(int light) {
  vec3 direction = u_light[light].xyz;
  float cosine = dot(shaded_normal, direction);
  // Off the surface by a texel of the map, more where the light grazes it.
  float side = sqrt(max(0.0, 1.0 - cosine * cosine));
  vec3 lifted = shaded_place + shaded_normal * (u_texel * (0.6 + 2.0 * side)) + direction * u_texel;
  vec4 clip = u_to_light[light] * vec4(lifted, 1.0);
  vec3 at = 0.5 * clip.xyz + 0.5;
  if (light == 0) return open_at(u_shadow0, at);
  if (light == 1) return open_at(u_shadow1, at);
  if (light == 2) return open_at(u_shadow2, at);
  return open_at(u_shadow3, at);
}
`,Ta=class{constructor(e,t){this.bounds=t;let n=`in vec3 position;
uniform mat4 u_to_light;
void main() { gl_Position = u_to_light * vec4(position, 1.0); }`;this.pass=new Ur(Os(n,`precision highp float;
layout(location = 0) out vec4 out_value;
void main() { out_value = vec4(1.0); }`,{u_to_light:this.clip},!0),e),this.uniforms={u_to_light:{value:Array.from({length:4},()=>new it)},u_texel:{value:2*t.radius/Yl}};for(let r=0;r<4;r++)this.uniforms[`u_shadow${r}`]={value:null}}bounds;uniforms;targets=[];drawn=[];pass;clip={value:new it};draw(e,t){let n=t.u_light.value;for(let r=0;r<t.u_lights.value;r++){let{x:s,y:o,z:a}=n[r],l=`${s} ${o} ${a}`;if(this.drawn[r]===l)continue;this.drawn[r]=l;let c=this.lightClip(new J(s,o,a));this.uniforms.u_to_light.value[r]=c,this.clip.value=c,this.pass.draw(e,this.target(r))}for(let r=0;r<4;r++)this.uniforms[`u_shadow${r}`].value??=this.targets[0].depthTexture}target(e){if(!this.targets[e]){let t=new cr(Yl,Yl,Nt);t.minFilter=t.magFilter=Ut,this.targets[e]=new Zn(Yl,Yl,{depthTexture:t}),this.uniforms[`u_shadow${e}`].value=t}return this.targets[e]}lightClip(e){let{centre:t,radius:n}=this.bounds,r=new J(...t),s=r.clone().addScaledVector(e,2*n),o=Math.abs(e.y)<.9?new J(0,1,0):new J(1,0,0),a=new it().lookAt(s,r,o).setPosition(s);return new it().makeOrthographic(-n,n,n,-n,n,3*n).multiply(a.invert())}};var E3=52,Zd=.13,Kd=15,R3=1.5,Or=1400,zs=60,gh=2*Math.PI,ds=(i,e,t)=>[i[0]+t*e[0],i[1]+t*e[1],i[2]+t*e[2]],Q_=(i,e)=>[i[1]*e[2]-i[2]*e[1],i[2]*e[0]-i[0]*e[2],i[0]*e[1]-i[1]*e[0]];function C3(){let i=[];for(let t=0;t<=46;t++){let n=2.3*t/46,r=gh*n-2.2,s=.83-.215*n;i.push([s*Math.cos(r),.95*s*Math.sin(r),Zd+.17*Math.max(n-.55,0)])}let e=i[i.length-1][2];return i.push([.3,.18,e+.08],[.17,.3,e+.15],[-.02,.29,e+.18],[-.18,.19,e+.17],[-.3,.06,e+.14]),i}function I3(i,e){let t=Math.min(e*(i.length-3),i.length-3-1e-9),n=Math.floor(t),r=t-n;return[(1-r)**3,3*r**3-6*r*r+4,-3*r**3+3*r*r+3*r+1,r**3].reduce((a,l,c)=>ds(a,i[n+c],l/6),[0,0,0])}function P3(i){let e=(l,c)=>{let u=Math.min(1,Math.max(0,(i-l)/(c-l)));return u*u*(3-2*u)},n=.7+.3*e(.05,.3),r=.16*(1-e(.022,.052)),s=Math.sqrt(Math.max(0,1-(1-Math.min(i/.03,1))**2)),o=Math.min((1-i)/.33,1),a=(o*(2-o))**.85;return[Zd*(n+r)*s*a,.92-.22*(1-e(.015,.052))]}function L3(){let i=C3(),e=Array.from({length:Or+1},(r,s)=>I3(i,1-s/Or)),t=[0];for(let r=1;r<=Or;r++){let s=ds(e[r],e[r-1],-1);t.push(t[r-1]+Math.hypot(...s))}let n=0;return e.map((r,s)=>{let[o,a]=[Math.max(s-1,0),Math.min(s+1,Or)],[l,c]=P3(t[s]/t[Or]),u=.5*R3*gh*Math.max(l,.3*Zd)/Kd;return n+=(t[s]-t[o])/u,{centre:r,along:wi(ds(e[a],e[o],-1)),radius:l,height:c,scales:n}})}function $l(i,e){let t=wi(ds([0,0,1],i.along,-i.along[2])),n=Q_(t,i.along),r=ds(i.centre,t,i.radius*i.height*Math.cos(e));return ds(r,n,i.radius*Math.sin(e))}function $d([i,e,t]){let n=E3*Math.PI/180,[r,s]=[Math.sin(n),Math.cos(n)];return[i,e*r+t*s,-e*s+t*r]}function N3(){let i=L3(),e=(Or+1)*(zs+1),t={position:new Float32Array(3*e),normal:new Float32Array(3*e),tangent:new Float32Array(3*e),uv:new Float32Array(2*e)};i.forEach((o,a)=>{let[l,c]=[i[Math.max(a-1,0)],i[Math.min(a+1,Or)]];for(let u=0;u<=zs;u++){let h=gh*u/zs-Math.PI,f=ds($l(c,h),$l(l,h),-1),d=ds($l(o,h+1e-4),$l(o,h-1e-4),-1),m=Q_(f,d),b=a===0?[-o.along[0],-o.along[1],-o.along[2]]:o.along,g=wi($d(Vl(m,m)>0?m:b)),_=$d(f),S=ds(_,g,-Vl(_,g)),T=a*(zs+1)+u;t.position.set($d($l(o,h)),3*T),t.normal.set(g,3*T),t.tangent.set(Vl(S,S)>0?wi(S):[0,0,0],3*T),t.uv.set([o.scales,Kd*h/gh],2*T)}});let n=new Uint32Array(6*Or*zs),r=0;for(let o=0;o<Or;o++)for(let a=0;a<zs;a++){let[l,c]=[o*(zs+1)+a,(o+1)*(zs+1)+a];n.set([l,c,c+1,l,c+1,l+1],r),r+=6}let s=new _n;s.setIndex(new an(n,1));for(let[o,a]of Object.entries(t))s.setAttribute(o,new an(a,o==="uv"?2:3));return{geometry:s,scaleRings:Math.ceil(i[Or].scales)+2}}var D3=`
in vec3 position;
in vec3 normal;
in vec3 tangent;
in vec2 uv;
uniform mat4 u_to_clip;
out vec3 v_place;
out vec3 v_normal;
out vec3 v_tangent;
out vec2 v_uv;
void main() {
  v_place = position;
  v_normal = normal;
  v_tangent = tangent;
  v_uv = uv;
  gl_Position = u_to_clip * vec4(position, 1.0);
}
`,F3=`
${mh}
${j_}
in vec3 v_normal;
in vec3 v_tangent;
in vec2 v_uv;
uniform mat4 u_from_clip;
uniform vec2 u_size;
void main() {
  seen = true;
  vec3 smooth_normal = normalize(v_normal);
  shadow_place(v_place, smooth_normal);
  vec3 t = normalize(v_tangent - smooth_normal * dot(smooth_normal, v_tangent));
  vec3 b = cross(smooth_normal, t);
  vec2 rise;
  if (scale_slopes(v_uv, rise)) {
    vec3 normal = normalize(smooth_normal - rise.x * t - rise.y * b);
    vec3 tangent = normalize(t - normal * dot(normal, t));
    vec2 clip = 2.0 * gl_FragCoord.xy / u_size - 1.0;
    vec4 near = u_from_clip * vec4(clip, -1.0, 1.0);
    vec3 to_viewer = normalize(near.xyz / near.w - v_place);
    shade(Point(tangent, cross(normal, tangent), normal, to_viewer));
  }
  finish();
}
`;function ex(){let{geometry:i,scaleRings:e}=N3(),t=new Ta(i,{centre:[0,.1,0],radius:1.25});return{geometry:i,view:nh,vertex:D3,fragment:F3,uniforms:{...t.uniforms,u_chance:{value:J_(e,Kd)}},drawShadows:(n,r)=>t.draw(n,r)}}var _h={specimen:"",shape:"snake",lights:[{direction:[.3,.2,1],diameter_deg:.53,irradiance:1}],active:0,view:{azimuth_deg:0,elevation_deg:0,zoom:1},exposure:null,tone:"atlas",illuminant:"tables",laser_nm:633,sun_deg:45,turn_deg:0,spin_deg:0,scale:1,tables:null,difference:!1,interpolation:"bilinear",pigment:!0,patch:{width_mm:20,distance_mm:60,tilt_deg:30},screen:{distance_mm:100,width_mm:200,beam_mm:2,incidence_deg:0},light_samples:16,pixel_samples:16,environment:"none",environment_samples:64,pointer:{x:-.72,y:0},polar_log:!0,motion:"none",size_px:null},Jd=i=>structuredClone(i);function jd(i){let e=Jd(_h),t=i.replace(/^#/,"");if(!t)return e;try{return Qd(e,JSON.parse(decodeURIComponent(t)))}catch{return e}}function xh(i){let e=Object.fromEntries(Object.entries(i).filter(([t,n])=>JSON.stringify(n)!==JSON.stringify(_h[t])));return Object.keys(e).length?`#${encodeURIComponent(JSON.stringify(e))}`:""}var U3={shape:["ball","snake","patch","screen","map","model"],tone:["atlas","clip"],illuminant:["tables","D65","A","E","F11","LED","laser","sun"],interpolation:["bilinear","cubic"],motion:["none","light","turntable"],environment:["none","overcast","window","own"]},O3={exposure:[-20,30],laser_nm:[380,780],sun_deg:[1,90],turn_deg:[-360,360],spin_deg:[-3600,3600],scale:[.25,1],tables:[1,256],light_samples:[1,1024],pixel_samples:[1,1024],environment_samples:[1,4096],size_px:[1,4096],active:[0,3]};function Qd(i,e){let t=Jd(i);for(let[r,s]of Object.entries(e)){if(!(r in _h))continue;let o=t[r],l=typeof o=="object"&&o!==null&&!Array.isArray(o)&&typeof s=="object"?{...o,...s}:s;B3(r,l)&&(t[r]=Jd(l))}let n=t;return n.active=Math.min(n.active,n.lights.length-1),n}function B3(i,e){if(i==="lights")return z3(e);if(e===null)return i==="exposure"||i==="tables"||i==="size_px";let t=U3[i];if(t)return t.includes(e);let n=O3[i];if(n)return typeof e=="number"&&e>=n[0]&&e<=n[1];let r=_h[i];return typeof e!=typeof r?!1:typeof e!="object"?!0:Object.keys(r).every(s=>Number.isFinite(e[s]))}function z3(i){return!Array.isArray(i)||i.length<1||i.length>4?!1:i.every(e=>{let{direction:t,diameter_deg:n,irradiance:r}=e??{};return Array.isArray(t)&&t.length===3&&t.every(Number.isFinite)&&Math.hypot(...t)>0&&n>=0&&n<=90&&r>=0&&Number.isFinite(r)})}var ks=class extends Error{},tx=128,vh=class{constructor(e,t,n){this.files=t;this.state=n;if(typeof DecompressionStream>"u")throw new ks("This browser cannot unpack the tables; those of 2023 and later can.");let r=e.getContext("webgl2",{antialias:!1,alpha:!1,powerPreference:"high-performance"});if(!r)throw new ks("This page draws with WebGL 2, which this browser does not offer or has switched off.");if(this.clock=new hh(r),this.renderer=new Zu({canvas:e,context:r}),this.renderer.autoClear=!0,this.renderer.debug.onShaderError=(s,o)=>{throw new ks(`The graphics driver refuses the shader: ${s.getProgramInfoLog(o)??"it does not say why"}.`)},this.renderer.setClearColor(0,-1),this.floats=r.getExtension("EXT_color_buffer_float")!==null,!this.floats&&r.getExtension("EXT_color_buffer_half_float")===null)throw new ks("This page sums light in floating-point numbers, which this graphics driver cannot draw to.");this.state.shape==="model"&&(this.state.shape="snake"),this.state.environment==="own"&&(this.state.environment="none"),this.picture=new us(this.renderer,this.floats?Nt:tn),matchMedia("(color-gamut: p3)").matches&&"drawingBufferColorSpace"in r&&(r.drawingBufferColorSpace="display-p3",r.drawingBufferColorSpace==="display-p3"&&(this.picture.primaries=T_)),this.probe=new ah(this.renderer)}files;state;renderer;clock;probe;floats;index;loaded=null;model=null;ownSky=null;builtSky=null;picture;other=null;meter=null;snake=null;metered=null;quadratureKey="";quadratureUniforms={};get size(){return{width:this.picture.width,height:this.picture.height}}get progress(){return{taken:this.picture.samples,whole:us.samplesOf(this.state)}}async open(){this.index=await i_(this.files);let e=(await this.viewerFile())?.specimens;if(e&&(this.index.specimens=this.index.specimens.filter(({name:t})=>e.includes(t))),!this.index.specimens?.length)throw new gi("The atlas holds no specimen.");this.files.expect(this.index.files??[])}viewer=null;viewerFile(){return this.viewer??=this.files.optionalJson("viewer.json").catch(()=>null)}async loadSpecimen(e){let t=this.index.specimens.map(r=>r.name),n=t.includes(this.state.specimen)?this.state.specimen:t[0];if(this.loaded?.specimen.name!==n){let r=await r_(this.files,n),s=await t_(this.files,r,e);this.unload(),this.loaded={specimen:r,tables:s&&{packed:s,uploaded:Hd(s)},spectral:null},this.metered=null}this.state.specimen=n,this.restart()}async loadSpectral(e){let t=this.loaded;if(!t)return!1;if(!t.spectral){let n=await n_(this.files,t.specimen,e);if(!n||this.loaded!==t)return!1;t.spectral={packed:n,uploaded:Hd(n)},this.wantsSpectral()&&this.restart()}return!0}unload(){this.loaded?.tables?.uploaded.dispose(),this.loaded?.spectral?.uploaded.dispose(),this.loaded=null,this.quadratureKey=""}finish(){let e=this.renderer.getContext();e.readPixels(0,0,1,1,e.RGBA,e.UNSIGNED_BYTE,new Uint8Array(4))}set(e){let t=this.state;this.state=Qd(t,e);let n=({pointer:s,polar_log:o,motion:a,exposure:l,tone:c,...u})=>JSON.stringify(u),r=n(t)!==n(this.state);return r&&this.restart(),r}restart(){this.picture.restart(),this.other?.restart()}wantsSpectral(){return this.loaded?.tables===null||this.state.illuminant!=="tables"||this.state.scale!==1}lacking(){let{loaded:e,state:t}=this;return!e||!this.wantsSpectral()?"":e.specimen.spectral?e.spectral?e.specimen.pigment&&t.pigment?"without the pigment, which is known for the tables’ light alone":"":"reading the spectral tables":"no spectral tables: shown under the light of the tables"}light(){if(this.loaded&&!this.loaded.specimen.spectral)return null;let{illuminant:e,laser_nm:t,sun_deg:n}=this.state;return e==="tables"?this.loaded&&this.wantsSpectral()?uh(this.loaded.specimen.optics.illuminant):null:lh(e,t,n)}evaluated(e=!1,t=this.state.pigment){let n=this.loaded;if(!n)return null;let r=e?null:this.state.tables,s=this.light(),{interpolation:o}=this.state;return s&&n.spectral?{interpolation:o,source:"spectral",uniforms:{...this.limited(n.spectral.uploaded,r,!1),...this.quadratureFor(s)}}:n.tables?{interpolation:o,source:"tables",uniforms:this.limited(n.tables.uploaded,r,t)}:null}spectralEvaluated(){let e=this.loaded;if(!e?.spectral)return null;let t=this.light()??lh("D65",633,45);return{interpolation:this.state.interpolation,source:"spectral",uniforms:{...this.limited(e.spectral.uploaded,this.state.tables,!1),...this.quadratureFor(t)}}}quadratureOf(e){let t=this.loaded?.specimen;return t?U_(t,e):null}limited({uniforms:e},t,n){let r=e[xo[0]].value,s=r.table_scales.map(a=>a.clone());t!==null&&s.forEach((a,l)=>{for(let c=0;c<4;c++)4*l+c>=t&&a.setComponent(c,0)});let o={...r,table_scales:s};return o.pigment&&!n&&(o.pigment=o.pigment.clone().set(0,0,0,0)),{...e,[xo[0]]:{value:o}}}quadratureFor(e){let t=this.loaded?.specimen,n=`${t?.name} ${e.label} ${this.state.scale}`;if(n!==this.quadratureKey){let r=this.quadratureOf(e);if(!t||!r)return{};this.quadratureUniforms.u_quadrature?.value?.dispose(),this.quadratureKey=n,this.quadratureUniforms=O_(t,r,this.state.scale)}return this.quadratureUniforms}asks(e){return Vd(this.loaded?.specimen??null,e)}tableCount(){let{loaded:e}=this;return e?this.light()&&e.spectral?e.specimen.spectral?.tables??1:e.tables?.packed.params.table_count??1:1}lookups(){let{loaded:e}=this;if(!e)return 0;if(this.light()&&e.spectral){let{table_layers:n,cross_layers:r}=e.spectral.packed.params;return(n+r)*Number(this.quadratureUniforms.u_wavelengths?.value??0)}return e.tables?e.tables.packed.params.table_count+e.tables.packed.params.restricted:0}body(){return this.state.shape==="snake"?this.snake??=ex():this.state.shape==="model"?this.model:null}useModel(e){this.model?.geometry.dispose(),this.model=e,this.restart()}useSky(e){this.ownSky=Yd(e),this.restart()}get hasSky(){return this.ownSky!==null}sky(){let{environment:e}=this.state;return e==="none"?null:e==="own"?this.ownSky:(this.builtSky?.name!==e&&(this.builtSky={name:e,sky:Yd($_(e))}),this.builtSky.sky)}exposure(){let{exposure:e}=this.state;return e===null?this.automatic():Math.PI*2**e}automatic(){let{specimen:e,shape:t,illuminant:n,laser_nm:r,scale:s,environment:o}=this.state,a=JSON.stringify([e,t,n,r,s,o]),l=this.evaluated();if(this.metered?.key===a||!l||!this.floats)return this.metered?.exposure??1;this.meter??=new us(this.renderer,Nt),this.meter.resize(tx,tx),this.meter.restart(),this.meter.sky=this.sky();let c={...this.state,environment_samples:16,view:{azimuth_deg:0,elevation_deg:0,zoom:1},light_samples:1,pixel_samples:1};for(let u=0;u<us.samplesOf(c);u++)this.meter.step(c,l,this.body());return this.metered={key:a,exposure:zd(this.meter.values())},this.metered.exposure}remeter(){this.metered=null}resize(e,t){this.renderer.setSize(e,t,!1),this.picture.resize(e,t),this.other?.resize(e,t)}draw(e){let[t,n]=[this.evaluated(),this.body()];if(!t)return!0;let r=us.samplesOf(this.state);this.picture.sky=this.sky();let s=performance.now(),o=this.state.difference&&this.state.tables!==null?this.otherPicture():null;for(;this.picture.samples<r&&(this.clock.time(()=>this.picture.step(this.state,t,n)),o&&o.step(this.state,this.evaluated(!0)??t,n),!(performance.now()-s>e)););return this.picture.show(this.exposure(),this.state.tone,null,o),this.picture.samples>=r}otherPicture(){return this.other||(this.other=new us(this.renderer,this.floats?Nt:tn),this.other.resize(this.picture.width,this.picture.height),this.restart()),this.other.sky=this.sky(),this.other}pixels(){let{width:e,height:t}=this.size,n=oh(e,t),r=this.state.difference&&this.state.tables!==null?this.other:null;this.picture.show(this.exposure(),this.state.tone,n,r);let s=new Uint8Array(4*e*t);return this.renderer.readRenderTargetPixels(n,0,0,e,t,s),n.dispose(),{width:e,height:t,data:Gl(s,e,t)}}values(){return{...this.size,data:this.picture.values()}}directions(){let e=this.evaluated();return e&&this.floats?this.picture.directionsAt(this.state,e,this.body(),this.state.pointer):null}};function nx([i,e,t]){return[3.2404542*i-1.5371385*e-.4985314*t,-.969266*i+1.8760108*e+.041556*t,.0556434*i-.2040259*e+1.0572252*t]}var ix=i=>i<=.0031308?12.92*i:1.055*i**(1/2.4)-.055;function yh(i){if(!(i[1]>0))return"rgb(0, 0, 0)";let e=nx(i.map(l=>l/i[1])),t=Math.min(...e),n=t<0?e.map(l=>(l-t)/(1-t)):e,r=Math.max(...n),[s,o,a]=n.map(l=>Math.round(255*ix(l/r)));return`rgb(${s}, ${o}, ${a})`}function Yi([i,e,t]){let n=i+e+t;return n>0?[i/n,e/n]:null}function rx(i,e){let[t,n]=[Yi(i),Yi(e)];if(!t||!n)return null;let r=[t[0]-n[0],t[1]-n[1]];if(Math.hypot(...r)<1e-4)return null;let o=ep(n,r)??ep(n,[-r[0],-r[1]]);if(!o)return null;let a=ep(n,r)===null;return{nm:o.nm,purity:a?NaN:Math.min(1,1/o.factor),complementary:a}}function ep(i,[e,t]){for(let n=380;n<700;n++){let[r,s]=[Yi(hs(n)),Yi(hs(n+1))];if(!r||!s)continue;let[o,a]=[s[0]-r[0],s[1]-r[1]],l=e*-a+o*t;if(Math.abs(l)<1e-12)continue;let[c,u]=[r[0]-i[0],r[1]-i[1]],h=(c*-a+o*u)/l,f=(e*u-t*c)/l;if(h>0&&f>=0&&f<1)return{nm:n+f,factor:h}}return null}function Zl(i){let e=hs(i),t=Math.min(1,Math.max(.15,e[0]+e[1]+e[2])),n=nx(e),r=Math.min(0,...n),s=n.map(u=>u-r),o=Math.max(...s),[a,l,c]=s.map(u=>Math.round(255*ix(u/o*t)));return`rgb(${a}, ${l}, ${c})`}function tp(i,e){let t=URL.createObjectURL(i),n=document.createElement("a");n.href=t,n.download=e,n.click(),setTimeout(()=>URL.revokeObjectURL(t),1e4)}async function sx(i,e){if(typeof MediaRecorder>"u")return null;let t=["video/webm;codecs=vp9","video/webm;codecs=vp8","video/webm"].find(o=>MediaRecorder.isTypeSupported(o));if(!t)return null;let n=new MediaRecorder(i.captureStream(30),{mimeType:t,videoBitsPerSecond:12e6}),r=[];n.ondataavailable=o=>r.push(o.data);let s=new Promise(o=>n.onstop=o);return n.start(),await new Promise(o=>setTimeout(o,e*1e3)),n.stop(),await s,new Blob(r,{type:t})}var k3="http://www.w3.org/2000/svg";function ox(i,e,t){for(let[n,r]of Object.entries(e))r==null||r===!1||(n.startsWith("on")?i.addEventListener(n.slice(2),r):n in i&&!(i instanceof SVGElement)&&n!=="list"&&n!=="role"?Reflect.set(i,n,r):i.setAttribute(n==="className"?"class":n,r===!0?"":String(r)));for(let n of t)n&&i.append(n)}function Me(i,e={},...t){let n=document.createElement(i);return ox(n,e,t),n}function Qt(i,e={},...t){let n=document.createElementNS(k3,i);return ox(n,e,t),n}var V3=0,Aa=()=>`e${++V3}`;function Nn(i,e=3){if(!Number.isFinite(i))return"–";if(i===0)return"0";let t=Math.abs(i);if(t>=1e5||t<.001){let[n,r]=i.toExponential(e-1).split("e");return`${Number(n)}e${Number(r)}`.replaceAll("-","−")}return String(Number(i.toPrecision(e))).replace("-","−")}function ax(){let i=Me("dl",{className:"facts wide"}),e=Me("div",{className:"doubts"}),t=Me("details",{},Me("summary",{},"What to doubt"),e),n=Me("div",{},i,t),r="";return{element:n,update:(s,o,a)=>{let l=o.loaded?.specimen;if(!l||l.name===r)return;r=l.name,i.replaceChildren(...G3(l).flatMap(([u,h,f])=>[Me("dt",{title:f},u),Me("dd",{},h)]));let c=l.warnings??[];t.hidden=c.length===0,e.replaceChildren(...c.map(u=>Me("p",{className:"caption"},`${u[0].toUpperCase()}${u.slice(1)}.`.replace(/\.\.$/,"."))))}}}function H3(i){return i==="ideal"?"reflects everything":"dielectric"in i?`n = ${Nn(i.dielectric.n,4)}`:`n = ${Nn(i.conductor.n)}, k = ${Nn(i.conductor.k)}`}function G3(i){let{optics:e,tables:t,spectral:n,statistics:r,errors:s,provenance:o}=i,a=o?.[0],[l]=r??[],c=l?.dominant_periods?.[0],u=s?.find(f=>f.what==="total"&&f.region==="whole hemisphere");return[a?["scan",`${a.size.join(" × ")} px, ${Nn(a.pitch_nm[0])} nm each`,a.file_name]:null,l?["roughness",`${Nn(l.rms_height_nm)} nm rms`,"Root mean square of the heights."]:null,c?["period",`${Nn(c.period_nm,4)} nm at ${c.direction_deg.toFixed(0)}°`,"The strongest period of the relief, and its direction from the x axis."]:null,["material",H3(e.material),"Refractive index of the surface."],["coherence",`σ = ${Nn(e.sigma_nm/1e3)} µm`,"How far apart two points may lie and still interfere: it sets how sharp the colours are."],["tables",`${t.tables.length} of ${t.u.samples} × ${t.v.samples}${n?`, ${n.tables} spectral`:""}`,"Tables of XYZ, and tables that hold no light and no observer."],u?.p95?["error",`${Nn(100*u.p95,2)} % (95 % of directions)`,"Of the luminance against the integral over the scan itself."]:null].filter(f=>f!==null)}var W3=[[.64,.33],[.3,.6],[.15,.06]],lx=.8,Ea=.9,np=(i,e)=>`${i.toFixed(4)} ${(Ea-e).toFixed(4)}`;function X3(){let i=[];for(let e=390;e<=700;e+=2){let t=Yi(hs(e));t&&i.push(np(...t))}return`M${i.join("L")}Z`}function cx(){let i=Qt("path",{className:"trail"}),e=Qt("circle",{r:.014,className:"marker"}),t=Qt("circle",{r:.006,className:"white"}),n=[480,500,520,560,600].map(a=>{let[l,c]=Yi(hs(a))??[0,0];return Qt("text",{x:l+(a<520?-.012:.012),y:Ea-c+(a===520?-.012:.01),"text-anchor":a<520?"end":"start"},String(a))}),r=Qt("svg",{viewBox:`-0.06 -0.02 ${lx+.1} ${Ea+.05}`,role:"img"},Qt("path",{d:`M0 0V${Ea}H${lx}`,className:"axis"}),Qt("path",{d:X3(),className:"locus"}),Qt("path",{d:`M${W3.map(([a,l])=>np(a,l)).join("L")}Z`,className:"gamut"}),...n,i,t,e),s=Me("p",{className:"caption"});return{element:Me("div",{className:"chromaticity",title:"Chromaticity x, y. The curve holds pure wavelengths, the triangle what an sRGB display shows, the thin line the colours over the plane of incidence."},r,s),update:(a,l,c)=>{let u=c?.xyz?Yi(c.xyz):null;e.style.display=u?"":"none",u&&e.setAttribute("transform",`translate(${u[0]} ${Ea-u[1]})`);let h=c?Yi(c.white):null;t.style.display=h?"":"none",h&&t.setAttribute("transform",`translate(${h[0]} ${Ea-h[1]})`),i.setAttribute("d",c?q3(c):""),s.textContent=u?`x ${u[0].toFixed(3)}, y ${u[1].toFixed(3)}`:"",r.setAttribute("aria-label",`Chromaticity diagram; the spot at ${s.textContent||"no colour"}`)}}}function q3({plane:i}){let e=i.map(t=>t?Yi(t):null).filter(t=>t!==null);return e.length?`M${e.map(([t,n])=>np(t,n)).join("L")}`:""}function _i(i,e,t){let{label:n,unit:r="",title:s,min:o,step:a}=i,l=()=>typeof i.max=="number"?i.max:i.max(),c=Aa(),u=Me("output",{htmlFor:c}),h=Me("input",{type:"range",id:c,min:o,max:l(),step:a,title:s,oninput:()=>t(i.set(Number(h.value),e()))}),f=Me("div",{className:"control",title:s},Me("label",{htmlFor:c},n),u,h);return{element:f,update:d=>{let m=i.get(d),b=l();h.max=String(b),h.value=String(m);let g=i.text?.(m,d)??`${Number(m.toFixed(2))}${r}`;u.textContent=g,h.setAttribute("aria-valuetext",g),h.style.setProperty("--filled",`${100*(Number(h.value)-o)/(b-o)}%`),f.hidden=i.when?!i.when(d):!1}}}function Ra(i,e){let t=Aa(),n=new Map,r=i.choices.map(({value:o,label:a,icon:l,title:c})=>{let u=Me("input",{type:"radio",name:t,value:o,onchange:()=>e(i.set(o))});return n.set(o,u),Me("label",{title:c??a},u,Me("span",{},l?.(),Me("span",{className:"word"},a)))}),s=Me("fieldset",{className:"segments",title:i.title},Me("legend",{},i.label),Me("div",{className:"row"},...r));return{element:s,update:o=>{let a=n.get(i.get(o));if(a)a.checked=!0;else for(let l of n.values())l.checked=!1;s.hidden=i.when?!i.when(o):!1}}}function ip(i,e){let t=Aa(),n=Me("select",{id:t,onchange:()=>e(i.set(n.value))},...i.choices.map(({value:s,label:o})=>Me("option",{value:s},o))),r=Me("div",{className:"control list",title:i.title},Me("label",{htmlFor:t},i.label),n);return{element:r,update:s=>{n.value=i.get(s),r.hidden=i.when?!i.when(s):!1}}}function rp(i,e){let t=Me("input",{type:"checkbox",onchange:()=>e(i.set(t.checked))}),n=Me("label",{className:"toggle",title:i.title},t,Me("span",{},i.label));return{element:n,update:r=>{t.checked=i.get(r),n.hidden=i.when?!i.when(r):!1}}}function vo(i,e,...t){return Me("details",{open:e,className:"section"},Me("summary",{},Me("h2",{},i)),Me("div",{className:"body"},...t))}function bh(i,e,t,n=""){return Me("button",{type:"button",title:e,onclick:t,className:n},i)}var ti=(...i)=>()=>Qt("svg",{viewBox:"0 0 24 24",className:"glyph","aria-hidden":"true"},...i.map(e=>Qt("path",{d:e}))),Br=(i,e=12,t=12)=>`M${e-i} ${t}a${i} ${i} 0 1 0 ${2*i} 0a${i} ${i} 0 1 0 ${-2*i} 0`,Jn={mark:ti("M4 20V4M8 20V7M12 20V10M16 20V13M20 20V16"),ball:ti(Br(8),"M5 9c4 2.5 10 2.5 14 0M5 15c4-2.5 10-2.5 14 0"),snake:ti("M4 18c6 3 15 1 14-4S7 12 7 8s6-5 11-2l2-1"),flat:ti("M6 6h12l3 12H3z","M10 6L8.500 18M14 6l1.500 12"),screen:ti("M4 4h16v12H4z",Br(1.5,12,10),"M12 16v5"),map:ti(Br(8),Br(4),"M12 4v16M4 12h16"),own:ti("M12 3l8 4.500v9L12 21l-8-4.500v-9z","M12 12l8-4.500M12 12L4 7.500M12 12v9"),light:ti(Br(4),"M12 2v3M12 19v3M2 12h3M19 12h3M5 5l2 2M17 17l2 2M19 5l-2 2M7 17l-2 2"),orbit:ti(Br(3),"M3 12c0-3 4-5 9-5s9 2 9 5-4 5-9 5","M14 14l-2 3 3 2"),spot:ti(Br(6),"M12 2v6M12 16v6M2 12h6M16 12h6"),pause:ti("M9 5v14M15 5v14"),sweep:ti(Br(3,18,6),"M4 19C5 11 8 8 14 6.500","M4 19l-1-3M4 19l3-1"),turn:ti("M4 12a8 8 0 1 0 3-6.200","M3 4l4 1.500L5.500 9.500"),link:ti("M10 14a4 4 0 0 0 6 0l3-3a4 4 0 0 0-6-6l-1 1","M14 10a4 4 0 0 0-6 0l-3 3a4 4 0 0 0 6 6l1-1"),picture:ti("M4 5h16v14H4z",Br(1.5,9,10),"M4 17l5-4 3 2 4-4 4 4"),film:ti("M4 5h16v14H4z","M10 9l5 3-5 3z"),theme:ti(Br(8),"M12 4a8 8 0 0 1 0 16z")};var Kl=192;function ux(){let i=Me("canvas",{width:Kl,height:Kl,role:"img"}),e=Qt("circle",{r:.035,className:"marker"}),t=Qt("path",{d:"M-.05 0H.05M0 -.05V.05",className:"mirror"}),n=d=>Qt("circle",{r:Math.sin(d*Math.PI/180),className:"ring"}),r=Qt("svg",{viewBox:"-1 -1 2 2","aria-hidden":"true"},n(30),n(60),n(90),Qt("path",{d:"M-1 0H1M0 -1V1",className:"ring"}),t,e),s=Me("p",{className:"caption"}),o=Me("div",{className:"map",title:"The BRDF for the light at the spot: each point is a viewing direction, the middle looks straight down, the rim along the surface. The cross is the mirror direction, the ring the viewer."},Me("div",{className:"square"},i,r),s),a=i.getContext("2d"),l=null,c="",u={element:o,update:f,onAsk:()=>{}},h=d=>{let m=r.getBoundingClientRect(),[b,g]=[2*(d.clientX-m.left)/m.width-1,1-2*(d.clientY-m.top)/m.height],_=1-b*b-g*g;return _>0?[b,g,Math.sqrt(_)]:null};r.addEventListener("pointermove",d=>u.onAsk(h(d))),r.addEventListener("pointerdown",d=>u.onAsk(h(d))),r.addEventListener("pointerleave",()=>u.onAsk(null));function f(d,m,b){e.style.display=t.style.display=b?"":"none";let g=m.evaluated();if(!b||!g||!a){s.textContent="The spot lies beside the surface, or no light reaches it.";return}let{wi:_,wo:S}=b;e.setAttribute("cx",String(S[0])),e.setAttribute("cy",String(-S[1])),t.setAttribute("transform",`translate(${-_[0]} ${_[1]})`);let[T,M]=[ef(_),ef(S)];s.textContent=`light θ ${T.theta_deg.toFixed(0)}°, φ ${T.phi_deg.toFixed(0)}° · viewer θ ${M.theta_deg.toFixed(0)}°, φ ${M.phi_deg.toFixed(0)}°`,i.setAttribute("aria-label",`Map of the BRDF over viewing directions; ${s.textContent}`);let P=JSON.stringify([_,m.loaded?.specimen.name,d.interpolation,d.illuminant,d.laser_nm,d.sun_deg,d.scale,d.tables,d.pigment,m.loaded?.spectral!==null]);if(P===c)return;c=P;let{pixels:R}=m.probe.map(g,_,Kl,null);l??=a.createImageData(Kl,Kl),l.data.set(R),a.putImageData(l,0,0)}return u}var wh=3,hx=.02;function sp([i,e,t],n,r){let s=va(wi([i,e,t]),n),o=r*Math.PI/180,[a,l]=[Math.sin(o),Math.cos(o)];return wi([s[0],s[1]*l+s[2]*a,s[2]*l-s[1]*a])}function ps(i,e){return{lights:i.lights.map((t,n)=>n===i.active?{...t,...e}:t)}}function fx(i,e){let t=Me("canvas",{tabIndex:0,role:"application","aria-label":"The picture. Arrow keys move the light; with Shift they turn the view; with Control they move the spot that is asked. Plus and minus zoom."}),n=Me("div",{className:"overlay"}),r=Me("div",{className:"spot","aria-hidden":"true"}),s=Me("div",{className:"picture"},t,r,n),o={element:s,canvas:t,overlay:n,grip:"light",update:_,square:S},a=()=>{let{width:T,height:M}=t.getBoundingClientRect();return{width:T,height:M,extent:xa(T,M)}},l=T=>{let M=t.getBoundingClientRect(),[P,R]=xa(M.width,M.height);return{x:P*(2*(T.clientX-M.left)/M.width-1),y:R*(1-2*(T.clientY-M.top)/M.height)}},c=(T,M)=>{let{view:P}=i();e({view:{...P,azimuth_deg:(P.azimuth_deg-T+540)%360-180,elevation_deg:Math.max(-89,Math.min(89,P.elevation_deg-M))}})},u=(T,M)=>{let P=i();e(ps(P,{direction:sp(P.lights[P.active].direction,T,M)}))},h=(T,M)=>{let{pointer:P}=i();e({pointer:{x:P.x+T,y:P.y+M}})},f=T=>{let{view:M}=i();e({view:{...M,zoom:Math.max(.5,Math.min(20,M.zoom*T))}})},d=null,m=null,b=new Map;t.addEventListener("pointerdown",T=>{t.setPointerCapture(T.pointerId),b.set(T.pointerId,T);let M=T.shiftKey||T.button===2,P=T.ctrlKey?"spot":M?o.grip==="view"?"light":"view":o.grip;d={x:T.clientX,y:T.clientY,grip:P},e({pointer:l(T)})}),t.addEventListener("pointermove",T=>{if(b.has(T.pointerId)&&b.set(T.pointerId,T),b.size===2){let[y,A]=[...b.values()],V=Math.hypot(y.clientX-A.clientX,y.clientY-A.clientY);m&&f(V/m),m=V;return}if(!d){T.pointerType==="mouse"&&e({pointer:l(T)});return}let M=160/Math.min(a().width,a().height),[P,R]=[(T.clientX-d.x)*M,(d.y-T.clientY)*M];d={...d,x:T.clientX,y:T.clientY},d.grip==="spot"?e({pointer:l(T)}):d.grip==="view"?c(P,R):u(P,R)});let g=T=>{b.delete(T.pointerId),d=null,m=null};t.addEventListener("pointerup",g),t.addEventListener("pointercancel",g),t.addEventListener("contextmenu",T=>T.preventDefault()),t.addEventListener("wheel",T=>{T.preventDefault(),f(Math.exp(-T.deltaY/600))},{passive:!1}),t.addEventListener("keydown",T=>{let P={ArrowLeft:[-1,0],ArrowRight:[1,0],ArrowUp:[0,1],ArrowDown:[0,-1]}[T.key];if(P){let[R,y]=P;T.ctrlKey||T.metaKey||o.grip==="spot"?h(hx*R,hx*y):T.shiftKey!==(o.grip==="view")?c(-wh*R,-wh*y):u(wh*R,wh*y)}else if(T.key==="+"||T.key==="=")f(1.1);else if(T.key==="-")f(1/1.1);else if(T.key==="Home")e({view:{azimuth_deg:0,elevation_deg:0,zoom:1}});else return;T.preventDefault()});function _(T){let{width:M,height:P,extent:[R,y]}=a(),[A,V]=[t.offsetLeft,t.offsetTop];r.style.transform=`translate(${A+(T.pointer.x/R+1)/2*M}px, ${V+(1-T.pointer.y/y)/2*P}px)`}function S(T){let M=s.getBoundingClientRect();t.style.width=t.style.height=T===null?"":`${T}px`,t.style.margin=T===null?"":`${(M.height-T)/2}px ${(M.width-T)/2}px`}return o}function dx(i){let[e,t,n]=wi(i),r=Math.hypot(e,t),s=Math.SQRT2*Math.sin(.5*Math.atan2(r,n));return r>1e-9?[s*e/r,s*t/r]:[0,0]}function Y3(i,e){let t=Math.min(1,Math.hypot(i,e)),n=2*Math.asin(t/Math.SQRT2),r=Math.atan2(e,i);return[Math.sin(n)*Math.cos(r),Math.sin(n)*Math.sin(r),Math.cos(n)]}function px(i,e){let t=Qt("g"),n=[30,60].map(l=>Qt("circle",{r:Math.SQRT2*Math.sin(l*Math.PI/360),className:"ring"})),r=Qt("svg",{viewBox:"-1.08 -1.08 2.16 2.16","aria-hidden":"true"},Qt("circle",{r:1,className:"rim"}),...n,Qt("path",{d:"M-1 0H1M0 -1V1",className:"ring"}),t),s=Me("div",{className:"pad",tabIndex:0,role:"application",title:"Where the lights stand, seen from the camera. Drag, or use the arrow keys.","aria-label":"Light. Arrow keys move it."},r),o=l=>{let c=r.getBoundingClientRect(),u=c.width/2.16;return[(l.clientX-c.left-c.width/2)/u,(c.top+c.height/2-l.clientY)/u]},a=l=>e(ps(i(),{direction:Y3(...o(l))}));return s.addEventListener("pointerdown",l=>{s.setPointerCapture(l.pointerId);let[c,u]=o(l),h=i().lights.map(({direction:d})=>{let[m,b]=dx(d);return Math.hypot(m-c,b-u)}),f=h.indexOf(Math.min(...h));h[f]<.15&&e({active:f}),a(l)}),s.addEventListener("pointermove",l=>s.hasPointerCapture(l.pointerId)&&a(l)),s.addEventListener("keydown",l=>{let u={ArrowLeft:[-3,0],ArrowRight:[3,0],ArrowUp:[0,3],ArrowDown:[0,-3]}[l.key];if(!u)return;let h=i();e(ps(h,{direction:sp(h.lights[h.active].direction,...u)})),l.preventDefault()}),{element:s,update:l=>{s.hidden=l.shape==="screen",t.replaceChildren(...l.lights.map((c,u)=>{let[h,f]=dx(c.direction);return Qt("circle",{cx:h,cy:-f,r:u===l.active?.085:.06,className:u===l.active?"lamp active":"lamp"})}))}}}var zr=Math.PI/180,op=Array.from({length:357},(i,e)=>(e-178)/2);function mx(i){let e=Math.hypot(i[0],i[1]),[t,n]=e>1e-6?[-i[0]/e,-i[1]/e]:[1,0];return op.map(r=>{let[s,o]=[Math.sin(r*zr),Math.cos(r*zr)];return[s*t,s*n,o]})}var ap=5;function gx(i){let e=Me("canvas",{role:"img"}),t=Me("input",{type:"checkbox",onchange:()=>i({polar_log:t.checked})}),n=Me("p",{className:"caption"});return{element:Me("div",{className:"polar",title:"f against the viewing angle in the plane of incidence: the line comes from the light, the dashes point to the mirror direction."},e,Me("label",{className:"toggle"},t,Me("span",{},"logarithmic")),n),update:(s,o,a)=>{t.checked=s.polar_log,$3(e,n,s,a)}}}function $3(i,e,t,n){let r=Math.min(2,devicePixelRatio||1),s=i.clientWidth||340,o=Math.round(s*.54);i.width!==Math.round(s*r)&&(i.width=Math.round(s*r)),i.height!==Math.round(o*r)&&(i.height=Math.round(o*r));let a=i.getContext("2d");if(!a)return;a.setTransform(r,0,0,r,0,0),a.clearRect(0,0,s,o);let c=getComputedStyle(i).getPropertyValue("--muted").trim(),[u,h]=["#ffffff2b","#8cc4ff"],[f,d,m]=[s/2,o-16,Math.min(s/2-30,o-26)];if(Z3(a,{cx:f,cy:d,radius:m,line:u,text:c}),!n){e.textContent="";return}let b=n.plane,g=Math.max(...b.map(T=>T?.[1]??0),1e-30),_=T=>{let M=Math.max(0,T?.[1]??0)/g;return m*(t.polar_log?Math.max(0,1+Math.log10(Math.max(M,1e-30))/ap):M)};op.forEach((T,M)=>{let P=b[M],R=_(P);!P||!(R>0)||(a.fillStyle=yh(P),a.beginPath(),a.moveTo(f,d),a.arc(f,d,R,(T-90.4)*zr,(T-89.6)*zr),a.fill())});let S=Math.atan2(Math.hypot(n.wi[0],n.wi[1]),n.wi[2])/zr;lp(a,{cx:f,cy:d,radius:m},-S,h,[]),lp(a,{cx:f,cy:d,radius:m},S,h,[3,4]),e.textContent=`rim: Y = ${Nn(g,3)} /sr${t.polar_log?", rings one decade apart":""}`,i.setAttribute("aria-label",`Polar plot of the BRDF in the plane of incidence; light at ${S.toFixed(0)} degrees, brightest Y ${Nn(g,3)} per steradian`)}function Z3(i,{cx:e,cy:t,radius:n,line:r,text:s}){i.fillStyle="#0b0d11",i.beginPath(),i.arc(e,t,n,Math.PI,2*Math.PI),i.fill(),i.strokeStyle=r,i.lineWidth=1;for(let o=1;o<=ap;o++)i.beginPath(),i.arc(e,t,n*o/ap,Math.PI,2*Math.PI),i.stroke();i.fillStyle=s,i.font="11px system-ui, sans-serif",i.textAlign="center";for(let o of[-60,-30,0,30,60]){lp(i,{cx:e,cy:t,radius:n},o,r,[]);let[a,l]=[Math.sin(o*zr),Math.cos(o*zr)];i.fillText(`${Math.abs(o)}°`,e+(n+13)*a,t-(n+6)*l+3)}i.beginPath(),i.moveTo(e-n,t),i.lineTo(e+n,t),i.stroke()}function lp(i,{cx:e,cy:t,radius:n},r,s,o){i.save(),i.strokeStyle=s,i.setLineDash(o),i.beginPath(),i.moveTo(e,t),i.lineTo(e+n*Math.sin(r*zr),t-n*Math.cos(r*zr)),i.stroke(),i.restore()}function xx(){let i=Me("img",{alt:"",className:"heights"}),e=Me("p",{className:"caption"}),t=Me("img",{alt:""}),n=Qt("svg",{viewBox:"-1 -1 2 2","aria-hidden":"true"}),r=Me("div",{className:"square"},t,n),s=Me("p",{className:"caption"}),o=Me("div",{className:"relief"},Me("figure",{title:"The scanned surface, seen from above."},i,e),Me("figure",{title:"Spatial frequencies of the relief. The coloured line are those that send each wavelength from this light to this viewer: the grating equation. Bright spots under it are orders that are seen."},r,s)),a="",l=null,c=async(u,h)=>{let{name:f}=h,d=(await u.viewerFile())?.heights?.[f],m=_=>u.index.files.some(S=>S.path===_),b=d??(m(`${f}/heights.png`)?`${f}/heights.png`:null),g=m(`${f}/spectrum.png`)?`${f}/spectrum.png`:null;a===f&&(l=J3(h),await _x(u,i,b,"height map",e,K3(h)),i.alt=`Height map of ${f}`,await _x(u,t,g,"power spectrum",s,""),t.alt=`Power spectrum of the heights of ${f}`,r.hidden=t.hidden)};return{element:o,update:(u,h,f)=>{let d=h.loaded?.specimen;d&&d.name!==a&&(a=d.name,l=null,c(h,d)),!t.hidden&&(n.replaceChildren(...f&&l?Q3(f,l):[]),s.textContent=j3(f,l))}}}async function _x(i,e,t,n,r,s){if(e.hidden=!0,r.textContent=`This atlas holds no ${n} of the specimen.`,!!t)try{e.src=await i.files.url(t),await e.decode(),e.hidden=!1,r.textContent=s}catch{r.textContent=`The atlas's picture ${t} cannot be read.`}}function K3({provenance:i,statistics:e}){let t=i?.[0],n=e?.[0]?.peak_to_valley_nm;return[t?`${Nn(t.size[0]*t.pitch_nm[0]/1e3)} µm across`:"",n?`${n.toFixed(0)} nm from lowest to highest`:""].filter(Boolean).join(" · ")}function J3({provenance:i,statistics:e}){let t=i?.[0];if(!t)return null;let n=(e?.[0]?.dominant_periods??[]).map(({period_nm:a})=>a).filter(a=>a>0),r=Math.max(0,...n.map(a=>1e3/a)),s=500/Math.max(...t.pitch_nm),o=Math.min(t.size[0]*t.pitch_nm[0],t.size[1]*t.pitch_nm[1]);return Math.min(s,Math.max(8e3/o,r>0?3*r:s/2))}function j3(i,e){if(!e)return"This atlas does not say how large its scan is, so nothing is drawn over the spectrum.";let t=`edge ${e.toPrecision(3)} /µm`;if(!i)return t;let n=Math.hypot(i.wi[0]+i.wo[0],i.wi[1]+i.wo[1]);return n<.02?`${t} · mirror direction: no frequency selected`:`${t} · selected: periods of ${(380/n).toFixed(0)} nm (violet) to ${(780/n).toFixed(0)} nm (red)`}function Q3({wi:i,wo:e},t){let[n,r]=[-(i[0]+e[0]),-(i[1]+e[1])],s=Math.hypot(n,r),o=c=>[1e3*n/c/t,-1e3*r/c/t],a=[420,550,680].map(c=>Qt("circle",{r:1e3*s/c/t,stroke:Zl(c),className:"selected"})),l=[];for(let c of[1,-1])for(let u=400;u<700;u+=10){let[[h,f],[d,m]]=[o(u),o(u+10)];l.push(Qt("line",{x1:c*h,y1:c*f,x2:c*d,y2:c*m,stroke:Zl(u),className:"bright"}))}return[...a,...l]}var eT="uplot",tT="u-hz",nT="u-vt",iT="u-title",rT="u-wrap",sT="u-under",oT="u-over",aT="u-axis",wo="u-off",lT="u-select",cT="u-cursor-x",uT="u-cursor-y",hT="u-cursor-pt",fT="u-legend",dT="u-live",pT="u-inline",mT="u-series",gT="u-marker",vx="u-label",_T="u-value",jl="width",Ql="height";var yx="bottom",Ca="left",cp="right",Ap="#000",bx=Ap+"0",up="mousemove",wx="mousedown",hp="mouseup",Sx="mouseenter",Mx="mouseleave",Tx="dblclick",xT="resize",vT="scroll",Ax="change",Eh="dppxchange",Ep="--",Ua=typeof window<"u",gp=Ua?document:null,Pa=Ua?window:null,yT=Ua?navigator:null,Wt,Sh;function _p(){let i=devicePixelRatio;Wt!=i&&(Wt=i,Sh&&vp(Ax,Sh,_p),Sh=matchMedia(`(min-resolution: ${Wt-.001}dppx) and (max-resolution: ${Wt+.001}dppx)`),So(Ax,Sh,_p),Pa.dispatchEvent(new CustomEvent(Eh)))}function Ui(i,e){if(e!=null){let t=i.classList;!t.contains(e)&&t.add(e)}}function xp(i,e){let t=i.classList;t.contains(e)&&t.remove(e)}function pn(i,e,t){i.style[e]=t+"px"}function dr(i,e,t,n){let r=gp.createElement(i);return e!=null&&Ui(r,e),t?.insertBefore(r,n),r}function $i(i,e){return dr("div",i,e)}var Ex=new WeakMap;function kr(i,e,t,n,r){let s="translate("+e+"px,"+t+"px)",o=Ex.get(i);s!=o&&(i.style.transform=s,Ex.set(i,s),e<0||t<0||e>n||t>r?Ui(i,wo):xp(i,wo))}var Rx=new WeakMap;function Cx(i,e,t){let n=e+t,r=Rx.get(i);n!=r&&(Rx.set(i,n),i.style.background=e,i.style.borderColor=t)}var Ix=new WeakMap;function Px(i,e,t,n){let r=e+""+t,s=Ix.get(i);r!=s&&(Ix.set(i,r),i.style.height=t+"px",i.style.width=e+"px",i.style.marginLeft=n?-e/2+"px":0,i.style.marginTop=n?-t/2+"px":0)}var Rp={passive:!0},bT={...Rp,capture:!0};function So(i,e,t,n){e.addEventListener(i,t,n?bT:Rp)}function vp(i,e,t,n){e.removeEventListener(i,t,Rp)}Ua&&_p();function pr(i,e,t,n){let r;t=t||0,n=n||e.length-1;let s=n<=2147483647;for(;n-t>1;)r=s?t+n>>1:Oi((t+n)/2),e[r]<i?t=r:n=r;return i-e[t]<=e[n]-i?t:n}function sv(i){return(t,n,r)=>{let s=-1,o=-1;for(let a=n;a<=r;a++)if(i(t[a])){s=a;break}for(let a=r;a>=n;a--)if(i(t[a])){o=a;break}return[s,o]}}var ov=i=>i!=null,av=i=>i!=null&&i>0,Ih=sv(ov),wT=sv(av);function ST(i,e,t,n=0,r=!1){let s=r?wT:Ih,o=r?av:ov;[e,t]=s(i,e,t);let a=i[e],l=i[e];if(e>-1)if(n==1)a=i[e],l=i[t];else if(n==-1)a=i[t],l=i[e];else for(let c=e;c<=t;c++){let u=i[c];o(u)&&(u<a?a=u:u>l&&(l=u))}return[a??sn,l??-sn]}function Ph(i,e,t,n){let r=Dx(i),s=Dx(e);i==e&&(r==-1?(i*=t,e/=t):(i/=t,e*=t));let o=t==10?ms:lv,a=r==1?Oi:Zi,l=s==1?Zi:Oi,c=a(o(Vn(i))),u=l(o(Vn(e))),h=La(t,c),f=La(t,u);return t==10&&(c<0&&(h=on(h,-c)),u<0&&(f=on(f,-u))),n||t==2?(i=h*r,e=f*s):(i=fv(i,h),e=Lh(e,f)),[i,e]}function Cp(i,e,t,n){let r=Ph(i,e,t,n);return i==0&&(r[0]=0),e==0&&(r[1]=0),r}var Ip=.1,Lx={mode:3,pad:Ip},tc={pad:0,soft:null,mode:0},MT={min:tc,max:tc};function Rh(i,e,t,n){return Nh(t)?Nx(i,e,t):(tc.pad=t,tc.soft=n?0:null,tc.mode=n?3:0,Nx(i,e,MT))}function zt(i,e){return i??e}function TT(i,e,t){for(e=zt(e,0),t=zt(t,i.length-1);e<=t;){if(i[e]!=null)return!0;e++}return!1}function Nx(i,e,t){let n=t.min,r=t.max,s=zt(n.pad,0),o=zt(r.pad,0),a=zt(n.hard,-sn),l=zt(r.hard,sn),c=zt(n.soft,sn),u=zt(r.soft,-sn),h=zt(n.mode,0),f=zt(r.mode,0),d=e-i,m=ms(d),b=xi(Vn(i),Vn(e)),g=ms(b),_=Vn(g-m);(d<1e-24||_>10)&&(d=0,(i==0||e==0)&&(d=1e-24,h==2&&c!=sn&&(s=0),f==2&&u!=-sn&&(o=0)));let S=d||b||1e3,T=ms(S),M=La(10,Oi(T)),P=S*(d==0?i==0?.1:1:s),R=on(fv(i-P,M/10),24),y=i>=c&&(h==1||h==3&&R<=c||h==2&&R>=c)?c:sn,A=xi(a,R<y&&i>=y?y:mr(y,R)),V=S*(d==0?e==0?.1:1:o),z=on(Lh(e+V,M/10),24),D=e<=u&&(f==1||f==3&&z>=u||f==2&&z<=u)?u:-sn,q=mr(l,z>D&&e<=D?D:xi(D,z));return A==q&&A==0&&(q=100),[A,q]}var AT=new Intl.NumberFormat(Ua?yT.language:"en-US"),Pp=i=>AT.format(i),Bi=Math,Ah=Bi.PI,Vn=Bi.abs,Oi=Bi.floor,kn=Bi.round,Zi=Bi.ceil,mr=Bi.min,xi=Bi.max,La=Bi.pow,Dx=Bi.sign,ms=Bi.log10,lv=Bi.log2,ET=(i,e=1)=>Bi.sinh(i)*e,fp=(i,e=1)=>Bi.asinh(i/e),sn=1/0;function Fx(i){return(ms((i^i>>31)-(i>>31))|0)+1}function yp(i,e,t){return mr(xi(i,e),t)}function cv(i){return typeof i=="function"}function Dt(i){return cv(i)?i:()=>i}var RT=()=>{},uv=i=>i,hv=(i,e)=>e,CT=i=>null,Ux=i=>!0,Ox=(i,e)=>i==e,IT=/\.\d*?(?=9{6,}|0{6,})/gm,Mo=i=>{if(pv(i)||Hs.has(i))return i;let e=`${i}`,t=e.match(IT);if(t==null)return i;let n=t[0].length-1;if(e.indexOf("e-")!=-1){let[r,s]=e.split("e");return+`${Mo(r)}e${s}`}return on(i,n)};function yo(i,e){return Mo(on(Mo(i/e))*e)}function Lh(i,e){return Mo(Zi(Mo(i/e))*e)}function fv(i,e){return Mo(Oi(Mo(i/e))*e)}function on(i,e=0){if(pv(i))return i;let t=10**e,n=i*t*(1+Number.EPSILON);return kn(n)/t}var Hs=new Map;function dv(i){return((""+i).split(".")[1]||"").length}function ic(i,e,t,n){let r=[],s=n.map(dv);for(let o=e;o<t;o++){let a=Vn(o),l=on(La(i,o),a);for(let c=0;c<n.length;c++){let u=i==10?+`${n[c]}e${o}`:n[c]*l,h=(o>=0?0:a)+(o>=s[c]?0:s[c]),f=i==10?u:on(u,h);r.push(f),Hs.set(f,h)}}return r}var nc={},Lp=[],Na=[null,null],Vs=Array.isArray,pv=Number.isInteger,PT=i=>i===void 0;function Bx(i){return typeof i=="string"}function Nh(i){let e=!1;if(i!=null){let t=i.constructor;e=t==null||t==Object}return e}function LT(i){return i!=null&&typeof i=="object"}var NT=Object.getPrototypeOf(Uint8Array),mv="__proto__";function Da(i,e=Nh){let t;if(Vs(i)){let n=i.find(r=>r!=null);if(Vs(n)||e(n)){t=Array(i.length);for(let r=0;r<i.length;r++)t[r]=Da(i[r],e)}else t=i.slice()}else if(i instanceof NT)t=i.slice();else if(e(i)){t={};for(let n in i)n!=mv&&(t[n]=Da(i[n],e))}else t=i;return t}function On(i){let e=arguments;for(let t=1;t<e.length;t++){let n=e[t];for(let r in n)r!=mv&&(Nh(i[r])?On(i[r],Da(n[r])):i[r]=Da(n[r]))}return i}var DT=0,FT=1,UT=2;function OT(i,e,t){for(let n=0,r,s=-1;n<e.length;n++){let o=e[n];if(o>s){for(r=o-1;r>=0&&i[r]==null;)i[r--]=null;for(r=o+1;r<t&&i[r]==null;)i[s=r++]=null}}}function BT(i,e){if(VT(i)){let o=i[0].slice();for(let a=1;a<i.length;a++)o.push(...i[a].slice(1));return HT(o[0])||(o=kT(o)),o}let t=new Set;for(let o=0;o<i.length;o++){let l=i[o][0],c=l.length;for(let u=0;u<c;u++)t.add(l[u])}let n=[Array.from(t).sort((o,a)=>o-a)],r=n[0].length,s=new Map;for(let o=0;o<r;o++)s.set(n[0][o],o);for(let o=0;o<i.length;o++){let a=i[o],l=a[0];for(let c=1;c<a.length;c++){let u=a[c],h=Array(r).fill(void 0),f=e?e[o][c]:FT,d=[];for(let m=0;m<u.length;m++){let b=u[m],g=s.get(l[m]);b===null?f!=DT&&(h[g]=b,f==UT&&d.push(g)):h[g]=b}OT(h,d,r),n.push(h)}}return n}var zT=typeof queueMicrotask>"u"?i=>Promise.resolve().then(i):queueMicrotask;function kT(i){let e=i[0],t=e.length,n=Array(t);for(let s=0;s<n.length;s++)n[s]=s;n.sort((s,o)=>e[s]-e[o]);let r=[];for(let s=0;s<i.length;s++){let o=i[s],a=Array(t);for(let l=0;l<t;l++)a[l]=o[n[l]];r.push(a)}return r}function VT(i){let e=i[0][0],t=e.length;for(let n=1;n<i.length;n++){let r=i[n][0];if(r.length!=t)return!1;if(r!=e){for(let s=0;s<t;s++)if(r[s]!=e[s])return!1}}return!0}function HT(i,e=100){let t=i.length;if(t<=1)return!0;let n=0,r=t-1;for(;n<=r&&i[n]==null;)n++;for(;r>=n&&i[r]==null;)r--;if(r<=n)return!0;let s=xi(1,Oi((r-n+1)/e));for(let o=i[n],a=n+s;a<=r;a+=s){let l=i[a];if(l!=null){if(l<=o)return!1;o=l}}return!0}var gv=["January","February","March","April","May","June","July","August","September","October","November","December"],_v=["Sunday","Monday","Tuesday","Wednesday","Thursday","Friday","Saturday"];function xv(i){return i.slice(0,3)}var GT=_v.map(xv),WT=gv.map(xv),XT={MMMM:gv,MMM:WT,WWWW:_v,WWW:GT};function Jl(i){return(i<10?"0":"")+i}function qT(i){return(i<10?"00":i<100?"0":"")+i}var YT={YYYY:i=>i.getFullYear(),YY:i=>(i.getFullYear()+"").slice(2),MMMM:(i,e)=>e.MMMM[i.getMonth()],MMM:(i,e)=>e.MMM[i.getMonth()],MM:i=>Jl(i.getMonth()+1),M:i=>i.getMonth()+1,DD:i=>Jl(i.getDate()),D:i=>i.getDate(),WWWW:(i,e)=>e.WWWW[i.getDay()],WWW:(i,e)=>e.WWW[i.getDay()],HH:i=>Jl(i.getHours()),H:i=>i.getHours(),h:i=>{let e=i.getHours();return e==0?12:e>12?e-12:e},AA:i=>i.getHours()>=12?"PM":"AM",aa:i=>i.getHours()>=12?"pm":"am",a:i=>i.getHours()>=12?"p":"a",mm:i=>Jl(i.getMinutes()),m:i=>i.getMinutes(),ss:i=>Jl(i.getSeconds()),s:i=>i.getSeconds(),fff:i=>qT(i.getMilliseconds())};function Np(i,e){e=e||XT;let t=[],n=/\{([a-z]+)\}|[^{]+/gi,r;for(;r=n.exec(i);)t.push(r[0][0]=="{"?YT[r[1]]:r[0]);return s=>{let o="";for(let a=0;a<t.length;a++)o+=typeof t[a]=="string"?t[a]:t[a](s,e);return o}}var $T=new Intl.DateTimeFormat().resolvedOptions().timeZone;function ZT(i,e){let t;return e=="UTC"||e=="Etc/UTC"?t=new Date(+i+i.getTimezoneOffset()*6e4):e==$T?t=i:(t=new Date(i.toLocaleString("en-US",{timeZone:e})),t.setMilliseconds(i.getMilliseconds())),t}var vv=i=>i%1==0,Ch=[1,2,2.5,5],KT=ic(10,-32,0,Ch),yv=ic(10,0,32,Ch),JT=yv.filter(vv),bo=KT.concat(yv),Dp=`
`,bv="{YYYY}",zx=Dp+bv,wv="{M}/{D}",ec=Dp+wv,Mh=ec+"/{YY}",Sv="{aa}",jT="{h}:{mm}",Ia=jT+Sv,kx=Dp+Ia,Vx=":{ss}",$t=null;function Mv(i){let e=i*1e3,t=e*60,n=t*60,r=n*24,s=r*30,o=r*365,l=(i==1?ic(10,0,3,Ch).filter(vv):ic(10,-3,0,Ch)).concat([e,e*5,e*10,e*15,e*30,t,t*5,t*10,t*15,t*30,n,n*2,n*3,n*4,n*6,n*8,n*12,r,r*2,r*3,r*4,r*5,r*6,r*7,r*8,r*9,r*10,r*15,s,s*2,s*3,s*4,s*6,o,o*2,o*5,o*10,o*25,o*50,o*100]),c=[[o,bv,$t,$t,$t,$t,$t,$t,1],[r*28,"{MMM}",zx,$t,$t,$t,$t,$t,1],[r,wv,zx,$t,$t,$t,$t,$t,1],[n,"{h}"+Sv,Mh,$t,ec,$t,$t,$t,1],[t,Ia,Mh,$t,ec,$t,$t,$t,1],[e,Vx,Mh+" "+Ia,$t,ec+" "+Ia,$t,kx,$t,1],[i,Vx+".{fff}",Mh+" "+Ia,$t,ec+" "+Ia,$t,kx,$t,1]];function u(h){return(f,d,m,b,g,_)=>{let S=[],T=g>=o,M=g>=s&&g<o,P=h(m),R=on(P*i,3),y=dp(P.getFullYear(),T?0:P.getMonth(),M||T?1:P.getDate()),A=on(y*i,3);if(M||T){let V=M?g/s:0,z=T?g/o:0,D=R==A?R:on(dp(y.getFullYear()+z,y.getMonth()+V,1)*i,3),q=new Date(kn(D/i)),Y=q.getFullYear(),U=q.getMonth();for(let W=0;D<=b;W++){let K=dp(Y+z*W,U+V*W,1),$=K-h(on(K*i,3));D=on((+K+$)*i,3),D<=b&&S.push(D)}}else{let V=g>=r?r:g,z=Oi(m)-Oi(R),D=A+z+Lh(R-A,V);S.push(D);let q=h(D),Y=q.getHours()+q.getMinutes()/t+q.getSeconds()/n,U=g/n,W=f.axes[d]._space,K=_/W;for(;D=on(D+g,i==1?0:3),!(D>b);)if(U>1){let $=Oi(on(Y+U,6))%24,re=h(D).getHours()-$;re>1&&(re=-1),D-=re*n,Y=(Y+U)%24;let de=S[S.length-1];on((D-de)/g,3)*K>=.7&&S.push(D)}else S.push(D)}return S}}return[l,c,u]}var[QT,eA,tA]=Mv(1),[nA,iA,rA]=Mv(.001);ic(2,-53,53,[1]);function Hx(i,e){return i.map(t=>t.map((n,r)=>r==0||r==8||n==null?n:e(r==1||t[8]==0?n:t[1]+n)))}function Gx(i,e){return(t,n,r,s,o)=>{let a=e.find(m=>o>=m[0])||e[e.length-1],l,c,u,h,f,d;return n.map(m=>{let b=i(m),g=b.getFullYear(),_=b.getMonth(),S=b.getDate(),T=b.getHours(),M=b.getMinutes(),P=b.getSeconds(),R=g!=l&&a[2]||_!=c&&a[3]||S!=u&&a[4]||T!=h&&a[5]||M!=f&&a[6]||P!=d&&a[7]||a[1];return l=g,c=_,u=S,h=T,f=M,d=P,R(b)})}}function sA(i,e){let t=Np(e);return(n,r,s,o,a)=>r.map(l=>t(i(l)))}function dp(i,e,t){return new Date(i,e,t)}function Wx(i,e){return e(i)}var oA="{YYYY}-{MM}-{DD} {h}:{mm}{aa}";function Xx(i,e){return(t,n,r,s)=>s==null?Ep:e(i(n))}function aA(i,e){let t=i.series[e];return t.width?t.stroke(i,e):t.points.width?t.points.stroke(i,e):null}function lA(i,e){return i.series[e].fill(i,e)}var cA={show:!0,live:!0,isolate:!1,mount:RT,markers:{show:!0,width:2,stroke:aA,fill:lA,dash:"solid"},idx:null,idxs:null,values:[]};function uA(i,e){let t=i.cursor.points,n=$i(),r=t.size(i,e);pn(n,jl,r),pn(n,Ql,r);let s=r/-2;pn(n,"marginLeft",s),pn(n,"marginTop",s);let o=t.width(i,e,r);return o&&pn(n,"borderWidth",o),n}function hA(i,e){let t=i.series[e].points;return t._fill||t._stroke}function fA(i,e){let t=i.series[e].points;return t._stroke||t._fill}function dA(i,e){return i.series[e].points.size}var pp=[0,0];function pA(i,e,t){return pp[0]=e,pp[1]=t,pp}function Th(i,e,t,n=!0){return r=>{r.button==0&&(!n||r.target==e)&&t(r)}}function mp(i,e,t,n=!0){return r=>{(!n||r.target==e)&&t(r)}}var mA={show:!0,x:!0,y:!0,lock:!1,move:pA,points:{one:!1,show:uA,size:dA,width:0,stroke:fA,fill:hA},bind:{mousedown:Th,mouseup:Th,click:Th,dblclick:Th,mousemove:mp,mouseleave:mp,mouseenter:mp},drag:{setScale:!0,x:!0,y:!1,dist:0,uni:null,click:(i,e)=>{e.stopPropagation(),e.stopImmediatePropagation()},_x:!1,_y:!1},focus:{dist:(i,e,t,n,r)=>n-r,prox:-1,bias:0},hover:{skip:[void 0],prox:null,bias:0},left:-10,top:-10,idx:null,dataIdx:null,idxs:null,event:null},Tv={show:!0,stroke:"rgba(0,0,0,0.07)",width:2},Fp=On({},Tv,{filter:hv}),Av=On({},Fp,{size:10}),Ev=On({},Tv,{show:!1}),Up='12px system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji"',Rv="bold "+Up,Cv=1.5,qx={show:!0,scale:"x",stroke:Ap,space:50,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:Rv,side:2,grid:Fp,ticks:Av,border:Ev,font:Up,lineGap:Cv,rotate:0},gA="Value",_A="Time",Yx={show:!0,scale:"x",auto:!1,sorted:1,min:sn,max:-sn,idxs:[]};function xA(i,e,t,n,r){return e.map(s=>s==null?"":Pp(s))}function vA(i,e,t,n,r,s,o){let a=[],l=Hs.get(r)||0;t=o?t:on(Lh(t,r),l);for(let c=t;c<=n;c=on(c+r,l))a.push(Object.is(c,-0)?0:c);return a}function bp(i,e,t,n,r,s,o){let a=[],l=i.scales[i.axes[e].scale].log,c=l==10?ms:lv,u=Oi(c(t));r=La(l,u),l==10&&(r=bo[pr(r,bo)]);let h=t,f=r*l;l==10&&(f=bo[pr(f,bo)]);do a.push(h),h=h+r,l==10&&!Hs.has(h)&&(h=on(h,Hs.get(r))),h>=f&&(r=h,f=r*l,l==10&&(f=bo[pr(f,bo)]));while(h<=n);return a}function yA(i,e,t,n,r,s,o){let l=i.scales[i.axes[e].scale].asinh,c=n>l?bp(i,e,xi(l,t),n,r):[l],u=n>=0&&t<=0?[0]:[];return(t<-l?bp(i,e,xi(l,-n),-t,r):[l]).reverse().map(f=>-f).concat(u,c)}var Iv=/./,bA=/[12357]/,wA=/[125]/,$x=/1/,wp=(i,e,t,n)=>i.map((r,s)=>e==4&&r==0||s%n==0&&t.test(r.toExponential()[r<0?1:0])?r:null);function SA(i,e,t,n,r){let s=i.axes[t],o=s.scale,a=i.scales[o],l=i.valToPos,c=s._space,u=l(10,o),h=l(9,o)-u>=c?Iv:l(7,o)-u>=c?bA:l(5,o)-u>=c?wA:$x;if(h==$x){let f=Vn(l(1,o)-u);if(f<c)return wp(e.slice().reverse(),a.distr,h,Zi(c/f)).reverse()}return wp(e,a.distr,h,1)}function MA(i,e,t,n,r){let s=i.axes[t],o=s.scale,a=s._space,l=i.valToPos,c=Vn(l(1,o)-l(2,o));return c<a?wp(e.slice().reverse(),3,Iv,Zi(a/c)).reverse():e}function TA(i,e,t,n){return n==null?Ep:e==null?"":Pp(e)}var Zx={show:!0,scale:"y",stroke:Ap,space:30,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:Rv,side:3,grid:Fp,ticks:Av,border:Ev,font:Up,lineGap:Cv,rotate:0};function AA(i,e){let t=3+(i||1)*2;return on(t*e,3)}function EA(i,e){let{scale:t,idxs:n}=i.series[0],r=i._data[0],s=i.valToPos(r[n[0]],t,!0),o=i.valToPos(r[n[1]],t,!0),a=Vn(o-s),l=i.series[e],c=a/(l.points.space*Wt);return n[1]-n[0]<=c}var Kx={scale:null,auto:!0,sorted:0,min:sn,max:-sn},Pv=(i,e,t,n,r)=>r,Jx={show:!0,auto:!0,sorted:0,gaps:Pv,alpha:1,facets:[On({},Kx,{scale:"x"}),On({},Kx,{scale:"y"})]},jx={scale:"y",auto:!0,sorted:0,show:!0,spanGaps:!1,gaps:Pv,alpha:1,points:{show:EA,filter:null},values:null,min:sn,max:-sn,idxs:[],path:null,clip:null};function RA(i,e,t,n,r){return t/10}var Lv={time:!0,auto:!0,distr:1,log:10,asinh:1,min:null,max:null,dir:1,ori:0},CA=On({},Lv,{time:!1,ori:1}),Qx={};function Nv(i,e){let t=Qx[i];return t||(t={key:i,plots:[],sub(n){t.plots.push(n)},unsub(n){t.plots=t.plots.filter(r=>r!=n)},pub(n,r,s,o,a,l,c){for(let u=0;u<t.plots.length;u++)t.plots[u]!=r&&t.plots[u].pub(n,r,s,o,a,l,c)}},i!=null&&(Qx[i]=t)),t}var Fa=1,Sp=2;function To(i,e,t){let n=i.mode,r=i.series[e],s=n==2?i._data[e]:i._data,o=i.scales,a=i.bbox,l=s[0],c=n==2?s[1]:s[e],u=n==2?o[r.facets[0].scale]:o[i.series[0].scale],h=n==2?o[r.facets[1].scale]:o[r.scale],f=a.left,d=a.top,m=a.width,b=a.height,g=i.valToPosH,_=i.valToPosV;return u.ori==0?t(r,l,c,u,h,g,_,f,d,m,b,Fh,Oa,Oh,Fv,Ov):t(r,l,c,u,h,_,g,d,f,b,m,Uh,Ba,zp,Uv,Bv)}function Op(i,e){let t=0,n=0,r=zt(i.bands,Lp);for(let s=0;s<r.length;s++){let o=r[s];o.series[0]==e?t=o.dir:o.series[1]==e&&(o.dir==1?n|=1:n|=2)}return[t,n==1?-1:n==2?1:n==3?2:0]}function IA(i,e,t,n,r){let s=i.mode,o=i.series[e],a=s==2?o.facets[1].scale:o.scale,l=i.scales[a];return r==-1?l.min:r==1?l.max:l.distr==3?l.dir==1?l.min:l.max:0}function gs(i,e,t,n,r,s){return To(i,e,(o,a,l,c,u,h,f,d,m,b,g)=>{let _=o.pxRound,S=c.dir*(c.ori==0?1:-1),T=c.ori==0?Oa:Ba,M,P;S==1?(M=t,P=n):(M=n,P=t);let R=_(h(a[M],c,b,d)),y=_(f(l[M],u,g,m)),A=_(h(a[P],c,b,d)),V=_(f(s==1?u.max:u.min,u,g,m)),z=new Path2D(r);return T(z,A,V),T(z,R,V),T(z,R,y),z})}function Dh(i,e,t,n,r,s){let o=null;if(i.length>0){o=new Path2D;let a=e==0?Oh:zp,l=t;for(let h=0;h<i.length;h++){let f=i[h];if(f[1]>f[0]){let d=f[0]-l;d>0&&a(o,l,n,d,n+s),l=f[1]}}let c=t+r-l,u=10;c>0&&a(o,l,n-u/2,c,n+s+u)}return o}function PA(i,e,t){let n=i[i.length-1];n&&n[0]==e?n[1]=t:i.push([e,t])}function Bp(i,e,t,n,r,s,o){let a=[],l=i.length;for(let c=r==1?t:n;c>=t&&c<=n;c+=r)if(e[c]===null){let h=c,f=c;if(r==1)for(;++c<=n&&e[c]===null;)f=c;else for(;--c>=t&&e[c]===null;)f=c;let d=s(i[h]),m=f==h?d:s(i[f]),b=h-r;d=o<=0&&b>=0&&b<l?s(i[b]):d;let _=f+r;m=o>=0&&_>=0&&_<l?s(i[_]):m,m>=d&&a.push([d,m])}return a}function ev(i){return i==0?uv:i==1?kn:e=>yo(e,i)}function Dv(i){let e=i==0?Fh:Uh,t=i==0?(r,s,o,a,l,c)=>{r.arcTo(s,o,a,l,c)}:(r,s,o,a,l,c)=>{r.arcTo(o,s,l,a,c)},n=i==0?(r,s,o,a,l)=>{r.rect(s,o,a,l)}:(r,s,o,a,l)=>{r.rect(o,s,l,a)};return(r,s,o,a,l,c=0,u=0)=>{c==0&&u==0?n(r,s,o,a,l):(c=mr(c,a/2,l/2),u=mr(u,a/2,l/2),e(r,s+c,o),t(r,s+a,o,s+a,o+l,c),t(r,s+a,o+l,s,o+l,u),t(r,s,o+l,s,o,u),t(r,s,o,s+a,o,c),r.closePath())}}var Fh=(i,e,t)=>{i.moveTo(e,t)},Uh=(i,e,t)=>{i.moveTo(t,e)},Oa=(i,e,t)=>{i.lineTo(e,t)},Ba=(i,e,t)=>{i.lineTo(t,e)},Oh=Dv(0),zp=Dv(1),Fv=(i,e,t,n,r,s)=>{i.arc(e,t,n,r,s)},Uv=(i,e,t,n,r,s)=>{i.arc(t,e,n,r,s)},Ov=(i,e,t,n,r,s,o)=>{i.bezierCurveTo(e,t,n,r,s,o)},Bv=(i,e,t,n,r,s,o)=>{i.bezierCurveTo(t,e,r,n,o,s)};function zv(i){return(e,t,n,r,s)=>To(e,t,(o,a,l,c,u,h,f,d,m,b,g)=>{let{pxRound:_,points:S}=o,T,M;c.ori==0?(T=Fh,M=Fv):(T=Uh,M=Uv);let P=on(S.width*Wt,3),R=(S.size-S.width)/2*Wt,y=on(R*2,3),A=new Path2D,V=new Path2D,{left:z,top:D,width:q,height:Y}=e.bbox;Oh(V,z-y,D-y,q+y*2,Y+y*2);let U=W=>{if(l[W]!=null){let K=_(h(a[W],c,b,d)),$=_(f(l[W],u,g,m));T(A,K+R,$),M(A,K,$,R,0,Ah*2)}};if(s)s.forEach(U);else for(let W=n;W<=r;W++)U(W);return{stroke:P>0?A:null,fill:A,clip:V,flags:Fa|Sp}})}function kv(i){return(e,t,n,r,s,o)=>{n!=r&&(s!=n&&o!=n&&i(e,t,n),s!=r&&o!=r&&i(e,t,r),i(e,t,o))}}var LA=kv(Oa),NA=kv(Ba);function Vv(i){let e=zt(i?.alignGaps,0);return(t,n,r,s)=>To(t,n,(o,a,l,c,u,h,f,d,m,b,g)=>{[r,s]=Ih(l,r,s);let _=o.pxRound,S=Y=>_(h(Y,c,b,d)),T=Y=>_(f(Y,u,g,m)),M,P;c.ori==0?(M=Oa,P=LA):(M=Ba,P=NA);let R=c.dir*(c.ori==0?1:-1),y={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:Fa},A=y.stroke,V=!1;if(s-r>=b*4){let Y=pe=>t.posToVal(pe,c.key,!0),U=null,W=null,K,$,xe,ne=S(a[R==1?r:s]),re=S(a[r]),de=S(a[s]),ge=Y(R==1?re+1:de-1);for(let pe=R==1?r:s;pe>=r&&pe<=s;pe+=R){let se=a[pe],Pe=(R==1?se<ge:se>ge)?ne:S(se),Oe=l[pe];Pe==ne?Oe!=null?($=Oe,U==null?(M(A,Pe,T($)),K=U=W=$):$<U?U=$:$>W&&(W=$)):Oe===null&&(V=!0):(U!=null&&P(A,ne,T(U),T(W),T(K),T($)),Oe!=null?($=Oe,M(A,Pe,T($)),U=W=K=$):(U=W=null,Oe===null&&(V=!0)),ne=Pe,ge=Y(ne+R))}U!=null&&U!=W&&xe!=ne&&P(A,ne,T(U),T(W),T(K),T($))}else for(let Y=R==1?r:s;Y>=r&&Y<=s;Y+=R){let U=l[Y];U===null?V=!0:U!=null&&M(A,S(a[Y]),T(U))}let[D,q]=Op(t,n);if(o.fill!=null||D!=0){let Y=y.fill=new Path2D(A),U=o.fillTo(t,n,o.min,o.max,D),W=T(U),K=S(a[r]),$=S(a[s]);R==-1&&([$,K]=[K,$]),M(Y,$,W),M(Y,K,W)}if(!o.spanGaps){let Y=[];V&&Y.push(...Bp(a,l,r,s,R,S,e)),y.gaps=Y=o.gaps(t,n,r,s,Y),y.clip=Dh(Y,c.ori,d,m,b,g)}return q!=0&&(y.band=q==2?[gs(t,n,r,s,A,-1),gs(t,n,r,s,A,1)]:gs(t,n,r,s,A,q)),y})}function DA(i){let e=zt(i.align,1),t=zt(i.ascDesc,!1),n=zt(i.alignGaps,0),r=zt(i.extend,!1);return(s,o,a,l)=>To(s,o,(c,u,h,f,d,m,b,g,_,S,T)=>{[a,l]=Ih(h,a,l);let M=c.pxRound,{left:P,width:R}=s.bbox,y=re=>M(m(re,f,S,g)),A=re=>M(b(re,d,T,_)),V=f.ori==0?Oa:Ba,z={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:Fa},D=z.stroke,q=f.dir*(f.ori==0?1:-1),Y=A(h[q==1?a:l]),U=y(u[q==1?a:l]),W=U,K=U;r&&e==-1&&(K=P,V(D,K,Y)),V(D,U,Y);for(let re=q==1?a:l;re>=a&&re<=l;re+=q){let de=h[re];if(de==null)continue;let ge=y(u[re]),pe=A(de);e==1?V(D,ge,Y):V(D,W,pe),V(D,ge,pe),Y=pe,W=ge}let $=W;r&&e==1&&($=P+R,V(D,$,Y));let[xe,ne]=Op(s,o);if(c.fill!=null||xe!=0){let re=z.fill=new Path2D(D),de=c.fillTo(s,o,c.min,c.max,xe),ge=A(de);V(re,$,ge),V(re,K,ge)}if(!c.spanGaps){let re=[];re.push(...Bp(u,h,a,l,q,y,n));let de=c.width*Wt/2,ge=t||e==1?de:-de,pe=t||e==-1?-de:de;re.forEach(se=>{se[0]+=ge,se[1]+=pe}),z.gaps=re=c.gaps(s,o,a,l,re),z.clip=Dh(re,f.ori,g,_,S,T)}return ne!=0&&(z.band=ne==2?[gs(s,o,a,l,D,-1),gs(s,o,a,l,D,1)]:gs(s,o,a,l,D,ne)),z})}function tv(i,e,t,n,r,s,o=sn){if(i.length>1){let a=null;for(let l=0,c=1/0;l<i.length;l++)if(e[l]!==void 0){if(a!=null){let u=Vn(i[l]-i[a]);u<c&&(c=u,o=Vn(t(i[l],n,r,s)-t(i[a],n,r,s)))}a=l}}return o}function FA(i){i=i||nc;let e=zt(i.size,[.6,sn,1]),t=i.align||0,n=i.gap||0,r=i.radius;r=r==null?[0,0]:typeof r=="number"?[r,0]:r;let s=Dt(r),o=1-e[0],a=zt(e[1],sn),l=zt(e[2],1),c=zt(i.disp,nc),u=zt(i.each,d=>{}),{fill:h,stroke:f}=c;return(d,m,b,g)=>To(d,m,(_,S,T,M,P,R,y,A,V,z,D)=>{let q=_.pxRound,Y=t,U=n*Wt,W=a*Wt,K=l*Wt,$,xe;M.ori==0?[$,xe]=s(d,m):[xe,$]=s(d,m);let ne=M.dir*(M.ori==0?1:-1),re=M.ori==0?Oh:zp,de=M.ori==0?u:(He,ct,yt,De,Kt,je,lt)=>{u(He,ct,yt,Kt,De,lt,je)},ge=zt(d.bands,Lp).find(He=>He.series[0]==m),pe=ge!=null?ge.dir:0,se=_.fillTo(d,m,_.min,_.max,pe),Ee=q(y(se,P,D,V)),Pe,Oe,ye,Ke=z,ft=q(_.width*Wt),et=!1,St=null,bt=null,vt=null,Zt=null;h!=null&&(ft==0||f!=null)&&(et=!0,St=h.values(d,m,b,g),bt=new Map,new Set(St).forEach(He=>{He!=null&&bt.set(He,new Path2D)}),ft>0&&(vt=f.values(d,m,b,g),Zt=new Map,new Set(vt).forEach(He=>{He!=null&&Zt.set(He,new Path2D)})));let{x0:kt,size:mn}=c;if(kt!=null&&mn!=null){Y=1,S=kt.values(d,m,b,g),kt.unit==2&&(S=S.map(yt=>d.posToVal(A+yt*z,M.key,!0)));let He=mn.values(d,m,b,g);mn.unit==2?Oe=He[0]*z:Oe=R(He[0],M,z,A)-R(0,M,z,A),Ke=tv(S,T,R,M,z,A,Ke),ye=Ke-Oe+U}else Ke=tv(S,T,R,M,z,A,Ke),ye=Ke*o+U,Oe=Ke-ye;ye<1&&(ye=0),ft>=Oe/2&&(ft=0),ye<5&&(q=uv);let Xt=ye>0,Dn=Ke-ye-(Xt?ft:0);Oe=q(yp(Dn,K,W)),Pe=(Y==0?Oe/2:Y==ne?0:Oe)-Y*ne*((Y==0?U/2:0)+(Xt?ft/2:0));let Pt={stroke:null,fill:null,clip:null,band:null,gaps:null,flags:0},Tn=et?null:new Path2D,ln=null;if(ge!=null)ln=d.data[ge.series[1]];else{let{y0:He,y1:ct}=c;He!=null&&ct!=null&&(T=ct.values(d,m,b,g),ln=He.values(d,m,b,g))}let An=$*Oe,G=xe*Oe;for(let He=ne==1?b:g;He>=b&&He<=g;He+=ne){let ct=T[He];if(ct==null)continue;if(ln!=null){let ee=ln[He]??0;if(ct-ee==0)continue;Ee=y(ee,P,D,V)}let yt=M.distr!=2||c!=null?S[He]:He,De=R(yt,M,z,A),Kt=y(zt(ct,se),P,D,V),je=q(De-Pe),lt=q(xi(Kt,Ee)),F=q(mr(Kt,Ee)),E=lt-F;if(ct!=null){let ee=ct<0?G:An,be=ct<0?An:G;et?(ft>0&&vt[He]!=null&&re(Zt.get(vt[He]),je,F+Oi(ft/2),Oe,xi(0,E-ft),ee,be),St[He]!=null&&re(bt.get(St[He]),je,F+Oi(ft/2),Oe,xi(0,E-ft),ee,be)):re(Tn,je,F+Oi(ft/2),Oe,xi(0,E-ft),ee,be),de(d,m,He,je-ft/2,F,Oe+ft,E)}}return ft>0?Pt.stroke=et?Zt:Tn:et||(Pt._fill=_.width==0?_._fill:_._stroke??_._fill,Pt.width=0),Pt.fill=et?bt:Tn,Pt})}function UA(i,e){let t=zt(e?.alignGaps,0);return(n,r,s,o)=>To(n,r,(a,l,c,u,h,f,d,m,b,g,_)=>{[s,o]=Ih(c,s,o);let S=a.pxRound,T=$=>S(f($,u,g,m)),M=$=>S(d($,h,_,b)),P,R,y;u.ori==0?(P=Fh,y=Oa,R=Ov):(P=Uh,y=Ba,R=Bv);let A=u.dir*(u.ori==0?1:-1),V=T(l[A==1?s:o]),z=V,D=[],q=[];for(let $=A==1?s:o;$>=s&&$<=o;$+=A)if(c[$]!=null){let ne=l[$],re=T(ne);D.push(z=re),q.push(M(c[$]))}let Y={stroke:i(D,q,P,y,R,S),fill:null,clip:null,band:null,gaps:null,flags:Fa},U=Y.stroke,[W,K]=Op(n,r);if(a.fill!=null||W!=0){let $=Y.fill=new Path2D(U),xe=a.fillTo(n,r,a.min,a.max,W),ne=M(xe);y($,z,ne),y($,V,ne)}if(!a.spanGaps){let $=[];$.push(...Bp(l,c,s,o,A,T,t)),Y.gaps=$=a.gaps(n,r,s,o,$),Y.clip=Dh($,u.ori,m,b,g,_)}return K!=0&&(Y.band=K==2?[gs(n,r,s,o,U,-1),gs(n,r,s,o,U,1)]:gs(n,r,s,o,U,K)),Y})}function OA(i){return UA(BA,i)}function BA(i,e,t,n,r,s){let o=i.length;if(o<2)return null;let a=new Path2D;if(t(a,i[0],e[0]),o==2)n(a,i[1],e[1]);else{let l=Array(o),c=Array(o-1),u=Array(o-1),h=Array(o-1);for(let f=0;f<o-1;f++)u[f]=e[f+1]-e[f],h[f]=i[f+1]-i[f],c[f]=u[f]/h[f];l[0]=c[0];for(let f=1;f<o-1;f++)c[f]===0||c[f-1]===0||c[f-1]>0!=c[f]>0?l[f]=0:(l[f]=3*(h[f-1]+h[f])/((2*h[f]+h[f-1])/c[f-1]+(h[f]+2*h[f-1])/c[f]),isFinite(l[f])||(l[f]=0));l[o-1]=c[o-2];for(let f=0;f<o-1;f++)r(a,i[f]+h[f]/3,e[f]+l[f]*h[f]/3,i[f+1]-h[f]/3,e[f+1]-l[f+1]*h[f]/3,i[f+1],e[f+1])}return a}var Mp=new Set;function nv(){for(let i of Mp)i.syncRect(!0)}Ua&&(So(xT,Pa,nv),So(vT,Pa,nv,!0),So(Eh,Pa,()=>{ni.pxRatio=Wt}));var zA=Vv(),kA=zv();function iv(i,e,t,n){return(n?[i[0],i[1]].concat(i.slice(2)):[i[0]].concat(i.slice(1))).map((s,o)=>Tp(s,o,e,t))}function VA(i,e){return i.map((t,n)=>n==0?{}:On({},e,t))}function Tp(i,e,t,n){return On({},e==0?t:n,i)}function Hv(i,e,t){return e==null?Na:[e,t]}var HA=Hv;function GA(i,e,t){return e==null?Na:Rh(e,t,Ip,!0)}function Gv(i,e,t,n){return e==null?Na:Ph(e,t,i.scales[n].log,!1)}var WA=Gv;function Wv(i,e,t,n){return e==null?Na:Cp(e,t,i.scales[n].log,!1)}var XA=Wv;function qA(i,e,t,n,r){let s=xi(Fx(i),Fx(e)),o=e-i,a=pr(r/n*o,t);do{let l=t[a],c=n*l/o;if(c>=r&&s+(l<5?Hs.get(l):0)<=17)return[l,c]}while(++a<t.length);return[0,0]}function rv(i){let e,t;return i=i.replace(/(\d+)px/,(n,r)=>(e=kn((t=+r)*Wt))+"px"),[i,e,t]}function YA(i){i.show&&[i.font,i.labelFont].forEach(e=>{let t=on(e[2]*Wt,1);e[0]=e[0].replace(/[0-9.]+px/,t+"px"),e[1]=t})}function ni(i,e,t){let n={mode:zt(i.mode,1)},r=n.mode;function s(w,I,B,k){let Z=I.valToPct(w);return k+B*(I.dir==-1?1-Z:Z)}function o(w,I,B,k){let Z=I.valToPct(w);return k+B*(I.dir==-1?Z:1-Z)}function a(w,I,B,k){return I.ori==0?s(w,I,B,k):o(w,I,B,k)}n.valToPosH=s,n.valToPosV=o;let l=!1;n.status=0;let c=n.root=$i(eT);if(i.id!=null&&(c.id=i.id),Ui(c,i.class),i.title){let w=$i(iT,c);w.textContent=i.title}let u=dr("canvas"),h=n.ctx=u.getContext("2d"),f=$i(rT,c);So("click",f,w=>{w.target===m&&(un!=Ro||gn!=Co)&&Qn.click(n,w)},!0);let d=n.under=$i(sT,f);f.appendChild(u);let m=n.over=$i(oT,f);i=Da(i);let b=+zt(i.pxAlign,1),g=ev(b);(i.plugins||[]).forEach(w=>{w.opts&&(i=w.opts(n,i)||i)});let _=i.ms||.001,S=n.series=r==1?iv(i.series||[],Yx,jx,!1):VA(i.series||[null],Jx),T=n.axes=iv(i.axes||[],qx,Zx,!0),M=n.scales={},P=n.bands=i.bands||[];P.forEach(w=>{w.fill=Dt(w.fill||null),w.dir=zt(w.dir,-1)});let R=r==2?S[1].facets[0].scale:S[0].scale,y={axes:ut,series:Se},A=(i.drawOrder||["axes","series"]).map(w=>y[w]);function V(w){let I=w.distr==3?B=>ms(B>0?B:w.clamp(n,B,w.min,w.max,w.key)):w.distr==4?B=>fp(B,w.asinh):w.distr==100?B=>w.fwd(B):B=>B;return B=>{let k=I(B),{_min:Z,_max:ie}=w,_e=ie-Z;return(k-Z)/_e}}function z(w){let I=M[w];if(I==null){let B=(i.scales||nc)[w]||nc;if(B.from!=null){z(B.from);let k=On({},M[B.from],B,{key:w});k.valToPct=V(k),M[w]=k}else{I=M[w]=On({},w==R?Lv:CA,B),I.key=w;let k=I.time,Z=I.range,ie=Vs(Z);if((w!=R||r==2&&!k)&&(ie&&(Z[0]==null||Z[1]==null)&&(Z={min:Z[0]==null?Lx:{mode:1,hard:Z[0],soft:Z[0]},max:Z[1]==null?Lx:{mode:1,hard:Z[1],soft:Z[1]}},ie=!1),!ie&&Nh(Z))){let _e=Z;Z=(Ie,ze,$e)=>ze==null?Na:Rh(ze,$e,_e)}I.range=Dt(Z||(k?HA:w==R?I.distr==3?WA:I.distr==4?XA:Hv:I.distr==3?Gv:I.distr==4?Wv:GA)),I.auto=Dt(ie?!1:I.auto),I.clamp=Dt(I.clamp||RA),I._min=I._max=null,I.valToPct=V(I)}}}z("x"),z("y"),r==1&&S.forEach(w=>{z(w.scale)}),T.forEach(w=>{z(w.scale)});for(let w in i.scales)z(w);let D=M[R],q=D.distr,Y,U;D.ori==0?(Ui(c,tT),Y=s,U=o):(Ui(c,nT),Y=o,U=s);let W={};for(let w in M){let I=M[w];(I.min!=null||I.max!=null)&&(W[w]={min:I.min,max:I.max},I.min=I.max=null)}let K=i.tzDate||(w=>new Date(kn(w/_))),$=i.fmtDate||Np,xe=_==1?tA(K):rA(K),ne=Gx(K,Hx(_==1?eA:iA,$)),re=Xx(K,Wx(oA,$)),de=[],ge=n.legend=On({},cA,i.legend),pe=n.cursor=On({},mA,{drag:{y:r==2}},i.cursor),se=ge.show,Ee=pe.show,Pe=ge.markers;ge.idxs=de,Pe.width=Dt(Pe.width),Pe.dash=Dt(Pe.dash),Pe.stroke=Dt(Pe.stroke),Pe.fill=Dt(Pe.fill);let Oe,ye,Ke,ft=[],et=[],St,bt=!1,vt={};if(ge.live){let w=S[1]?S[1].values:null;bt=w!=null,St=bt?w(n,1,0):{_:0};for(let I in St)vt[I]=Ep}if(se)if(Oe=dr("table",fT,c),Ke=dr("tbody",null,Oe),ge.mount(n,Oe),bt){ye=dr("thead",null,Oe,Ke);let w=dr("tr",null,ye);dr("th",null,w);for(var Zt in St)dr("th",vx,w).textContent=Zt}else Ui(Oe,pT),ge.live&&Ui(Oe,dT);let kt={show:!0},mn={show:!1};function Xt(w,I){if(I==0&&(bt||!ge.live||r==2))return Na;let B=[],k=dr("tr",mT,Ke,Ke.childNodes[I]);Ui(k,w.class),w.show||Ui(k,wo);let Z=dr("th",null,k);if(Pe.show){let Ie=$i(gT,Z);if(I>0){let ze=Pe.width(n,I);ze&&(Ie.style.border=ze+"px "+Pe.dash(n,I)+" "+Pe.stroke(n,I)),Ie.style.background=Pe.fill(n,I)}}let ie=$i(vx,Z);w.label instanceof HTMLElement?ie.appendChild(w.label):ie.textContent=w.label,I>0&&(Pe.show||(ie.style.color=w.width>0?Pe.stroke(n,I):Pe.fill(n,I)),Pt("click",Z,Ie=>{if(pe._lock)return;pt(Ie);let ze=S.indexOf(w);if((Ie.ctrlKey||Ie.metaKey)!=ge.isolate){let $e=S.some((Ze,Qe)=>Qe>0&&Qe!=ze&&Ze.show);S.forEach((Ze,Qe)=>{Qe>0&&vr(Qe,$e?Qe==ze?kt:mn:kt,!0,Fn.setSeries)})}else vr(ze,{show:!w.show},!0,Fn.setSeries)},!1),mt&&Pt(Sx,Z,Ie=>{pe._lock||(pt(Ie),vr(S.indexOf(w),Po,!0,Fn.setSeries))},!1));for(var _e in St){let Ie=dr("td",_T,k);Ie.textContent="--",B.push(Ie)}return[k,B]}let Dn=new Map;function Pt(w,I,B,k=!0){let Z=Dn.get(I)||{},ie=pe.bind[w](n,I,B,k);ie&&(So(w,I,Z[w]=ie),Dn.set(I,Z))}function Tn(w,I,B){let k=Dn.get(I)||{};for(let Z in k)(w==null||Z==w)&&(vp(Z,I,k[Z]),delete k[Z]);w==null&&Dn.delete(I)}let ln=0,An=0,G=0,He=0,ct=0,yt=0,De=ct,Kt=yt,je=G,lt=He,F=0,E=0,ee=0,be=0;n.bbox={};let me=!1,Ne=!1,Fe=!1,ae=!1,he=!1,Re=!1;function H(w,I,B){(B||w!=n.width||I!=n.height)&&ue(w,I),qe(!1),Fe=!0,Ne=!0,bn()}function ue(w,I){n.width=ln=G=w,n.height=An=He=I,ct=yt=0,Be(),tt();let B=n.bbox;F=B.left=yo(ct*Wt,.5),E=B.top=yo(yt*Wt,.5),ee=B.width=yo(G*Wt,.5),be=B.height=yo(He*Wt,.5)}let oe=3;function ke(){let w=!1,I=0;for(;!w;){I++;let B=Ft(I),k=Tt(I);w=I==oe||B&&k,w||(ue(n.width,n.height),Ne=!0)}}function Le({width:w,height:I}){H(w,I)}n.setSize=Le;function Be(){let w=!1,I=!1,B=!1,k=!1;T.forEach((Z,ie)=>{if(Z.show&&Z._show){let{side:_e,_size:Ie}=Z,ze=_e%2,$e=Z.label!=null?Z.labelSize:0,Ze=Ie+$e;Ze>0&&(ze?(G-=Ze,_e==3?(ct+=Ze,k=!0):B=!0):(He-=Ze,_e==0?(yt+=Ze,w=!0):I=!0))}}),zi[0]=w,zi[1]=B,zi[2]=I,zi[3]=k,G-=Mi[1]+Mi[3],ct+=Mi[3],He-=Mi[2]+Mi[0],yt+=Mi[0]}function tt(){let w=ct+G,I=yt+He,B=ct,k=yt;function Z(ie,_e){switch(ie){case 1:return w+=_e,w-_e;case 2:return I+=_e,I-_e;case 3:return B-=_e,B+_e;case 0:return k-=_e,k+_e}}T.forEach((ie,_e)=>{if(ie.show&&ie._show){let Ie=ie.side;ie._pos=Z(Ie,ie._size),ie.label!=null&&(ie._lpos=Z(Ie,ie.labelSize))}})}if(pe.dataIdx==null){let w=pe.hover,I=w.skip=new Set(w.skip??[]);I.add(void 0);let B=w.prox=Dt(w.prox),k=w.bias??=0;pe.dataIdx=(Z,ie,_e,Ie)=>{if(ie==0)return _e;let ze=_e,$e=B(Z,ie,_e,Ie)??sn,Ze=$e>=0&&$e<sn,Qe=D.ori==0?G:He,wt=pe.left,Ht=e[0],Bt=e[ie];if(I.has(Bt[_e])){ze=null;let Lt=null,gt=null,st;if(k==0||k==-1)for(st=_e;Lt==null&&st-- >0;)I.has(Bt[st])||(Lt=st);if(k==0||k==1)for(st=_e;gt==null&&st++<Bt.length;)I.has(Bt[st])||(gt=st);if(Lt!=null||gt!=null)if(Ze){let fn=Lt==null?-1/0:Y(Ht[Lt],D,Qe,0),En=gt==null?1/0:Y(Ht[gt],D,Qe,0),qn=wt-fn,en=En-wt;qn<=en?qn<=$e&&(ze=Lt):en<=$e&&(ze=gt)}else ze=gt==null?Lt:Lt==null?gt:_e-Lt<=gt-_e?Lt:gt}else Ze&&Vn(wt-Y(Ht[_e],D,Qe,0))>$e&&(ze=null);return ze}}let pt=w=>{pe.event=w};pe.idxs=de,pe._lock=!1;let we=pe.points;we.show=Dt(we.show),we.size=Dt(we.size),we.stroke=Dt(we.stroke),we.width=Dt(we.width),we.fill=Dt(we.fill);let Je=n.focus=On({},i.focus||{alpha:.3},pe.focus),mt=Je.prox>=0,Ge=mt&&we.one,Mt=[],nn=[],jn=[];function Ws(w,I){let B=we.show(n,I);if(B instanceof HTMLElement)return Ui(B,hT),Ui(B,w.class),kr(B,-10,-10,G,He),m.insertBefore(B,Mt[I]),B}function _s(w,I){if(r==1||I>0){let B=r==1&&M[w.scale].time,k=w.value;w.value=B?Bx(k)?Xx(K,Wx(k,$)):k||re:k||TA,w.label=w.label||(B?_A:gA)}if(Ge||I>0){w.width=w.width==null?1:w.width,w.paths=w.paths||zA||CT,w.fillTo=Dt(w.fillTo||IA),w.pxAlign=+zt(w.pxAlign,b),w.pxRound=ev(w.pxAlign),w.stroke=Dt(w.stroke||null),w.fill=Dt(w.fill||null),w._stroke=w._fill=w._paths=w._focus=null;let B=AA(xi(1,w.width),1),k=w.points=On({},{size:B,width:xi(1,B*.2),stroke:w.stroke,space:B*2,paths:kA,_stroke:null,_fill:null},w.points);k.show=Dt(k.show),k.filter=Dt(k.filter),k.fill=Dt(k.fill),k.stroke=Dt(k.stroke),k.paths=Dt(k.paths),k.pxAlign=w.pxAlign}if(se){let B=Xt(w,I);ft.splice(I,0,B[0]),et.splice(I,0,B[1]),ge.values.push(null)}if(Ee){de.splice(I,0,null);let B=null;Ge?I==0&&(B=Ws(w,I)):I>0&&(B=Ws(w,I)),Mt.splice(I,0,B),nn.splice(I,0,0),jn.splice(I,0,0)}Xn("addSeries",I)}function ka(w,I){I=I??S.length,w=r==1?Tp(w,I,Yx,jx):Tp(w,I,{},Jx),S.splice(I,0,w),_s(S[I],I)}n.addSeries=ka;function Xs(w){if(S.splice(w,1),se){ge.values.splice(w,1),et.splice(w,1);let I=ft.splice(w,1)[0];Tn(null,I.firstChild),I.remove()}Ee&&(de.splice(w,1),Mt.splice(w,1)[0].remove(),nn.splice(w,1),jn.splice(w,1)),Xn("delSeries",w)}n.delSeries=Xs;let zi=[!1,!1,!1,!1];function ji(w,I){if(w._show=w.show,w.show){let B=w.side%2,k=M[w.scale];k==null&&(w.scale=B?S[1].scale:R,k=M[w.scale]);let Z=k.time;w.size=Dt(w.size),w.space=Dt(w.space),w.rotate=Dt(w.rotate),Vs(w.incrs)&&w.incrs.forEach(_e=>{!Hs.has(_e)&&Hs.set(_e,dv(_e))}),w.incrs=Dt(w.incrs||(k.distr==2?JT:Z?_==1?QT:nA:bo)),w.splits=Dt(w.splits||(Z&&k.distr==1?xe:k.distr==3?bp:k.distr==4?yA:vA)),w.stroke=Dt(w.stroke),w.grid.stroke=Dt(w.grid.stroke),w.ticks.stroke=Dt(w.ticks.stroke),w.border.stroke=Dt(w.border.stroke);let ie=w.values;w.values=Vs(ie)&&!Vs(ie[0])?Dt(ie):Z?Vs(ie)?Gx(K,Hx(ie,$)):Bx(ie)?sA(K,ie):ie||ne:ie||xA,w.filter=Dt(w.filter||(k.distr>=3&&k.log==10?SA:k.distr==3&&k.log==2?MA:hv)),w.font=rv(w.font),w.labelFont=rv(w.labelFont),w._size=w.size(n,null,I,0),w._space=w._rotate=w._incrs=w._found=w._splits=w._values=null,w._size>0&&(zi[I]=!0,w._el=$i(aT,f))}}function Qi(w,I,B,k){let[Z,ie,_e,Ie]=B,ze=I%2,$e=0;return ze==0&&(Ie||ie)&&($e=I==0&&!Z||I==2&&!_e?kn(qx.size/3):0),ze==1&&(Z||_e)&&($e=I==1&&!ie||I==3&&!Ie?kn(Zx.size/2):0),$e}let xs=n.padding=(i.padding||[Qi,Qi,Qi,Qi]).map(w=>Dt(zt(w,Qi))),Mi=n._padding=xs.map((w,I)=>w(n,I,zi,0)),cn,xn=null,vn=null,ci=r==1?S[0].idxs:null,Hn=null,gr=!1;function _r(w,I){if(e=w??[],n.data=n._data=e,r==2){cn=0;for(let B=1;B<S.length;B++)cn+=e[B][0].length}else{e.length==0&&(n.data=n._data=e=[[]]),Hn=e[0],cn=Hn.length;let B=e;if(q==2){B=e.slice();let k=B[0]=Array(cn);for(let Z=0;Z<cn;Z++)k[Z]=Z}n._data=e=B}if(qe(!0),Xn("setData"),q==2&&(Fe=!0),I!==!1){let B=D;B.auto(n,gr)?vs():Ss(R,B.min,B.max),ae=ae||pe.left>=0,Re=!0,bn()}}n.setData=_r;function vs(){gr=!0;let w,I;r==1&&(cn>0?(xn=ci[0]=0,vn=ci[1]=cn-1,w=e[0][xn],I=e[0][vn],q==2?(w=xn,I=vn):w==I&&(q==3?[w,I]=Ph(w,w,D.log,!1):q==4?[w,I]=Cp(w,w,D.log,!1):D.time?I=w+kn(86400/_):[w,I]=Rh(w,I,Ip,!0))):(xn=ci[0]=w=null,vn=ci[1]=I=null)),Ss(R,w,I)}let yn,Pn,x,p,v,C,L,O,N,j;function X(w,I,B,k,Z,ie){w??=bx,B??=Lp,k??="butt",Z??=bx,ie??="round",w!=yn&&(h.strokeStyle=yn=w),Z!=Pn&&(h.fillStyle=Pn=Z),I!=x&&(h.lineWidth=x=I),ie!=v&&(h.lineJoin=v=ie),k!=C&&(h.lineCap=C=k),B!=p&&h.setLineDash(p=B)}function Q(w,I,B,k){I!=Pn&&(h.fillStyle=Pn=I),w!=L&&(h.font=L=w),B!=O&&(h.textAlign=O=B),k!=N&&(h.textBaseline=N=k)}function te(w,I,B,k,Z=0){if(k.length>0&&w.auto(n,gr)&&(I==null||I.min==null)){let ie=zt(xn,0),_e=zt(vn,k.length-1),Ie=B.min==null?ST(k,ie,_e,Z,w.distr==3):[B.min,B.max];w.min=mr(w.min,B.min=Ie[0]),w.max=xi(w.max,B.max=Ie[1])}}let fe={min:null,max:null};function le(){for(let k in M){let Z=M[k];W[k]==null&&(Z.min==null||W[R]!=null&&Z.auto(n,gr))&&(W[k]=fe)}for(let k in M){let Z=M[k];W[k]==null&&Z.from!=null&&W[Z.from]!=null&&(W[k]=fe)}W[R]!=null&&qe(!0);let w={};for(let k in W){let Z=W[k];if(Z!=null){let ie=w[k]=Da(M[k],LT);if(Z.min!=null)On(ie,Z);else if(k!=R||r==2)if(cn==0&&ie.from==null){let _e=ie.range(n,null,null,k);ie.min=_e[0],ie.max=_e[1]}else ie.min=sn,ie.max=-sn}}if(cn>0){S.forEach((k,Z)=>{if(r==1){let ie=k.scale,_e=W[ie];if(_e==null)return;let Ie=w[ie];if(Z==0){let ze=Ie.range(n,Ie.min,Ie.max,ie);Ie.min=ze[0],Ie.max=ze[1],xn=pr(Ie.min,e[0]),vn=pr(Ie.max,e[0]),vn-xn>1&&(e[0][xn]<Ie.min&&xn++,e[0][vn]>Ie.max&&vn--),k.min=Hn[xn],k.max=Hn[vn]}else k.show&&k.auto&&te(Ie,_e,k,e[Z],k.sorted);k.idxs[0]=xn,k.idxs[1]=vn}else if(Z>0&&k.show&&k.auto){let[ie,_e]=k.facets,Ie=ie.scale,ze=_e.scale,[$e,Ze]=e[Z],Qe=w[Ie],wt=w[ze];Qe!=null&&te(Qe,W[Ie],ie,$e,ie.sorted),wt!=null&&te(wt,W[ze],_e,Ze,_e.sorted),k.min=_e.min,k.max=_e.max}});for(let k in w){let Z=w[k],ie=W[k];if(Z.from==null&&(ie==null||ie.min==null)){let _e=Z.range(n,Z.min==sn?null:Z.min,Z.max==-sn?null:Z.max,k);Z.min=_e[0],Z.max=_e[1]}}}for(let k in w){let Z=w[k];if(Z.from!=null){let ie=w[Z.from];if(ie.min==null)Z.min=Z.max=null;else{let _e=Z.range(n,ie.min,ie.max,k);Z.min=_e[0],Z.max=_e[1]}}}let I={},B=!1;for(let k in w){let Z=w[k],ie=M[k];if(ie.min!=Z.min||ie.max!=Z.max){ie.min=Z.min,ie.max=Z.max;let _e=ie.distr;ie._min=_e==3?ms(ie.min):_e==4?fp(ie.min,ie.asinh):_e==100?ie.fwd(ie.min):ie.min,ie._max=_e==3?ms(ie.max):_e==4?fp(ie.max,ie.asinh):_e==100?ie.fwd(ie.max):ie.max,I[k]=B=!0}}if(B){S.forEach((k,Z)=>{r==2?Z>0&&I.y&&(k._paths=null):I[k.scale]&&(k._paths=null)});for(let k in I)Fe=!0,Xn("setScale",k);Ee&&pe.left>=0&&(ae=Re=!0)}for(let k in W)W[k]=null}function ce(w){let I=yp(xn-1,0,cn-1),B=yp(vn+1,0,cn-1);for(;w[I]==null&&I>0;)I--;for(;w[B]==null&&B<cn-1;)B++;return[I,B]}function Se(){if(cn>0){let w=S.some(I=>I._focus)&&j!=Je.alpha;w&&(h.globalAlpha=j=Je.alpha),S.forEach((I,B)=>{if(B>0&&I.show&&(Te(B,!1),Te(B,!0),I._paths==null)){let k=j;j!=I.alpha&&(h.globalAlpha=j=I.alpha);let Z=r==2?[0,e[B][0].length-1]:ce(e[B]);I._paths=I.paths(n,B,Z[0],Z[1]),j!=k&&(h.globalAlpha=j=k)}}),S.forEach((I,B)=>{if(B>0&&I.show){let k=j;j!=I.alpha&&(h.globalAlpha=j=I.alpha),I._paths!=null&&Ae(B,!1);{let Z=I._paths!=null?I._paths.gaps:null,ie=I.points.show(n,B,xn,vn,Z),_e=I.points.filter(n,B,ie,Z);(ie||_e)&&(I.points._paths=I.points.paths(n,B,xn,vn,_e),Ae(B,!0))}j!=k&&(h.globalAlpha=j=k),Xn("drawSeries",B)}}),w&&(h.globalAlpha=j=1)}}function Te(w,I){let B=I?S[w].points:S[w];B._stroke=B.stroke(n,w),B._fill=B.fill(n,w)}function Ae(w,I){let B=I?S[w].points:S[w],{stroke:k,fill:Z,clip:ie,flags:_e,_stroke:Ie=B._stroke,_fill:ze=B._fill,_width:$e=B.width}=B._paths;$e=on($e*Wt,3);let Ze=null,Qe=$e%2/2;I&&ze==null&&(ze=$e>0?"#fff":Ie);let wt=B.pxAlign==1&&Qe>0;if(wt&&h.translate(Qe,Qe),!I){let Ht=F-$e/2,Bt=E-$e/2,Lt=ee+$e,gt=be+$e;Ze=new Path2D,Ze.rect(Ht,Bt,Lt,gt)}I?ve(Ie,$e,B.dash,B.cap,ze,k,Z,_e,ie):Ve(w,Ie,$e,B.dash,B.cap,ze,k,Z,_e,Ze,ie),wt&&h.translate(-Qe,-Qe)}function Ve(w,I,B,k,Z,ie,_e,Ie,ze,$e,Ze){let Qe=!1;ze!=0&&P.forEach((wt,Ht)=>{if(wt.series[0]==w){let Bt=S[wt.series[1]],Lt=e[wt.series[1]],gt=(Bt._paths||nc).band;Vs(gt)&&(gt=wt.dir==1?gt[0]:gt[1]);let st,fn=null;Bt.show&&gt&&TT(Lt,xn,vn)?(fn=wt.fill(n,Ht)||ie,st=Bt._paths.clip):gt=null,ve(I,B,k,Z,fn,_e,Ie,ze,$e,Ze,st,gt),Qe=!0}}),Qe||ve(I,B,k,Z,ie,_e,Ie,ze,$e,Ze)}let rt=Fa|Sp;function ve(w,I,B,k,Z,ie,_e,Ie,ze,$e,Ze,Qe){X(w,I,B,k,Z),(ze||$e||Qe)&&(h.save(),ze&&h.clip(ze),$e&&h.clip($e)),Qe?(Ie&rt)==rt?(h.clip(Qe),Ze&&h.clip(Ze),Ce(Z,_e),ot(w,ie,I)):Ie&Sp?(Ce(Z,_e),h.clip(Qe),ot(w,ie,I)):Ie&Fa&&(h.save(),h.clip(Qe),Ze&&h.clip(Ze),Ce(Z,_e),h.restore(),ot(w,ie,I)):(Ce(Z,_e),ot(w,ie,I)),(ze||$e||Qe)&&h.restore()}function ot(w,I,B){B>0&&(I instanceof Map?I.forEach((k,Z)=>{h.strokeStyle=yn=Z,h.stroke(k)}):I!=null&&w&&h.stroke(I))}function Ce(w,I){I instanceof Map?I.forEach((B,k)=>{h.fillStyle=Pn=k,h.fill(B)}):I!=null&&w&&h.fill(I)}function Xe(w,I,B,k){let Z=T[w],ie;if(k<=0)ie=[0,0];else{let _e=Z._space=Z.space(n,w,I,B,k),Ie=Z._incrs=Z.incrs(n,w,I,B,k,_e);ie=qA(I,B,Ie,k,_e)}return Z._found=ie}function We(w,I,B,k,Z,ie,_e,Ie,ze,$e){let Ze=_e%2/2;b==1&&h.translate(Ze,Ze),X(Ie,_e,ze,$e,Ie),h.beginPath();let Qe,wt,Ht,Bt,Lt=Z+(k==0||k==3?-ie:ie);B==0?(wt=Z,Bt=Lt):(Qe=Z,Ht=Lt);for(let gt=0;gt<w.length;gt++)I[gt]!=null&&(B==0?Qe=Ht=w[gt]:wt=Bt=w[gt],h.moveTo(Qe,wt),h.lineTo(Ht,Bt));h.stroke(),b==1&&h.translate(-Ze,-Ze)}function Ft(w){let I=!0;return T.forEach((B,k)=>{if(!B.show)return;let Z=M[B.scale];if(Z.min==null){B._show&&(I=!1,B._show=!1,qe(!1));return}else B._show||(I=!1,B._show=!0,qe(!1));let ie=B.side,_e=ie%2,{min:Ie,max:ze}=Z,[$e,Ze]=Xe(k,Ie,ze,_e==0?G:He);if(Ze==0)return;let Qe=Z.distr==2,wt=B._splits=B.splits(n,k,Ie,ze,$e,Ze,Qe),Ht=Z.distr==2?wt.map(st=>Hn[st]):wt,Bt=Z.distr==2?Hn[wt[1]]-Hn[wt[0]]:$e,Lt=B._values=B.values(n,B.filter(n,Ht,k,Ze,Bt),k,Ze,Bt);B._rotate=ie==2?B.rotate(n,Lt,k,Ze):0;let gt=B._size;B._size=Zi(B.size(n,Lt,k,w)),gt!=null&&B._size!=gt&&(I=!1)}),I}function Tt(w){let I=!0;return xs.forEach((B,k)=>{let Z=B(n,k,zi,w);Z!=Mi[k]&&(I=!1),Mi[k]=Z}),I}function ut(){for(let w=0;w<T.length;w++){let I=T[w];if(!I.show||!I._show)continue;let B=I.side,k=B%2,Z,ie,_e=I.stroke(n,w),Ie=B==0||B==3?-1:1,[ze,$e]=I._found;if(I.label!=null){let hi=I.labelGap*Ie,Ri=kn((I._lpos+hi)*Wt);Q(I.labelFont[0],_e,"center",B==2?"top":yx),h.save(),k==1?(Z=ie=0,h.translate(Ri,kn(E+be/2)),h.rotate((B==3?-Ah:Ah)/2)):(Z=kn(F+ee/2),ie=Ri);let $s=cv(I.label)?I.label(n,w,ze,$e):I.label;h.fillText($s,Z,ie),h.restore()}if($e==0)continue;let Ze=M[I.scale],Qe=k==0?ee:be,wt=k==0?F:E,Ht=I._splits,Bt=Ze.distr==2?Ht.map(hi=>Hn[hi]):Ht,Lt=Ze.distr==2?Hn[Ht[1]]-Hn[Ht[0]]:ze,gt=I.ticks,st=I.border,fn=gt.show?gt.size:0,En=kn(fn*Wt),qn=kn((I.alignTo==2?I._size-fn-I.gap:I.gap)*Wt),en=I._rotate*-Ah/180,Rn=g(I._pos*Wt),Ai=(En+qn)*Ie,ui=Rn+Ai;ie=k==0?ui:0,Z=k==1?ui:0;let Vi=I.font[0],nr=I.align==1?Ca:I.align==2?cp:en>0?Ca:en<0?cp:k==0?"center":B==3?cp:Ca,br=en||k==1?"middle":B==2?"top":yx;Q(Vi,_e,nr,br);let Ei=I.font[1]*I.lineGap,Hi=Ht.map(hi=>g(a(hi,Ze,Qe,wt))),ir=I._values;for(let hi=0;hi<ir.length;hi++){let Ri=ir[hi];if(Ri!=null){k==0?Z=Hi[hi]:ie=Hi[hi],Ri=""+Ri;let $s=Ri.indexOf(`
`)==-1?[Ri]:Ri.split(/\n/gm);for(let fi=0;fi<$s.length;fi++){let Um=$s[fi];en?(h.save(),h.translate(Z,ie+fi*Ei),h.rotate(en),h.fillText(Um,0,0),h.restore()):h.fillText(Um,Z,ie+fi*Ei)}}}gt.show&&We(Hi,gt.filter(n,Bt,w,$e,Lt),k,B,Rn,En,on(gt.width*Wt,3),gt.stroke(n,w),gt.dash,gt.cap);let wr=I.grid;wr.show&&We(Hi,wr.filter(n,Bt,w,$e,Lt),k,k==0?2:1,k==0?E:F,k==0?be:ee,on(wr.width*Wt,3),wr.stroke(n,w),wr.dash,wr.cap),st.show&&We([Rn],[1],k==0?1:0,k==0?1:2,k==1?E:F,k==1?be:ee,on(st.width*Wt,3),st.stroke(n,w),st.dash,st.cap)}Xn("drawAxes")}function qe(w){S.forEach((I,B)=>{B>0&&(I._paths=null,w&&(r==1?(I.min=null,I.max=null):I.facets.forEach(k=>{k.min=null,k.max=null})))})}let At=!1,Jt=!1,at=[];function Vt(){Jt=!1;for(let w=0;w<at.length;w++)Xn(...at[w]);at.length=0}function bn(){At||(zT(Ti),At=!0)}function xr(w,I=!1){At=!0,Jt=I,w(n),Ti(),I&&at.length>0&&queueMicrotask(Vt)}n.batch=xr;function Ti(){if(me&&(le(),me=!1),Fe&&(ke(),Fe=!1),Ne){if(pn(d,Ca,ct),pn(d,"top",yt),pn(d,jl,G),pn(d,Ql,He),pn(m,Ca,ct),pn(m,"top",yt),pn(m,jl,G),pn(m,Ql,He),pn(f,jl,ln),pn(f,Ql,An),u.width=kn(ln*Wt),u.height=kn(An*Wt),T.forEach(({_el:w,_show:I,_size:B,_pos:k,side:Z})=>{if(w!=null)if(I){let ie=Z===3||Z===0?B:0,_e=Z%2==1;pn(w,_e?"left":"top",k-ie),pn(w,_e?"width":"height",B),pn(w,_e?"top":"left",_e?yt:ct),pn(w,_e?"height":"width",_e?He:G),xp(w,wo)}else Ui(w,wo)}),yn=Pn=x=v=C=L=O=N=p=null,j=1,Ga(!0),ct!=De||yt!=Kt||G!=je||He!=lt){qe(!1);let w=G/je,I=He/lt;if(Ee&&!ae&&pe.left>=0){pe.left*=w,pe.top*=I,tr&&kr(tr,kn(pe.left),0,G,He),ki&&kr(ki,0,kn(pe.top),G,He);for(let B=0;B<Mt.length;B++){let k=Mt[B];k!=null&&(nn[B]*=w,jn[B]*=I,kr(k,Zi(nn[B]),Zi(jn[B]),G,He))}}if(hn.show&&!he&&hn.left>=0&&hn.width>0){hn.left*=w,hn.width*=w,hn.top*=I,hn.height*=I;for(let B in Kh)pn(Io,B,hn[B])}De=ct,Kt=yt,je=G,lt=He}Xn("setSize"),Ne=!1}ln>0&&An>0&&(h.clearRect(0,0,u.width,u.height),Xn("drawClear"),A.forEach(w=>w()),Xn("draw")),hn.show&&he&&(oc(hn),he=!1),Ee&&ae&&(Ys(null,!0,!1),ae=!1),ge.show&&ge.live&&Re&&($h(),Re=!1),l||(l=!0,n.status=1,Xn("ready")),gr=!1,At=!1}n.redraw=(w,I)=>{Fe=I||!1,w!==!1?Ss(R,D.min,D.max):bn()};function er(w,I){let B=M[w];if(B.from==null){if(cn==0){let k=B.range(n,I.min,I.max,w);I.min=k[0],I.max=k[1]}if(I.min>I.max){let k=I.min;I.min=I.max,I.max=k}if(cn>1&&I.min!=null&&I.max!=null&&I.max-I.min<1e-16)return;w==R&&B.distr==2&&cn>0&&(I.min=pr(I.min,e[0]),I.max=pr(I.max,e[0]),I.min==I.max&&I.max++),W[w]=I,me=!0,bn()}}n.setScale=er;let ys,bs,tr,ki,Hr,ym,Ro,Co,bm,wm,un,gn,ws=!1,Qn=pe.drag,Gn=Qn.x,Wn=Qn.y;Ee&&(pe.x&&(ys=$i(cT,m)),pe.y&&(bs=$i(uT,m)),D.ori==0?(tr=ys,ki=bs):(tr=bs,ki=ys),un=pe.left,gn=pe.top);let hn=n.select=On({show:!0,over:!0,left:0,width:0,top:0,height:0},i.select),Io=hn.show?$i(lT,hn.over?m:d):null;function oc(w,I){if(hn.show){for(let B in w)hn[B]=w[B],B in Kh&&pn(Io,B,w[B]);I!==!1&&Xn("setSelect")}}n.setSelect=oc;function m1(w){if(S[w].show)se&&xp(ft[w],wo);else if(se&&Ui(ft[w],wo),Ee){let B=Ge?Mt[0]:Mt[w];B!=null&&kr(B,-10,-10,G,He)}}function Ss(w,I,B){er(w,{min:I,max:B})}function vr(w,I,B,k){I.focus!=null&&y1(w),I.show!=null&&S.forEach((Z,ie)=>{ie>0&&(w==ie||w==null)&&(Z.show=I.show,m1(ie),r==2?(Ss(Z.facets[0].scale,null,null),Ss(Z.facets[1].scale,null,null)):Ss(Z.scale,null,null),bn())}),B!==!1&&Xn("setSeries",w,I),k&&Wa("setSeries",n,w,I)}n.setSeries=vr;function g1(w,I){On(P[w],I)}function _1(w,I){w.fill=Dt(w.fill||null),w.dir=zt(w.dir,-1),I=I??P.length,P.splice(I,0,w)}function x1(w){w==null?P.length=0:P.splice(w,1)}n.addBand=_1,n.setBand=g1,n.delBand=x1;function v1(w,I){S[w].alpha=I,Ee&&Mt[w]!=null&&(Mt[w].style.opacity=I),se&&ft[w]&&(ft[w].style.opacity=I)}let Gr,Ms,qs,Po={focus:!0};function y1(w){if(w!=qs){let I=w==null,B=Je.alpha!=1;S.forEach((k,Z)=>{if(r==1||Z>0){let ie=I||Z==0||Z==w;k._focus=I?null:ie,B&&v1(Z,ie?1:Je.alpha)}}),qs=w,B&&bn()}}se&&mt&&Pt(Mx,Oe,w=>{pe._lock||(pt(w),qs!=null&&vr(null,Po,!0,Fn.setSeries))});function yr(w,I,B){let k=M[I];B&&(w=w/Wt-(k.ori==1?yt:ct));let Z=G;k.ori==1&&(Z=He,w=Z-w),k.dir==-1&&(w=Z-w);let ie=k._min,_e=k._max,Ie=w/Z,ze=ie+(_e-ie)*Ie,$e=k.distr;return $e==3?La(10,ze):$e==4?ET(ze,k.asinh):$e==100?k.bwd(ze):ze}function b1(w,I){let B=yr(w,R,I);return pr(B,e[0],xn,vn)}n.valToIdx=w=>pr(w,e[0]),n.posToIdx=b1,n.posToVal=yr,n.valToPos=(w,I,B)=>M[I].ori==0?s(w,M[I],B?ee:G,B?F:0):o(w,M[I],B?be:He,B?E:0),n.setCursor=(w,I,B)=>{un=w.left,gn=w.top,Ys(null,I,B)};function Sm(w,I){pn(Io,Ca,hn.left=w),pn(Io,jl,hn.width=I)}function Mm(w,I){pn(Io,"top",hn.top=w),pn(Io,Ql,hn.height=I)}let Va=D.ori==0?Sm:Mm,Ha=D.ori==1?Sm:Mm;function w1(){if(se&&ge.live)for(let w=r==2?1:0;w<S.length;w++){if(w==0&&bt)continue;let I=ge.values[w],B=0;for(let k in I)et[w][B++].firstChild.nodeValue=I[k]}}function $h(w,I){if(w!=null&&(w.idxs?w.idxs.forEach((B,k)=>{de[k]=B}):PT(w.idx)||de.fill(w.idx),ge.idx=de[0]),se&&ge.live){for(let B=0;B<S.length;B++)(B>0||r==1&&!bt)&&S1(B,de[B]);w1()}Re=!1,I!==!1&&Xn("setLegend")}n.setLegend=$h;function S1(w,I){let B=S[w],k=w==0&&q==2?Hn:e[w],Z;bt?Z=B.values(n,w,I)??vt:(Z=B.value(n,I==null?null:k[I],w,I),Z=Z==null?vt:{_:Z}),ge.values[w]=Z}function Ys(w,I,B){bm=un,wm=gn,[un,gn]=pe.move(n,un,gn),pe.left=un,pe.top=gn,Ee&&(tr&&kr(tr,kn(un),0,G,He),ki&&kr(ki,0,kn(gn),G,He));let k,Z=xn>vn;Gr=sn,Ms=null;let ie=D.ori==0?G:He,_e=D.ori==1?G:He;if(un<0||cn==0||Z){k=pe.idx=null;for(let Ie=0;Ie<S.length;Ie++){let ze=Mt[Ie];ze!=null&&kr(ze,-10,-10,G,He)}mt&&vr(null,Po,!0,w==null&&Fn.setSeries),ge.live&&(de.fill(k),Re=!0)}else{let Ie,ze,$e;r==1&&(Ie=D.ori==0?un:gn,ze=yr(Ie,R),k=pe.idx=pr(ze,e[0],xn,vn),$e=Y(e[0][k],D,ie,0));let Ze=-10,Qe=-10,wt=0,Ht=0,Bt=!0,Lt="",gt="";for(let st=r==2?1:0;st<S.length;st++){let fn=S[st],En=de[st],qn=En==null?null:r==1?e[st][En]:e[st][1][En],en=pe.dataIdx(n,st,k,ze),Rn=en==null?null:r==1?e[st][en]:e[st][1][en];if(Re=Re||Rn!=qn||en!=En,de[st]=en,st>0&&fn.show){let Ai=en==null?-10:en==k?$e:Y(r==1?e[0][en]:e[st][0][en],D,ie,0),ui=Rn==null?-10:U(Rn,r==1?M[fn.scale]:M[fn.facets[1].scale],_e,0);if(mt&&Rn!=null){let Vi=D.ori==1?un:gn,nr=Vn(Je.dist(n,st,en,ui,Vi));if(nr<Gr){let br=Je.bias;if(br!=0){let Ei=yr(Vi,fn.scale),Hi=Rn>=0?1:-1,ir=Ei>=0?1:-1;ir==Hi&&(ir==1?br==1?Rn>=Ei:Rn<=Ei:br==1?Rn<=Ei:Rn>=Ei)&&(Gr=nr,Ms=st)}else Gr=nr,Ms=st}}if(Re||Ge){let Vi,nr;D.ori==0?(Vi=Ai,nr=ui):(Vi=ui,nr=Ai);let br,Ei,Hi,ir,wr,hi,Ri=!0,$s=we.bbox;if($s!=null){Ri=!1;let fi=$s(n,st);Hi=fi.left,ir=fi.top,br=fi.width,Ei=fi.height}else Hi=Vi,ir=nr,br=Ei=we.size(n,st);if(hi=we.fill(n,st),wr=we.stroke(n,st),Ge)st==Ms&&Gr<=Je.prox&&(Ze=Hi,Qe=ir,wt=br,Ht=Ei,Bt=Ri,Lt=hi,gt=wr);else{let fi=Mt[st];fi!=null&&(nn[st]=Hi,jn[st]=ir,Px(fi,br,Ei,Ri),Cx(fi,hi,wr),kr(fi,Zi(Hi),Zi(ir),G,He))}}}}if(Ge){let st=Je.prox,fn=qs==null?Gr<=st:Gr>st||Ms!=qs;if(Re||fn){let En=Mt[0];En!=null&&(nn[0]=Ze,jn[0]=Qe,Px(En,wt,Ht,Bt),Cx(En,Lt,gt),kr(En,Zi(Ze),Zi(Qe),G,He))}}}if(hn.show&&ws)if(w!=null){let[Ie,ze]=Fn.scales,[$e,Ze]=Fn.match,[Qe,wt]=w.cursor.sync.scales,Ht=w.cursor.drag;if(Gn=Ht._x,Wn=Ht._y,Gn||Wn){let{left:Bt,top:Lt,width:gt,height:st}=w.select,fn=w.scales[Qe].ori,En=w.posToVal,qn,en,Rn,Ai,ui,Vi=Ie!=null&&$e(Ie,Qe),nr=ze!=null&&Ze(ze,wt);Vi&&Gn?(fn==0?(qn=Bt,en=gt):(qn=Lt,en=st),Rn=M[Ie],Ai=Y(En(qn,Qe),Rn,ie,0),ui=Y(En(qn+en,Qe),Rn,ie,0),Va(mr(Ai,ui),Vn(ui-Ai))):Va(0,ie),nr&&Wn?(fn==1?(qn=Bt,en=gt):(qn=Lt,en=st),Rn=M[ze],Ai=U(En(qn,wt),Rn,_e,0),ui=U(En(qn+en,wt),Rn,_e,0),Ha(mr(Ai,ui),Vn(ui-Ai))):Ha(0,_e)}else Jh()}else{let Ie=Vn(bm-Hr),ze=Vn(wm-ym);if(D.ori==1){let wt=Ie;Ie=ze,ze=wt}Gn=Qn.x&&Ie>=Qn.dist,Wn=Qn.y&&ze>=Qn.dist;let $e=Qn.uni;$e!=null?Gn&&Wn&&(Gn=Ie>=$e,Wn=ze>=$e,!Gn&&!Wn&&(ze>Ie?Wn=!0:Gn=!0)):Qn.x&&Qn.y&&(Gn||Wn)&&(Gn=Wn=!0);let Ze,Qe;Gn&&(D.ori==0?(Ze=Ro,Qe=un):(Ze=Co,Qe=gn),Va(mr(Ze,Qe),Vn(Qe-Ze)),Wn||Ha(0,_e)),Wn&&(D.ori==1?(Ze=Ro,Qe=un):(Ze=Co,Qe=gn),Ha(mr(Ze,Qe),Vn(Qe-Ze)),Gn||Va(0,ie)),!Gn&&!Wn&&(Va(0,0),Ha(0,0))}if(Qn._x=Gn,Qn._y=Wn,w==null){if(B){if(Fm!=null){let[Ie,ze]=Fn.scales;Fn.values[0]=Ie!=null?yr(D.ori==0?un:gn,Ie):null,Fn.values[1]=ze!=null?yr(D.ori==1?un:gn,ze):null}Wa(up,n,un,gn,G,He,k)}if(mt){let Ie=B&&Fn.setSeries,ze=Je.prox;qs==null?Gr<=ze&&vr(Ms,Po,!0,Ie):Gr>ze?vr(null,Po,!0,Ie):Ms!=qs&&vr(Ms,Po,!0,Ie)}}Re&&(ge.idx=k,$h()),I!==!1&&Xn("setCursor")}let Ts=null;Object.defineProperty(n,"rect",{get(){return Ts==null&&Ga(!1),Ts}});function Ga(w=!1){w?Ts=null:(Ts=m.getBoundingClientRect(),Xn("syncRect",Ts))}function Tm(w,I,B,k,Z,ie,_e){pe._lock||ws&&w!=null&&w.movementX==0&&w.movementY==0||(Zh(w,I,B,k,Z,ie,_e,!1,w!=null),w!=null?Ys(null,!0,!0):Ys(I,!0,!1))}function Zh(w,I,B,k,Z,ie,_e,Ie,ze){if(Ts==null&&Ga(!1),pt(w),w!=null)B=w.clientX-Ts.left,k=w.clientY-Ts.top;else{if(B<0||k<0){un=-10,gn=-10;return}let[$e,Ze]=Fn.scales,Qe=I.cursor.sync,[wt,Ht]=Qe.values,[Bt,Lt]=Qe.scales,[gt,st]=Fn.match,fn=I.axes[0].side%2==1,En=D.ori==0?G:He,qn=D.ori==1?G:He,en=fn?ie:Z,Rn=fn?Z:ie,Ai=fn?k:B,ui=fn?B:k;if(Bt!=null?B=gt($e,Bt)?a(wt,M[$e],En,0):-10:B=En*(Ai/en),Lt!=null?k=st(Ze,Lt)?a(Ht,M[Ze],qn,0):-10:k=qn*(ui/Rn),D.ori==1){let Vi=B;B=k,k=Vi}}ze&&(I==null||I.cursor.event.type==up)&&((B<=1||B>=G-1)&&(B=yo(B,G)),(k<=1||k>=He-1)&&(k=yo(k,He))),Ie?(Hr=B,ym=k,[Ro,Co]=pe.move(n,B,k)):(un=B,gn=k)}let Kh={width:0,height:0,left:0,top:0};function Jh(){oc(Kh,!1)}let Am,Em,Rm,Cm;function Im(w,I,B,k,Z,ie,_e){ws=!0,Gn=Wn=Qn._x=Qn._y=!1,Zh(w,I,B,k,Z,ie,_e,!0,!1),w!=null&&(Pt(hp,gp,Pm,!1),Wa(wx,n,Ro,Co,G,He,null));let{left:Ie,top:ze,width:$e,height:Ze}=hn;Am=Ie,Em=ze,Rm=$e,Cm=Ze}function Pm(w,I,B,k,Z,ie,_e){ws=Qn._x=Qn._y=!1,Zh(w,I,B,k,Z,ie,_e,!1,!0);let{left:Ie,top:ze,width:$e,height:Ze}=hn,Qe=$e>0||Ze>0,wt=Am!=Ie||Em!=ze||Rm!=$e||Cm!=Ze;if(Qe&&wt&&oc(hn),Qn.setScale&&Qe&&wt){let Ht=Ie,Bt=$e,Lt=ze,gt=Ze;if(D.ori==1&&(Ht=ze,Bt=Ze,Lt=Ie,gt=$e),Gn&&Ss(R,yr(Ht,R),yr(Ht+Bt,R)),Wn)for(let st in M){let fn=M[st];st!=R&&fn.from==null&&fn.min!=sn&&Ss(st,yr(Lt+gt,st),yr(Lt,st))}Jh()}else pe.lock&&(pe._lock=!pe._lock,Ys(I,!0,w!=null));w!=null&&(Tn(hp,gp),Wa(hp,n,un,gn,G,He,null))}function M1(w,I,B,k,Z,ie,_e){if(pe._lock)return;pt(w);let Ie=ws;if(ws){let ze=!0,$e=!0,Ze=10,Qe,wt;D.ori==0?(Qe=Gn,wt=Wn):(Qe=Wn,wt=Gn),Qe&&wt&&(ze=un<=Ze||un>=G-Ze,$e=gn<=Ze||gn>=He-Ze),Qe&&ze&&(un=un<Ro?0:G),wt&&$e&&(gn=gn<Co?0:He),Ys(null,!0,!0),ws=!1}un=-10,gn=-10,de.fill(null),Ys(null,!0,!0),Ie&&(ws=Ie)}function Lm(w,I,B,k,Z,ie,_e){pe._lock||(pt(w),vs(),Jh(),w!=null&&Wa(Tx,n,un,gn,G,He,null))}function Nm(){T.forEach(YA),H(n.width,n.height,!0)}So(Eh,Pa,Nm);let Lo={};Lo.mousedown=Im,Lo.mousemove=Tm,Lo.mouseup=Pm,Lo.dblclick=Lm,Lo.setSeries=(w,I,B,k)=>{let Z=Fn.match[2];B=Z(n,I,B),B!=-1&&vr(B,k,!0,!1)},Ee&&(Pt(wx,m,Im),Pt(up,m,Tm),Pt(Sx,m,w=>{pt(w),Ga(!1)}),Pt(Mx,m,M1),Pt(Tx,m,Lm),Mp.add(n),n.syncRect=Ga);let ac=n.hooks=i.hooks||{};function Xn(w,I,B){Jt?at.push([w,I,B]):w in ac&&ac[w].forEach(k=>{k.call(null,n,I,B)})}(i.plugins||[]).forEach(w=>{for(let I in w.hooks)ac[I]=(ac[I]||[]).concat(w.hooks[I])});let Dm=(w,I,B)=>B,Fn=On({key:null,setSeries:!1,filters:{pub:Ux,sub:Ux},scales:[R,S[1]?S[1].scale:null],match:[Ox,Ox,Dm],values:[null,null]},pe.sync);Fn.match.length==2&&Fn.match.push(Dm),pe.sync=Fn;let Fm=Fn.key,jh=Nv(Fm);function Wa(w,I,B,k,Z,ie,_e){Fn.filters.pub(w,I,B,k,Z,ie,_e)&&jh.pub(w,I,B,k,Z,ie,_e)}jh.sub(n);function T1(w,I,B,k,Z,ie,_e){Fn.filters.sub(w,I,B,k,Z,ie,_e)&&Lo[w](null,I,B,k,Z,ie,_e)}n.pub=T1;function A1(){jh.unsub(n),Mp.delete(n),Dn.clear(),vp(Eh,Pa,Nm),c.remove(),Oe?.remove(),Xn("destroy")}n.destroy=A1;function Qh(){Xn("init",i,e),_r(e||i.data,!1),W[R]?er(R,W[R]):vs(),he=hn.show&&(hn.width>0||hn.height>0),ae=Re=!0,H(i.width,i.height)}return S.forEach(_s),T.forEach(ji),t?t instanceof HTMLElement?(t.appendChild(c),Qh()):t(n,Qh):Qh(),n}ni.assign=On;ni.fmtNum=Pp;ni.rangeNum=Rh;ni.rangeLog=Ph;ni.rangeAsinh=Cp;ni.orient=To;ni.pxRatio=Wt;ni.join=BT;ni.fmtDate=Np,ni.tzDate=ZT;ni.sync=Nv;{ni.addGap=PA,ni.clipGaps=Dh;let i=ni.paths={points:zv};i.linear=Vv,i.stepped=DA,i.bars=FA,i.spline=OA}function kp(i,e){return Array.from({length:201},(t,n)=>i+n/200*(e-i))}function Xv(){let i=Me("div",{className:"plot",role:"img"}),e=Me("div",{className:"patch"}),t=Me("dl",{className:"facts"}),n=Me("p",{className:"caption"}),r=Me("select",{"aria-label":"Measured spectra",title:"Measured spectra of the specimen: the page then asks the directions that they were measured at."});r.hidden=!0;let s=[],o=Me("div",{className:"spectrum"},r,i,Me("div",{className:"colour"},e,t),n),a=null,l="",c=()=>{let h=getComputedStyle(o),[f,d,m,b]=["--muted","--line","--accent","--text"].map(_=>h.getPropertyValue(_).trim()),g={stroke:f,grid:{stroke:d,width:1},ticks:{stroke:d,width:1},font:"11px system-ui, sans-serif"};return new ni({width:i.clientWidth||340,height:i.clientHeight||168,legend:{show:!1},cursor:{y:!1,points:{size:6}},scales:{x:{time:!1},y:{range:(_,S,T)=>[Math.min(0,S),T>0?T*1.08:1]}},axes:[{...g,size:34,values:(_,S)=>S.map(T=>`${T}`),label:"wavelength, nm",labelSize:16,labelFont:"11px system-ui, sans-serif"},{...g,size:52,values:(_,S)=>S.map(T=>Nn(T,2))}],series:[{},{stroke:m,width:1.5,fill:KA,points:{show:!1}},{width:0,points:{show:!0,size:6,width:1.5,stroke:b,fill:"transparent"}}]},[[],[],[]],i)};new ResizeObserver(()=>a?.setSize({width:i.clientWidth,height:i.clientHeight})).observe(i);let u={element:o,onChoose:()=>{},offer:h=>{s=h,r.hidden=h.length===0;let f=({angles_deg:[d,m,b,g]})=>`measured: light ${d}°, ${m}° · viewer ${b}°, ${g}°`;r.replaceChildren(Me("option",{value:""},"at the spot"),...h.map((d,m)=>Me("option",{value:String(m)},f(d))))},update:(h,f,d)=>{let m=document.documentElement.dataset.theme??"";a&&m!==l&&(a.destroy(),a=null),l=m,a??=c();let b=d?.spectrum;i.hidden=!b,b&&a.setData([b.nm,Array.from(b.values,g=>Number.isNaN(g)?null:g),b.measured]),d&&!d.chosen&&(r.value=""),n.textContent=$A(h,f,d),n.hidden=n.textContent==="",e.style.background=d?.xyz?yh(d.xyz):"transparent",t.replaceChildren(...ZA(d).flatMap(([g,_,S])=>[Me("dt",{title:S},g),Me("dd",{},_)])),i.setAttribute("aria-label",`Spectrum at the spot. ${t.textContent??""}`)}};return r.addEventListener("change",()=>u.onChoose(r.value===""?null:s[Number(r.value)])),u}function $A(i,e,t){return e.floats?t?e.loaded?.specimen.spectral?t.spectrum?"":"Reading the spectral tables …":"This specimen has no spectral tables; its colour comes from those of XYZ.":"Point at the surface to ask it for its spectrum.":"This browser cannot draw to 32-bit floats, so numbers are not to be had."}function ZA(i){let e=i?.xyz;if(!i||!e)return[["f","–","The BRDF in 1/sr."]];let t=Yi(e),{dominant:n}=i,r=n?`${n.complementary?"c ":""}${n.nm.toFixed(0)} nm${n.complementary?"":`, ${(100*n.purity).toFixed(0)} %`}`:"–";return[["X Y Z",e.map(s=>Nn(s,3)).join("  "),"The BRDF as CIE XYZ in 1/sr, under the light of the picture."],["x y",t?t.map(s=>s.toFixed(3)).join("  "):"–","Chromaticity, CIE 1931."],["dominant",r,'The pure wavelength of the same hue, and the excitation purity. "c" is the complementary wavelength of a purple.']]}function KA(i){let{left:e,width:t}=i.bbox,n=i.ctx.createLinearGradient(e,0,e+t,0),[r,s]=[i.scales.x.min??380,i.scales.x.max??780];for(let o=0;o<=40;o++)n.addColorStop(o/40,Zl(r+o/40*(s-r)).replace("rgb","rgba").replace(")",", 0.75)"));return n}function qv(i){let{change:e,current:t}=i,n=fx(t,e),r=ux(),[s,o,a]=[Xv(),gx(e),xx()],[l,c]=[cx(),ax()],u=[r,s,o,a,l,c],h=[],f=V=>(h.push(V),V.element),d=Me("div",{className:"specimens",role:"radiogroup","aria-label":"Specimen"}),m=Me("p",{className:"status",role:"status"}),b=Me("p",{className:"badge",hidden:!0}),g=Me("progress",{max:1,value:0,"aria-label":"Reading the atlas"}),_=Me("p",{className:"caption"});n.overlay.append(b,m);let S=JA(n),T=matchMedia("(min-width: 760px)").matches,M=Me("aside",{className:"controls","aria-label":"Controls"},vo("Specimen",!0,d,_),vo("Shape",!0,f(QA(e)),...eE(t,e).map(f)),vo("Light",T,f(px(t,e)),...tE(t,e).map(f),nE(t,e)),vo("Surface",!1,...iE(t,e).map(f)),vo("Picture",T,...rE(t,e,i).map(f)),vo("Trust",!1,...sE(t,e,i).map(f))),P=(V,z)=>Me("section",{className:"card"},Me("h2",{},V),z.element),R=Me("aside",{className:"views","aria-label":"Linked views"},P("Spectrum at the spot",s),P("All viewing directions",r),P("Plane of incidence",o),P("Relief and its frequencies",a),P("Chromaticity",l),P("The specimen",c)),y=Me("header",{},Me("div",{className:"brand"},Jn.mark(),Me("h1",{},"Diffraction atlas"),Me("span",{className:"atlas-name"})),Me("nav",{"aria-label":"Picture"},Bh(Jn.link,"Copy link","Copies a link that restores this view.",i.copyLink),Bh(Jn.picture,"PNG","Saves the picture as PNG.",i.savePng),Bh(Jn.film,"WebM","Records the motion for five seconds as WebM.",i.record),Bh(Jn.theme,"Theme","Light or dark page.",i.theme)),g);return{element:Me("div",{className:"page"},y,M,Me("main",{className:"stage"},n.element,Me("div",{className:"under"},S,jA(e,f))),R),stage:n,map:r,spectrum:s,views:u,controls:h,specimens:d,status:m,badge:b,loading:g,facts:_}}var Bh=(i,e,t,n)=>Me("button",{type:"button",title:t,onclick:n,className:"icon"},i(),Me("span",{className:"word"},e));function JA(i){let e=Ra({label:"Dragging moves",title:"What a drag on the picture moves, and the arrow keys. With Shift it is the other of light and view.",choices:[{value:"light",label:"light",icon:Jn.light},{value:"view",label:"view",icon:Jn.orbit},{value:"spot",label:"spot",icon:Jn.spot}],get:()=>i.grip,set:t=>(i.grip=t,{})},()=>{});return e.update({}),e.element}function jA(i,e){return e(Ra({label:"Motion",title:"What moves by itself.",choices:[{value:"none",label:"still",icon:Jn.pause},{value:"light",label:"light",icon:Jn.sweep},{value:"turntable",label:"object",icon:Jn.turn}],get:t=>t.motion,set:t=>({motion:t})},i))}function QA(i){return Ra({label:"Shape",title:"What wears the structure.",choices:[{value:"ball",label:"ball",icon:Jn.ball,title:"A ball: every orientation at once."},{value:"snake",label:"snake",icon:Jn.snake,title:"A snake with scales."},{value:"patch",label:"flat",icon:Jn.flat,title:"A flat sample, tilted."},{value:"screen",label:"screen",icon:Jn.screen,title:"A beam through a hole in a screen, thrown back on it."},{value:"map",label:"map",icon:Jn.map,title:"The BRDF itself over all viewing directions."},{value:"model",label:"own",icon:Jn.own,title:"Your own mesh: drop a .glb or .obj file with texture coordinates on the page."}],get:e=>e.shape,set:e=>({shape:e,view:{azimuth_deg:0,elevation_deg:0,zoom:1},spin_deg:0})},i)}function eE(i,e){let t=r=>r.shape==="screen",n=r=>r.shape==="patch";return[_i({label:"Incidence",unit:"°",title:"Turns the sample about the vertical.",min:0,max:40,step:1,get:r=>r.screen.incidence_deg,set:(r,s)=>({screen:{...s.screen,incidence_deg:r}}),when:t},i,e),_i({label:"Distance",unit:" mm",title:"From the screen to the sample.",min:30,max:300,step:5,get:r=>r.screen.distance_mm,set:(r,s)=>({screen:{...s.screen,distance_mm:r}}),when:t},i,e),_i({label:"Beam",unit:" mm",title:"Diameter of the beam and of the hole.",min:.5,max:10,step:.5,get:r=>r.screen.beam_mm,set:(r,s)=>({screen:{...s.screen,beam_mm:r}}),when:t},i,e),_i({label:"Tilt",unit:"°",title:"Leans the upper edge of the sample away.",min:0,max:80,step:1,get:r=>r.patch.tilt_deg,set:(r,s)=>({patch:{...s.patch,tilt_deg:r}}),when:n},i,e)]}function tE(i,e){let t=s=>s.lights[s.active],n=s=>{let[o,a,l]=t(s).direction;return{theta:Math.atan2(Math.hypot(o,a),l)*180/Math.PI,phi:Math.atan2(a,o)*180/Math.PI}},r=(s,o)=>{let[a,l]=[s*Math.PI/180,o*Math.PI/180];return[Math.sin(a)*Math.cos(l),Math.sin(a)*Math.sin(l),Math.cos(a)]};return[_i({label:"Angle",unit:"°",title:"Angle of the light from the line of sight at rest.",min:0,max:175,step:.5,get:s=>n(s).theta,set:(s,o)=>ps(o,{direction:r(Math.max(s,.01),n(o).phi)}),text:s=>`${s.toFixed(1)}°`,when:s=>s.shape!=="screen"},i,e),_i({label:"Azimuth",unit:"°",title:"Where the light stands around the line of sight; 0 is to the right.",min:-180,max:180,step:1,get:s=>n(s).phi,set:(s,o)=>ps(o,{direction:r(n(o).theta,s)}),text:s=>`${s.toFixed(0)}°`,when:s=>s.shape!=="screen"},i,e),_i({label:"Size",unit:"°",title:"Full angle of the light’s disc: 0 is a point, 0.53° the sun.",min:0,max:30,step:.01,get:s=>t(s).diameter_deg,set:(s,o)=>ps(o,{diameter_deg:s})},i,e),_i({label:"Strength",title:"Irradiance on a surface that faces the light; 0 switches it off.",min:0,max:4,step:.05,get:s=>t(s).irradiance,set:(s,o)=>ps(o,{irradiance:s})},i,e),ip({label:"Spectrum",title:"The light’s spectrum. All but the first need spectral tables.",choices:[{value:"tables",label:"as in the tables"},{value:"D65",label:"D65, daylight"},{value:"A",label:"A, incandescent"},{value:"F11",label:"F11, fluorescent"},{value:"LED",label:"white LED"},{value:"sun",label:"sun at a height"},{value:"laser",label:"laser line"},{value:"E",label:"E, equal power"}],get:s=>s.illuminant,set:s=>({illuminant:s})},e),ip({label:"Surroundings",title:"Light from all around, besides the lights. Drop an .exr or .hdr file on the page to use your own.",choices:[{value:"none",label:"dark"},{value:"overcast",label:"overcast sky"},{value:"window",label:"room with windows"},{value:"own",label:"own image"}],get:s=>s.environment,set:s=>({environment:s}),when:s=>s.shape!=="map"&&s.shape!=="screen"},e),_i({label:"Wavelength",unit:" nm",title:"Wavelength of the laser.",min:400,max:700,step:1,get:s=>s.laser_nm,set:s=>({laser_nm:s}),when:s=>s.illuminant==="laser"},i,e),_i({label:"Sun’s height",unit:"°",title:"Height of the sun above the horizon: low suns are red.",min:1,max:90,step:1,get:s=>s.sun_deg,set:s=>({sun_deg:s}),when:s=>s.illuminant==="sun"},i,e)]}function nE(i,e){let t=()=>{let r=i();if(r.lights.length>=4)return;let[s,o,a]=r.lights[r.active].direction,l={...r.lights[r.active],direction:[-s-.2,o+.1,a]};e({lights:[...r.lights,l],active:r.lights.length})},n=()=>{let r=i();r.lights.length>1&&e({lights:r.lights.filter((s,o)=>o!==r.active),active:0})};return Me("div",{className:"buttons"},bh("Add a light","Up to four lights at once.",t),bh("Remove it","Removes the light that is chosen on the disc.",n))}function iE(i,e){return[_i({label:"Orientation",unit:"°",title:"Turns the structure on the surface.",min:-90,max:90,step:1,get:t=>t.turn_deg,set:t=>({turn_deg:t})},i,e),_i({label:"Scale",title:"Shrinks the structure in all directions, heights too, and the coherence with it: what it does to a wavelength, the scanned one does to a longer one. Needs spectral tables.",min:.4,max:1,step:.01,get:t=>t.scale,set:t=>({scale:t}),text:t=>`× ${t.toFixed(2)}`},i,e),rp({label:"pigment below the structure",title:"Where the specimen has a pigment.",get:t=>t.pigment,set:t=>({pigment:t})},e)]}function rE(i,e,t){let n=bh("Auto","Meters the exposure anew: the brightest half percent comes to white.",()=>{e({exposure:null}),t.remeter()}),r=_i({label:"Exposure",title:"In stops. 0 shows a white wall facing the light as white.",min:-8,max:14,step:.1,get:s=>s.exposure??Math.log2(t.exposure()/Math.PI),set:s=>({exposure:s}),text:(s,o)=>`${s>=0?"+":"−"}${Math.abs(s).toFixed(1)}${o.exposure===null?" auto":""}`},i,e);return r.element.append(n),[r,Ra({label:"Bright and saturated colours",title:"What becomes of colours that no display shows.",choices:[{value:"atlas",label:"keep the hue"},{value:"clip",label:"cut channels"}],get:s=>s.tone,set:s=>({tone:s})},e)]}function sE(i,e,t){let n=t.tables;return[_i({label:"Tables used",title:"How many tables of the expansion are summed.",min:1,max:n,step:1,get:r=>r.tables??n(),set:r=>({tables:r>=n()?null:r}),text:(r,s)=>s.tables===null?"all":`${r}`},i,e),rp({label:"show the difference",title:"The difference of luminance from all tables, ten times enlarged, in place of the picture.",get:r=>r.difference,set:r=>({difference:r}),when:r=>r.tables!==null},e),Ra({label:"Between texels",title:"Bilinear look-ups are the hardware’s; cubic ones are closest to the scan.",choices:[{value:"bilinear",label:"bilinear"},{value:"cubic",label:"cubic"}],get:r=>r.interpolation,set:r=>({interpolation:r})},e)]}async function Yv(i,e){let t=Aa();return Promise.all(i.index.specimens.map(async({name:n,species:r},s)=>{let o=i.state.specimen?n===i.state.specimen:s===0,a=Me("input",{type:"radio",name:t,value:n,checked:o,onchange:()=>e(n)}),l=`${n}/preview.png`,c=i.index.files.some(h=>h.path===l),u=Me("img",{alt:"",loading:"lazy",src:c?await i.files.url(l):""});return c||(u.hidden=!0),Me("label",{className:"specimen",title:r??n},a,u,Me("span",{},n.replaceAll("_"," ")))}))}var $v="diffraction-atlas-theme",oE=()=>{try{return localStorage.getItem($v)}catch{return null}},aE=()=>matchMedia("(prefers-color-scheme: light)").matches?"light":"dark";function Zv(){let i=()=>document.documentElement.dataset.theme=oE()??aE();i(),matchMedia("(prefers-color-scheme: light)").addEventListener("change",i)}function Kv(){let i=document.documentElement.dataset.theme==="dark"?"light":"dark";document.documentElement.dataset.theme=i;try{localStorage.setItem($v,i)}catch{}}function Qv(i,e=!1){let t=i[0].index!==null,n=new Set(Object.keys(i[0].attributes)),r=new Set(Object.keys(i[0].morphAttributes)),s={},o={},a=i[0].morphTargetsRelative,l=new _n;l.morphTargetsRelative=a;let c=0;for(let u=0;u<i.length;++u){let h=i[u],f=0,d=0;if(t!==(h.index!==null))return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+u+". All geometries must have compatible attributes; make sure index attribute exists among all geometries, or in none of them."),null;for(let m in h.attributes){if(!n.has(m))return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+u+'. All geometries must have compatible attributes; make sure "'+m+'" attribute exists among all geometries, or in none of them.'),null;s[m]===void 0&&(s[m]=[]),s[m].push(h.attributes[m]),f++}if(f!==n.size)return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+u+". Make sure all geometries have the same number of attributes."),null;if(a!==h.morphTargetsRelative)return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+u+". .morphTargetsRelative must be consistent throughout all geometries."),null;for(let m in h.morphAttributes){if(!r.has(m))return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+u+".  .morphAttributes must be consistent throughout all geometries."),null;if(h.morphAttributes[m].length!==i[0].morphAttributes[m].length)return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+u+'. All geometries must have the same number of morph targets for the "'+m+'" morph attribute.'),null;o[m]===void 0&&(o[m]=[]),o[m].push(h.morphAttributes[m]),d++}if(d!==r.size)return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+u+". Make sure all geometries have the same number of morph attributes."),null;if(e){let m;if(t)m=h.index.count;else if(h.attributes.position!==void 0)m=h.attributes.position.count;else return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+u+". The geometry must have either an index or a position attribute"),null;l.addGroup(c,m,u),c+=m}}if(t){let u=0,h=[];for(let f=0;f<i.length;++f){let d=i[f].index;for(let m=0;m<d.count;++m)h.push(d.getX(m)+u);u+=i[f].attributes.position.count}l.setIndex(h)}for(let u in s){let h=Jv(s[u]);if(!h)return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed while trying to merge the "+u+" attribute."),null;l.setAttribute(u,h)}for(let u in o){let h=o[u][0].length;if(h!==0){l.morphAttributes=l.morphAttributes||{},l.morphAttributes[u]=[];for(let f=0;f<h;++f){let d=[];for(let b=0;b<o[u].length;++b)d.push(o[u][b][f]);let m=Jv(d);if(!m)return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed while trying to merge the "+u+" morphAttribute."),null;l.morphAttributes[u].push(m)}}}return l}function Jv(i){let e,t,n,r=-1,s=0;for(let c=0;c<i.length;++c){let u=i[c];if(e===void 0&&(e=u.array.constructor),e!==u.array.constructor)return console.error("THREE.BufferGeometryUtils: .mergeAttributes() failed. BufferAttribute.array must be of consistent array types across matching attributes."),null;if(t===void 0&&(t=u.itemSize),t!==u.itemSize)return console.error("THREE.BufferGeometryUtils: .mergeAttributes() failed. BufferAttribute.itemSize must be consistent across matching attributes."),null;if(n===void 0&&(n=u.normalized),n!==u.normalized)return console.error("THREE.BufferGeometryUtils: .mergeAttributes() failed. BufferAttribute.normalized must be consistent across matching attributes."),null;if(r===-1&&(r=u.gpuType),r!==u.gpuType)return console.error("THREE.BufferGeometryUtils: .mergeAttributes() failed. BufferAttribute.gpuType must be consistent across matching attributes."),null;s+=u.count*t}let o=new e(s),a=new an(o,t,n),l=0;for(let c=0;c<i.length;++c){let u=i[c];if(u.isInterleavedBufferAttribute){let h=l/t;for(let f=0,d=u.count;f<d;f++)for(let m=0;m<t;m++){let b=u.getComponent(f,m);a.setComponent(f+h,m,b)}}else o.set(u.array,l);l+=u.count*t}return r!==void 0&&(a.gpuType=r),a}function e1(i,e=1e-4){e=Math.max(e,Number.EPSILON);let t={},n=i.getIndex(),r=i.getAttribute("position"),s=n?n.count:r.count,o=0,a=Object.keys(i.attributes),l=[],c=new Map,u=[],h=["getX","getY","getZ","getW"],f=e*.5,d=Math.log10(1/e),m=Math.pow(10,d),b=f*m;for(let _=0;_<s;_++){let S=n?n.getX(_):_,T="";for(let M=0,P=a.length;M<P;M++){let R=a[M],y=i.getAttribute(R),A=y.itemSize;for(let V=0;V<A;V++)T+=`${Math.trunc(y[h[V]](S)*m+b)},`}T in t?u.push(t[T]):(l.push(S),t[T]=o,u.push(o),o++)}let g=i.clone();for(let _ in i.attributes)g.setAttribute(_,jv(i.attributes[_],l,c));for(let _ in i.morphAttributes)g.morphAttributes[_]=i.morphAttributes[_].map(S=>jv(S,l,c));return g.setIndex(u),g}function Vp(i,e){if(e===rd)return console.warn("THREE.BufferGeometryUtils.toTrianglesDrawMode(): Geometry already defined as triangles."),i;if(e===ma||e===Ll){let t=i.getIndex();if(t===null){let s=[],o=i.getAttribute("position");if(o!==void 0){for(let a=0;a<o.count;a++)s.push(a);i.setIndex(s),t=i.getIndex()}else return console.error("THREE.BufferGeometryUtils.toTrianglesDrawMode(): Undefined position attribute. Processing not possible."),i}let n=t.count-2,r=[];if(e===ma)for(let s=1;s<=n;s++)r.push(t.getX(0)),r.push(t.getX(s)),r.push(t.getX(s+1));else for(let s=0;s<n;s++)s%2===0?(r.push(t.getX(s)),r.push(t.getX(s+1)),r.push(t.getX(s+2))):(r.push(t.getX(s+2)),r.push(t.getX(s+1)),r.push(t.getX(s)));return r.length/3!==n&&console.error("THREE.BufferGeometryUtils.toTrianglesDrawMode(): Unable to generate correct amount of triangles."),i.setIndex(r),i.clearGroups(),i}else return console.error("THREE.BufferGeometryUtils.toTrianglesDrawMode(): Unknown draw mode:",e),i}function jv(i,e,t=new Map){let n=i.isInterleavedBufferAttribute,r=n?i.data:i,s=n?r.stride:i.itemSize,o=n?t.get(r):void 0;if(o===void 0){let l=new r.array.constructor(e.length*s);for(let c=0;c<e.length;c++)for(let u=0;u<s;u++)l[c*s+u]=r.array[e[c]*s+u];o=n?new r.constructor(l,s,r.meshPerAttribute):new i.constructor(l,i.itemSize,i.normalized,i.meshPerAttribute),o.setUsage(r.usage),n&&t.set(r,o)}let a=n?new i.constructor(o,i.itemSize,i.offset,i.normalized):o;return a.name=i.name,n||(a.gpuType=i.gpuType),a}function t1(i){let e=new Map,t=new Map,n=i.clone();return n1(i,n,function(r,s){e.set(s,r),t.set(r,s)}),n.traverse(function(r){if(!r.isSkinnedMesh)return;let s=r,o=e.get(r),a=o.skeleton.bones;s.skeleton=o.skeleton.clone(),s.bindMatrix.copy(o.bindMatrix),s.skeleton.bones=a.map(function(l){return t.get(l)}),s.bind(s.skeleton,s.bindMatrix)}),n}function n1(i,e,t){t(i,e);for(let n=0;n<i.children.length;n++)n1(i.children[n],e.children[n],t)}var zh=class extends Di{constructor(e){super(e),this.dracoLoader=null,this.ktx2Loader=null,this.meshoptDecoder=null,this.pluginCallbacks=[],this.register(function(t){return new $p(t)}),this.register(function(t){return new Zp(t)}),this.register(function(t){return new Kp(t)}),this.register(function(t){return new sm(t)}),this.register(function(t){return new om(t)}),this.register(function(t){return new am(t)}),this.register(function(t){return new jp(t)}),this.register(function(t){return new Qp(t)}),this.register(function(t){return new em(t)}),this.register(function(t){return new tm(t)}),this.register(function(t){return new Yp(t)}),this.register(function(t){return new nm(t)}),this.register(function(t){return new Jp(t)}),this.register(function(t){return new rm(t)}),this.register(function(t){return new im(t)}),this.register(function(t){return new Xp(t)}),this.register(function(t){return new kh(t,Ct.EXT_MESHOPT_COMPRESSION)}),this.register(function(t){return new kh(t,Ct.KHR_MESHOPT_COMPRESSION)}),this.register(function(t){return new lm(t)})}load(e,t,n,r){let s=this,o;if(this.resourcePath!=="")o=this.resourcePath;else if(this.path!==""){let c=os.extractUrlBase(e);o=os.resolveURL(c,this.path)}else o=os.extractUrlBase(e);this.manager.itemStart(e);let a=function(c){r?r(c):console.error(c),s.manager.itemError(e),s.manager.itemEnd(e)},l=new ss(this.manager);l.setPriority(this.priority),l.setCache(this.cache),l.setPath(this.path),l.setResponseType("arraybuffer"),l.setRequestHeader(this.requestHeader),l.setWithCredentials(this.withCredentials),l.load(e,function(c){try{s.parse(c,o,function(u){t(u),s.manager.itemEnd(e)},a)}catch(u){a(u)}},n,a)}setDRACOLoader(e){return this.dracoLoader=e,this}setKTX2Loader(e){return this.ktx2Loader=e,this}setMeshoptDecoder(e){return this.meshoptDecoder=e,this}register(e){return this.pluginCallbacks.indexOf(e)===-1&&this.pluginCallbacks.push(e),this}unregister(e){return this.pluginCallbacks.indexOf(e)!==-1&&this.pluginCallbacks.splice(this.pluginCallbacks.indexOf(e),1),this}parse(e,t,n,r){let s,o={},a={},l=new TextDecoder;if(typeof e=="string")s=JSON.parse(e);else if(e instanceof ArrayBuffer)if(l.decode(new Uint8Array(e,0,4))===a1){try{o[Ct.KHR_BINARY_GLTF]=new cm(e)}catch(h){r&&r(h);return}s=JSON.parse(o[Ct.KHR_BINARY_GLTF].content)}else s=JSON.parse(l.decode(e));else s=e;if(s.asset===void 0||s.asset.version[0]<2){r&&r(new Error("THREE.GLTFLoader: Unsupported asset. glTF versions >=2.0 are supported."));return}let c=new gm(s,{path:t||this.resourcePath||"",crossOrigin:this.crossOrigin,priority:this.priority,cache:this.cache,withCredentials:this.withCredentials,requestHeader:this.requestHeader,manager:this.manager,ktx2Loader:this.ktx2Loader,meshoptDecoder:this.meshoptDecoder});c.fileLoader.setRequestHeader(this.requestHeader);for(let u=0;u<this.pluginCallbacks.length;u++){let h=this.pluginCallbacks[u](c);h.name||console.error("THREE.GLTFLoader: Invalid plugin found: missing name"),a[h.name]=h,o[h.name]=!0}if(s.extensionsUsed)for(let u=0;u<s.extensionsUsed.length;++u){let h=s.extensionsUsed[u],f=s.extensionsRequired||[];switch(h){case Ct.KHR_MATERIALS_UNLIT:o[h]=new qp;break;case Ct.KHR_DRACO_MESH_COMPRESSION:o[h]=new um(s,this.dracoLoader);break;case Ct.KHR_TEXTURE_TRANSFORM:o[h]=new hm;break;case Ct.KHR_MESH_QUANTIZATION:o[h]=new fm;break;default:f.indexOf(h)>=0&&a[h]===void 0&&console.warn('THREE.GLTFLoader: Unknown extension "'+h+'".')}}c.setExtensions(o),c.setPlugins(a),c.parse(n,r)}parseAsync(e,t){let n=this;return new Promise(function(r,s){n.parse(e,t,r,s)})}};function lE(){let i={};return{get:function(e){return i[e]},add:function(e,t){i[e]=t},remove:function(e){delete i[e]},removeAll:function(){i={}}}}function Mn(i,e,t){let n=i.json.materials[e];return n.extensions&&n.extensions[t]?n.extensions[t]:null}var Ct={KHR_BINARY_GLTF:"KHR_binary_glTF",KHR_DRACO_MESH_COMPRESSION:"KHR_draco_mesh_compression",KHR_LIGHTS_PUNCTUAL:"KHR_lights_punctual",KHR_MATERIALS_CLEARCOAT:"KHR_materials_clearcoat",KHR_MATERIALS_DIFFUSE_ROUGHNESS:"KHR_materials_diffuse_roughness",KHR_MATERIALS_DISPERSION:"KHR_materials_dispersion",KHR_MATERIALS_IOR:"KHR_materials_ior",KHR_MATERIALS_SHEEN:"KHR_materials_sheen",KHR_MATERIALS_SPECULAR:"KHR_materials_specular",KHR_MATERIALS_TRANSMISSION:"KHR_materials_transmission",KHR_MATERIALS_IRIDESCENCE:"KHR_materials_iridescence",KHR_MATERIALS_ANISOTROPY:"KHR_materials_anisotropy",KHR_MATERIALS_UNLIT:"KHR_materials_unlit",KHR_MATERIALS_VOLUME:"KHR_materials_volume",KHR_TEXTURE_BASISU:"KHR_texture_basisu",KHR_TEXTURE_TRANSFORM:"KHR_texture_transform",KHR_MESH_QUANTIZATION:"KHR_mesh_quantization",KHR_MATERIALS_EMISSIVE_STRENGTH:"KHR_materials_emissive_strength",EXT_MATERIALS_BUMP:"EXT_materials_bump",EXT_TEXTURE_WEBP:"EXT_texture_webp",EXT_TEXTURE_AVIF:"EXT_texture_avif",EXT_MESHOPT_COMPRESSION:"EXT_meshopt_compression",KHR_MESHOPT_COMPRESSION:"KHR_meshopt_compression",EXT_MESH_GPU_INSTANCING:"EXT_mesh_gpu_instancing"},Xp=class{constructor(e){this.parser=e,this.name=Ct.KHR_LIGHTS_PUNCTUAL,this.cache={refs:{},uses:{}}}_markDefs(){let e=this.parser,t=this.parser.json.nodes||[];for(let n=0,r=t.length;n<r;n++){let s=t[n];s.extensions&&s.extensions[this.name]&&s.extensions[this.name].light!==void 0&&e._addNodeRef(this.cache,s.extensions[this.name].light)}}_loadLight(e){let t=this.parser,n="light:"+e,r=t.cache.get(n);if(r)return r;let s=t.json,l=((s.extensions&&s.extensions[this.name]||{}).lights||[])[e],c,u=new ht(16777215);l.color!==void 0&&u.setRGB(l.color[0],l.color[1],l.color[2],dn);let h=l.range!==void 0?l.range:0;switch(l.type){case"directional":c=new Sl(u),c.target.position.set(0,0,-1),c.add(c.target);break;case"point":c=new wl(u),c.distance=h;break;case"spot":c=new bl(u),c.distance=h,l.spot=l.spot||{},l.spot.innerConeAngle=l.spot.innerConeAngle!==void 0?l.spot.innerConeAngle:0,l.spot.outerConeAngle=l.spot.outerConeAngle!==void 0?l.spot.outerConeAngle:Math.PI/4,c.angle=l.spot.outerConeAngle,c.penumbra=1-l.spot.innerConeAngle/l.spot.outerConeAngle,c.target.position.set(0,0,-1),c.add(c.target);break;default:throw new Error("THREE.GLTFLoader: Unexpected light type: "+l.type)}return c.position.set(0,0,0),Vr(c,l),l.intensity!==void 0&&(c.intensity=l.intensity),c.name=t.createUniqueName(l.name||"light_"+e),r=Promise.resolve(c),t.cache.add(n,r),r}getDependency(e,t){if(e==="light")return this._loadLight(t)}createNodeAttachment(e){let t=this,n=this.parser,s=n.json.nodes[e],a=(s.extensions&&s.extensions[this.name]||{}).light;return a===void 0?null:this._loadLight(a).then(function(l){return n._getNodeRef(t.cache,a,l)})}},qp=class{constructor(){this.name=Ct.KHR_MATERIALS_UNLIT}getMaterialType(){return Er}extendParams(e,t,n){let r=[];e.color=new ht(1,1,1),e.opacity=1;let s=t.pbrMetallicRoughness;if(s){if(Array.isArray(s.baseColorFactor)){let o=s.baseColorFactor;e.color.setRGB(o[0],o[1],o[2],dn),e.opacity=o[3]}s.baseColorTexture!==void 0&&r.push(n.assignTexture(e,"map",s.baseColorTexture,Ln))}return Promise.all(r)}},Yp=class{constructor(e){this.parser=e,this.name=Ct.KHR_MATERIALS_EMISSIVE_STRENGTH}extendMaterialParams(e,t){let n=Mn(this.parser,e,this.name);return n===null||n.emissiveStrength!==void 0&&(t.emissiveIntensity=n.emissiveStrength),Promise.resolve()}},$p=class{constructor(e){this.parser=e,this.name=Ct.KHR_MATERIALS_CLEARCOAT}getMaterialType(e){return Mn(this.parser,e,this.name)!==null?pi:null}extendMaterialParams(e,t){let n=Mn(this.parser,e,this.name);if(n===null)return Promise.resolve();let r=[];if(n.clearcoatFactor!==void 0&&(t.clearcoat=n.clearcoatFactor),n.clearcoatTexture!==void 0&&r.push(this.parser.assignTexture(t,"clearcoatMap",n.clearcoatTexture)),n.clearcoatRoughnessFactor!==void 0&&(t.clearcoatRoughness=n.clearcoatRoughnessFactor),n.clearcoatRoughnessTexture!==void 0&&r.push(this.parser.assignTexture(t,"clearcoatRoughnessMap",n.clearcoatRoughnessTexture)),n.clearcoatNormalTexture!==void 0&&(r.push(this.parser.assignTexture(t,"clearcoatNormalMap",n.clearcoatNormalTexture)),n.clearcoatNormalTexture.scale!==void 0)){let s=n.clearcoatNormalTexture.scale;t.clearcoatNormalScale=new xt(s,s)}return Promise.all(r)}},Zp=class{constructor(e){this.parser=e,this.name=Ct.KHR_MATERIALS_DIFFUSE_ROUGHNESS}getMaterialType(e){return Mn(this.parser,e,this.name)!==null?pi:null}extendMaterialParams(e,t){let n=Mn(this.parser,e,this.name);if(n===null)return Promise.resolve();let r=[];return t.diffuseRoughness=n.diffuseRoughnessFactor!==void 0?n.diffuseRoughnessFactor:0,n.diffuseRoughnessTexture!==void 0&&r.push(this.parser.assignTexture(t,"diffuseRoughnessMap",n.diffuseRoughnessTexture)),Promise.all(r)}},Kp=class{constructor(e){this.parser=e,this.name=Ct.KHR_MATERIALS_DISPERSION}getMaterialType(e){return Mn(this.parser,e,this.name)!==null?pi:null}extendMaterialParams(e,t){let n=Mn(this.parser,e,this.name);return n===null||(t.dispersion=n.dispersion!==void 0?n.dispersion:0),Promise.resolve()}},Jp=class{constructor(e){this.parser=e,this.name=Ct.KHR_MATERIALS_IRIDESCENCE}getMaterialType(e){return Mn(this.parser,e,this.name)!==null?pi:null}extendMaterialParams(e,t){let n=Mn(this.parser,e,this.name);if(n===null)return Promise.resolve();let r=[];return n.iridescenceFactor!==void 0&&(t.iridescence=n.iridescenceFactor),n.iridescenceTexture!==void 0&&r.push(this.parser.assignTexture(t,"iridescenceMap",n.iridescenceTexture)),n.iridescenceIor!==void 0&&(t.iridescenceIOR=n.iridescenceIor),n.iridescenceThicknessMinimum!==void 0&&(t.iridescenceThicknessMinimum=n.iridescenceThicknessMinimum),n.iridescenceThicknessMaximum!==void 0&&(t.iridescenceThicknessMaximum=n.iridescenceThicknessMaximum),n.iridescenceThicknessTexture!==void 0&&r.push(this.parser.assignTexture(t,"iridescenceThicknessMap",n.iridescenceThicknessTexture)),Promise.all(r)}},jp=class{constructor(e){this.parser=e,this.name=Ct.KHR_MATERIALS_SHEEN}getMaterialType(e){return Mn(this.parser,e,this.name)!==null?pi:null}extendMaterialParams(e,t){let n=Mn(this.parser,e,this.name);if(n===null)return Promise.resolve();let r=[];if(t.sheenColor=new ht(0,0,0),t.sheenRoughness=0,t.sheen=1,n.sheenColorFactor!==void 0){let s=n.sheenColorFactor;t.sheenColor.setRGB(s[0],s[1],s[2],dn)}return n.sheenRoughnessFactor!==void 0&&(t.sheenRoughness=n.sheenRoughnessFactor),n.sheenColorTexture!==void 0&&r.push(this.parser.assignTexture(t,"sheenColorMap",n.sheenColorTexture,Ln)),n.sheenRoughnessTexture!==void 0&&r.push(this.parser.assignTexture(t,"sheenRoughnessMap",n.sheenRoughnessTexture)),Promise.all(r)}},Qp=class{constructor(e){this.parser=e,this.name=Ct.KHR_MATERIALS_TRANSMISSION}getMaterialType(e){return Mn(this.parser,e,this.name)!==null?pi:null}extendMaterialParams(e,t){let n=Mn(this.parser,e,this.name);if(n===null)return Promise.resolve();let r=[];return n.transmissionFactor!==void 0&&(t.transmission=n.transmissionFactor),n.transmissionTexture!==void 0&&r.push(this.parser.assignTexture(t,"transmissionMap",n.transmissionTexture)),Promise.all(r)}},em=class{constructor(e){this.parser=e,this.name=Ct.KHR_MATERIALS_VOLUME}getMaterialType(e){return Mn(this.parser,e,this.name)!==null?pi:null}extendMaterialParams(e,t){let n=Mn(this.parser,e,this.name);if(n===null)return Promise.resolve();let r=[];t.thickness=n.thicknessFactor!==void 0?n.thicknessFactor:0,n.thicknessTexture!==void 0&&r.push(this.parser.assignTexture(t,"thicknessMap",n.thicknessTexture)),t.attenuationDistance=n.attenuationDistance||1/0;let s=n.attenuationColor||[1,1,1];return t.attenuationColor=new ht().setRGB(s[0],s[1],s[2],dn),Promise.all(r)}},tm=class{constructor(e){this.parser=e,this.name=Ct.KHR_MATERIALS_IOR}getMaterialType(e){return Mn(this.parser,e,this.name)!==null?pi:null}extendMaterialParams(e,t){let n=Mn(this.parser,e,this.name);return n===null||(t.ior=n.ior!==void 0?n.ior:1.5,t.ior===0&&(t.ior=1e3)),Promise.resolve()}},nm=class{constructor(e){this.parser=e,this.name=Ct.KHR_MATERIALS_SPECULAR}getMaterialType(e){return Mn(this.parser,e,this.name)!==null?pi:null}extendMaterialParams(e,t){let n=Mn(this.parser,e,this.name);if(n===null)return Promise.resolve();let r=[];t.specularIntensity=n.specularFactor!==void 0?n.specularFactor:1,n.specularTexture!==void 0&&r.push(this.parser.assignTexture(t,"specularIntensityMap",n.specularTexture));let s=n.specularColorFactor||[1,1,1];return t.specularColor=new ht().setRGB(s[0],s[1],s[2],dn),n.specularColorTexture!==void 0&&r.push(this.parser.assignTexture(t,"specularColorMap",n.specularColorTexture,Ln)),Promise.all(r)}},im=class{constructor(e){this.parser=e,this.name=Ct.EXT_MATERIALS_BUMP}getMaterialType(e){return Mn(this.parser,e,this.name)!==null?pi:null}extendMaterialParams(e,t){let n=Mn(this.parser,e,this.name);if(n===null)return Promise.resolve();let r=[];return t.bumpScale=n.bumpFactor!==void 0?n.bumpFactor:1,n.bumpTexture!==void 0&&r.push(this.parser.assignTexture(t,"bumpMap",n.bumpTexture)),Promise.all(r)}},rm=class{constructor(e){this.parser=e,this.name=Ct.KHR_MATERIALS_ANISOTROPY}getMaterialType(e){return Mn(this.parser,e,this.name)!==null?pi:null}extendMaterialParams(e,t){let n=Mn(this.parser,e,this.name);if(n===null)return Promise.resolve();let r=[];return n.anisotropyStrength!==void 0&&(t.anisotropy=n.anisotropyStrength),n.anisotropyRotation!==void 0&&(t.anisotropyRotation=n.anisotropyRotation),n.anisotropyTexture!==void 0&&r.push(this.parser.assignTexture(t,"anisotropyMap",n.anisotropyTexture)),Promise.all(r)}},sm=class{constructor(e){this.parser=e,this.name=Ct.KHR_TEXTURE_BASISU}loadTexture(e){let t=this.parser,n=t.json,r=n.textures[e];if(!r.extensions||!r.extensions[this.name])return null;let s=r.extensions[this.name],o=t.options.ktx2Loader;if(!o){if(n.extensionsRequired&&n.extensionsRequired.indexOf(this.name)>=0)throw new Error("THREE.GLTFLoader: setKTX2Loader must be called before loading KTX2 textures");return null}return t.loadTextureImage(e,s.source,o)}},om=class{constructor(e){this.parser=e,this.name=Ct.EXT_TEXTURE_WEBP}loadTexture(e){let t=this.name,n=this.parser,r=n.json,s=r.textures[e];if(!s.extensions||!s.extensions[t])return null;let o=s.extensions[t],a=r.images[o.source],l=n.textureLoader;if(a.uri){let c=n.options.manager.getHandler(a.uri);c!==null&&(l=c)}return n.loadTextureImage(e,o.source,l)}},am=class{constructor(e){this.parser=e,this.name=Ct.EXT_TEXTURE_AVIF}loadTexture(e){let t=this.name,n=this.parser,r=n.json,s=r.textures[e];if(!s.extensions||!s.extensions[t])return null;let o=s.extensions[t],a=r.images[o.source],l=n.textureLoader;if(a.uri){let c=n.options.manager.getHandler(a.uri);c!==null&&(l=c)}return n.loadTextureImage(e,o.source,l)}},kh=class{constructor(e,t){this.name=t,this.parser=e}loadBufferView(e){let t=this.parser.json,n=t.bufferViews[e];if(n.extensions&&n.extensions[this.name]){let r=n.extensions[this.name],s=this.parser.getDependency("buffer",r.buffer),o=this.parser.options.meshoptDecoder;if(!o||!o.supported){if(t.extensionsRequired&&t.extensionsRequired.indexOf(this.name)>=0)throw new Error("THREE.GLTFLoader: setMeshoptDecoder must be called before loading compressed files");return null}return s.then(function(a){let l=r.byteOffset||0,c=r.byteLength||0,u=r.count,h=r.byteStride,f=new Uint8Array(a,l,c);return o.decodeGltfBufferAsync?o.decodeGltfBufferAsync(u,h,f,r.mode,r.filter).then(function(d){return d.buffer}):o.ready.then(function(){let d=new ArrayBuffer(u*h);return o.decodeGltfBuffer(new Uint8Array(d),u,h,f,r.mode,r.filter),d})})}else return null}},lm=class{constructor(e){this.name=Ct.EXT_MESH_GPU_INSTANCING,this.parser=e}createNodeMesh(e){let t=this.parser.json,n=t.nodes[e];if(!n.extensions||!n.extensions[this.name]||n.mesh===void 0)return null;let r=t.meshes[n.mesh];for(let c of r.primitives)if(c.mode!==Ki.TRIANGLES&&c.mode!==Ki.TRIANGLE_STRIP&&c.mode!==Ki.TRIANGLE_FAN&&c.mode!==void 0)return null;let o=n.extensions[this.name].attributes,a=[],l={};for(let c in o)a.push(this.parser.getDependency("accessor",o[c]).then(u=>(l[c]=u,l[c])));return a.length<1?null:(a.push(this.parser.createNodeMesh(e)),Promise.all(a).then(c=>{let u=c.pop(),h=u.isGroup?u.children:[u],f=c[0].count,d=[];for(let m of h){let b=new it,g=new J,_=new Li,S=new J(1,1,1),T=new hl(m.geometry,m.material,f);for(let P=0;P<f;P++)l.TRANSLATION&&g.fromBufferAttribute(l.TRANSLATION,P),l.ROTATION&&_.fromBufferAttribute(l.ROTATION,P),l.SCALE&&S.fromBufferAttribute(l.SCALE,P),T.setMatrixAt(P,b.compose(g,_,S));let M=null;for(let P in l)if(P==="_COLOR_0"){let R=l[P];T.instanceColor=new Qr(R.array,R.itemSize,R.normalized)}else if(P!=="TRANSLATION"&&P!=="ROTATION"&&P!=="SCALE"){if(M===null){let y=T.geometry;M=new _n,M.name=y.name;for(let A in y.attributes)M.setAttribute(A,y.attributes[A]);for(let A in y.morphAttributes)M.morphAttributes[A]=y.morphAttributes[A];y.index!==null&&M.setIndex(y.index),M.morphTargetsRelative=y.morphTargetsRelative;for(let A of y.groups)M.addGroup(A.start,A.count,A.materialIndex);y.boundingBox!==null&&(M.boundingBox=y.boundingBox.clone()),y.boundingSphere!==null&&(M.boundingSphere=y.boundingSphere.clone()),M.drawRange.start=y.drawRange.start,M.drawRange.count=y.drawRange.count,M.userData=Object.assign({},y.userData),T.geometry=M}let R=l[P];M.setAttribute(P,new Qr(R.array,R.itemSize,R.normalized))}wn.prototype.copy.call(T,m),this.parser.assignFinalMaterial(T),d.push(T)}return u.isGroup?(u.clear(),u.add(...d),u):d[0]}))}},a1="glTF",rc=12,i1={JSON:1313821514,BIN:5130562},cm=class{constructor(e){this.name=Ct.KHR_BINARY_GLTF,this.content=null,this.body=null;let t=new DataView(e,0,rc),n=new TextDecoder;if(this.header={magic:n.decode(new Uint8Array(e.slice(0,4))),version:t.getUint32(4,!0),length:t.getUint32(8,!0)},this.header.magic!==a1)throw new Error("THREE.GLTFLoader: Unsupported glTF-Binary header.");if(this.header.version<2)throw new Error("THREE.GLTFLoader: Legacy binary file detected.");let r=this.header.length-rc,s=new DataView(e,rc),o=0;for(;o<r;){let a=s.getUint32(o,!0);o+=4;let l=s.getUint32(o,!0);if(o+=4,l===i1.JSON){let c=new Uint8Array(e,rc+o,a);this.content=n.decode(c)}else if(l===i1.BIN){let c=rc+o;this.body=e.slice(c,c+a)}o+=a}if(this.content===null)throw new Error("THREE.GLTFLoader: JSON content not found.")}},um=class{constructor(e,t){if(!t)throw new Error("THREE.GLTFLoader: No DRACOLoader instance provided.");this.name=Ct.KHR_DRACO_MESH_COMPRESSION,this.json=e,this.dracoLoader=t,this.dracoLoader.preload()}decodePrimitive(e,t){let n=this.json,r=this.dracoLoader,s=e.extensions[this.name].bufferView,o=e.extensions[this.name].attributes,a={},l={},c={};for(let u in o){let h=pm[u]||u.toLowerCase();a[h]=o[u]}for(let u in e.attributes){let h=pm[u]||u.toLowerCase();if(o[u]!==void 0){let f=n.accessors[e.attributes[u]],d=za[f.componentType];c[h]=d.name,l[h]=f.normalized===!0}}return t.getDependency("bufferView",s).then(function(u){return new Promise(function(h,f){r.decodeDracoFile(u,function(d){for(let m in d.attributes){let b=d.attributes[m],g=l[m];g!==void 0&&(b.normalized=g)}h(d)},a,c,dn,f)})})}},hm=class{constructor(){this.name=Ct.KHR_TEXTURE_TRANSFORM}extendTexture(e,t){if((t.texCoord===void 0||t.texCoord===e.channel)&&t.offset===void 0&&t.rotation===void 0&&t.scale===void 0)return e;if(e=e.clone(),t.texCoord!==void 0&&(e.channel=t.texCoord),t.offset!==void 0&&e.offset.fromArray(t.offset),t.rotation!==void 0&&(e.rotation=t.rotation),t.scale!==void 0&&e.repeat.fromArray(t.scale),t.rotation!==void 0){let n=Math.cos(e.rotation),r=Math.sin(e.rotation);e.matrix.set(e.repeat.x*n,e.repeat.y*r,e.offset.x,-e.repeat.x*r,e.repeat.y*n,e.offset.y,0,0,1),e.matrixAutoUpdate=!1}return e.needsUpdate=!0,e}},fm=class{constructor(){this.name=Ct.KHR_MESH_QUANTIZATION}},Vh=class extends Ir{constructor(e,t,n,r){super(e,t,n,r)}copySampleValue_(e){let t=this.resultBuffer,n=this.sampleValues,r=this.valueSize,s=e*r*3+r;for(let o=0;o!==r;o++)t[o]=n[s+o];return t}interpolate_(e,t,n,r){let s=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=a*2,c=a*3,u=r-t,h=(n-t)/u,f=h*h,d=f*h,m=e*c,b=m-c,g=-2*d+3*f,_=d-f,S=1-g,T=_-f+h;for(let M=0;M!==a;M++){let P=o[b+M+a],R=o[b+M+l]*u,y=o[m+M+a],A=o[m+M]*u;s[M]=S*P+T*R+g*y+_*A}return s}},cE=new Li,dm=class extends Vh{interpolate_(e,t,n,r){let s=super.interpolate_(e,t,n,r);return cE.fromArray(s).normalize().toArray(s),s}},Ki={FLOAT:5126,FLOAT_MAT3:35675,FLOAT_MAT4:35676,FLOAT_VEC2:35664,FLOAT_VEC3:35665,FLOAT_VEC4:35666,LINEAR:9729,REPEAT:10497,SAMPLER_2D:35678,POINTS:0,LINES:1,LINE_LOOP:2,LINE_STRIP:3,TRIANGLES:4,TRIANGLE_STRIP:5,TRIANGLE_FAN:6,UNSIGNED_BYTE:5121,UNSIGNED_SHORT:5123},za={5120:Int8Array,5121:Uint8Array,5122:Int16Array,5123:Uint16Array,5125:Uint32Array,5126:Float32Array},r1={9728:Ut,9729:qt,9984:au,9985:da,9986:po,9987:Fi},s1={33071:si,33648:Ko,10497:Ns},Hp={SCALAR:1,VEC2:2,VEC3:3,VEC4:4,MAT2:4,MAT3:9,MAT4:16},pm={POSITION:"position",NORMAL:"normal",TANGENT:"tangent",TEXCOORD_0:"uv",TEXCOORD_1:"uv1",TEXCOORD_2:"uv2",TEXCOORD_3:"uv3",COLOR_0:"color",WEIGHTS_0:"skinWeight",JOINTS_0:"skinIndex"},Gs={scale:"scale",translation:"position",rotation:"quaternion",weights:"morphTargetInfluences"},uE={CUBICSPLINE:void 0,LINEAR:to,STEP:eo},Gp={OPAQUE:"OPAQUE",MASK:"MASK",BLEND:"BLEND"};function hE(i){return i.DefaultMaterial===void 0&&(i.DefaultMaterial=new oo({color:16777215,emissive:0,metalness:1,roughness:1,transparent:!1,depthTest:!0,side:Pr})),i.DefaultMaterial}function Ao(i,e,t){for(let n in t.extensions)i[n]===void 0&&(e.userData.gltfExtensions=e.userData.gltfExtensions||{},e.userData.gltfExtensions[n]=t.extensions[n])}function Vr(i,e){e.extras!==void 0&&(typeof e.extras=="object"?Object.assign(i.userData,e.extras):console.warn("THREE.GLTFLoader: Ignoring primitive type .extras, "+e.extras))}function fE(i,e,t){let n=!1,r=!1,s=!1;for(let c=0,u=e.length;c<u;c++){let h=e[c];if(h.POSITION!==void 0&&(n=!0),h.NORMAL!==void 0&&(r=!0),h.COLOR_0!==void 0&&(s=!0),n&&r&&s)break}if(!n&&!r&&!s)return Promise.resolve(i);let o=[],a=[],l=[];for(let c=0,u=e.length;c<u;c++){let h=e[c];if(n){let f=h.POSITION!==void 0?t.getDependency("accessor",h.POSITION):i.attributes.position;o.push(f)}if(r){let f=h.NORMAL!==void 0?t.getDependency("accessor",h.NORMAL):i.attributes.normal;a.push(f)}if(s){let f=h.COLOR_0!==void 0?t.getDependency("accessor",h.COLOR_0):i.attributes.color;l.push(f)}}return Promise.all([Promise.all(o),Promise.all(a),Promise.all(l)]).then(function(c){let u=c[0],h=c[1],f=c[2];return n&&(i.morphAttributes.position=u),r&&(i.morphAttributes.normal=h),s&&(i.morphAttributes.color=f),i.morphTargetsRelative=!0,i})}function dE(i,e){if(i.updateMorphTargets(),e.weights!==void 0)for(let t=0,n=e.weights.length;t<n;t++)i.morphTargetInfluences[t]=e.weights[t];if(e.extras&&Array.isArray(e.extras.targetNames)){let t=e.extras.targetNames;if(i.morphTargetInfluences.length===t.length){i.morphTargetDictionary={};for(let n=0,r=t.length;n<r;n++)i.morphTargetDictionary[t[n]]=n}else console.warn("THREE.GLTFLoader: Invalid extras.targetNames length. Ignoring names.")}}function pE(i){let e,t=i.extensions&&i.extensions[Ct.KHR_DRACO_MESH_COMPRESSION];if(t?e="draco:"+t.bufferView+":"+t.indices+":"+Wp(t.attributes):e=i.indices+":"+Wp(i.attributes)+":"+i.mode,i.targets!==void 0)for(let n=0,r=i.targets.length;n<r;n++)e+=":"+Wp(i.targets[n]);return e}function Wp(i){let e="",t=Object.keys(i).sort();for(let n=0,r=t.length;n<r;n++)e+=t[n]+":"+i[t[n]]+";";return e}function mm(i){switch(i){case Int8Array:return 1/127;case Uint8Array:return 1/255;case Int16Array:return 1/32767;case Uint16Array:return 1/65535;default:throw new Error("THREE.GLTFLoader: Unsupported normalized accessor component type.")}}function mE(i){return i.search(/\.jpe?g($|\?)/i)>0||i.search(/^data\:image\/jpeg/)===0?"image/jpeg":i.search(/\.webp($|\?)/i)>0||i.search(/^data\:image\/webp/)===0?"image/webp":i.search(/\.ktx2($|\?)/i)>0||i.search(/^data\:image\/ktx2/)===0?"image/ktx2":"image/png"}var gE=new it,gm=class{constructor(e={},t={}){this.json=e,this.extensions={},this.plugins={},this.options=t,this.cache=new lE,this.associations=new Map,this.primitiveCache={},this.nodeCache={},this.meshCache={refs:{},uses:{}},this.cameraCache={refs:{},uses:{}},this.lightCache={refs:{},uses:{}},this.sourceCache={},this.textureCache={},this.nodeNamesUsed={};let n=!1,r=-1,s=!1,o=-1;if(typeof navigator<"u"&&typeof navigator.userAgent<"u"){let a=navigator.userAgent;n=/^((?!chrome|android).)*safari/i.test(a)===!0;let l=a.match(/Version\/(\d+)/);r=n&&l?parseInt(l[1],10):-1,s=a.indexOf("Firefox")>-1,o=s?a.match(/Firefox\/([0-9]+)\./)[1]:-1}typeof createImageBitmap>"u"||n&&r<17||s&&o<98?(this.textureLoader=new yl(this.options.manager),this.textureLoader.setPriority(this.options.priority),this.textureLoader.setCache(this.options.cache)):(this.textureLoader=new Ml(this.options.manager),this.textureLoader.setPriority(this.options.priority),this.textureLoader.setCache(this.options.cache)),this.textureLoader.setCrossOrigin(this.options.crossOrigin),this.textureLoader.setWithCredentials(this.options.withCredentials),this.textureLoader.setRequestHeader(this.options.requestHeader),this.fileLoader=new ss(this.options.manager),this.fileLoader.setPriority(this.options.priority),this.fileLoader.setCache(this.options.cache),this.fileLoader.setResponseType("arraybuffer"),(this.options.withCredentials||this.options.crossOrigin==="use-credentials")&&this.fileLoader.setWithCredentials(!0)}setExtensions(e){this.extensions=e}setPlugins(e){this.plugins=e}parse(e,t){let n=this,r=this.json,s=this.extensions;this.cache.removeAll(),this.nodeCache={},this._invokeAll(function(o){return o._markDefs&&o._markDefs()}),Promise.all(this._invokeAll(function(o){return o.beforeRoot&&o.beforeRoot()})).then(function(){return Promise.all([n.getDependencies("scene"),n.getDependencies("animation"),n.getDependencies("camera")])}).then(function(o){let a={scene:o[0][r.scene||0],scenes:o[0],animations:o[1],cameras:o[2],asset:r.asset,parser:n,userData:{}};return Ao(s,a,r),Vr(a,r),Promise.all(n._invokeAll(function(l){return l.afterRoot&&l.afterRoot(a)})).then(function(){for(let l of a.scenes)l.updateMatrixWorld();e(a)})}).catch(t)}_markDefs(){let e=this.json.nodes||[],t=this.json.skins||[],n=this.json.meshes||[];for(let r=0,s=t.length;r<s;r++){let o=t[r].joints;for(let a=0,l=o.length;a<l;a++)e[o[a]].isBone=!0}for(let r=0,s=e.length;r<s;r++){let o=e[r];o.mesh!==void 0&&(this._addNodeRef(this.meshCache,o.mesh),o.skin!==void 0&&(n[o.mesh].isSkinnedMesh=!0)),o.camera!==void 0&&this._addNodeRef(this.cameraCache,o.camera)}}_addNodeRef(e,t){t!==void 0&&(e.refs[t]===void 0&&(e.refs[t]=e.uses[t]=0),e.refs[t]++)}_getNodeRef(e,t,n){if(e.refs[t]<=1)return n;let r=n.clone(),s=(o,a)=>{let l=this.associations.get(o);l!=null&&this.associations.set(a,l);for(let[c,u]of o.children.entries())s(u,a.children[c])};return s(n,r),r.name+="_instance_"+e.uses[t]++,r}_invokeOne(e){let t=Object.values(this.plugins);t.push(this);for(let n=0;n<t.length;n++){let r=e(t[n]);if(r)return r}return null}_invokeAll(e){let t=Object.values(this.plugins);t.unshift(this);let n=[];for(let r=0;r<t.length;r++){let s=e(t[r]);s&&n.push(s)}return n}getDependency(e,t){let n=e+":"+t,r=this.cache.get(n);if(!r){switch(e){case"scene":r=this.loadScene(t);break;case"node":r=this._invokeOne(function(s){return s.loadNode&&s.loadNode(t)});break;case"mesh":r=this._invokeOne(function(s){return s.loadMesh&&s.loadMesh(t)});break;case"accessor":r=this.loadAccessor(t);break;case"bufferView":r=this._invokeOne(function(s){return s.loadBufferView&&s.loadBufferView(t)});break;case"buffer":r=this.loadBuffer(t);break;case"material":r=this._invokeOne(function(s){return s.loadMaterial&&s.loadMaterial(t)});break;case"texture":r=this._invokeOne(function(s){return s.loadTexture&&s.loadTexture(t)});break;case"skin":r=this.loadSkin(t);break;case"animation":r=this._invokeOne(function(s){return s.loadAnimation&&s.loadAnimation(t)});break;case"camera":r=this.loadCamera(t);break;default:if(r=this._invokeOne(function(s){return s!=this&&s.getDependency&&s.getDependency(e,t)}),!r)throw new Error("Unknown type: "+e);break}this.cache.add(n,r)}return r}getDependencies(e){let t=this.cache.get(e);if(!t){let n=this,r=this.json[e+(e==="mesh"?"es":"s")]||[];t=Promise.all(r.map(function(s,o){return n.getDependency(e,o)})),this.cache.add(e,t)}return t}loadBuffer(e){let t=this.json.buffers[e],n=this.fileLoader;if(t.type&&t.type!=="arraybuffer")throw new Error("THREE.GLTFLoader: "+t.type+" buffer type is not supported.");if(t.uri===void 0&&e===0)return Promise.resolve(this.extensions[Ct.KHR_BINARY_GLTF].body);let r=this.options;return new Promise(function(s,o){n.load(os.resolveURL(t.uri,r.path),s,void 0,function(){o(new Error('THREE.GLTFLoader: Failed to load buffer "'+t.uri+'".'))})})}loadBufferView(e){let t=this.json.bufferViews[e];return this.getDependency("buffer",t.buffer).then(function(n){let r=t.byteLength||0,s=t.byteOffset||0;return n.slice(s,s+r)})}loadAccessor(e){let t=this,n=this.json,r=this.json.accessors[e];if(r.bufferView===void 0&&r.sparse===void 0){let o=Hp[r.type],a=za[r.componentType],l=r.normalized===!0,c=new a(r.count*o);return Promise.resolve(new an(c,o,l))}let s=[];return r.bufferView!==void 0?s.push(this.getDependency("bufferView",r.bufferView)):s.push(null),r.sparse!==void 0&&(s.push(this.getDependency("bufferView",r.sparse.indices.bufferView)),s.push(this.getDependency("bufferView",r.sparse.values.bufferView))),Promise.all(s).then(function(o){let a=o[0],l=Hp[r.type],c=za[r.componentType],u=c.BYTES_PER_ELEMENT,h=u*l,f=r.byteOffset||0,d=r.bufferView!==void 0?n.bufferViews[r.bufferView].byteStride:void 0,m=r.normalized===!0,b,g;if(d&&d!==h){let _=Math.floor(f/d),S="InterleavedBuffer:"+r.bufferView+":"+r.componentType+":"+_+":"+r.count,T=t.cache.get(S);T||(b=new c(a,_*d,r.count*d/u),T=new na(b,d/u),t.cache.add(S,T)),g=new ia(T,l,f%d/u,m)}else a===null?b=new c(r.count*l):b=new c(a,f,r.count*l),g=new an(b,l,m);if(r.sparse!==void 0){let _=Hp.SCALAR,S=za[r.sparse.indices.componentType],T=r.sparse.indices.byteOffset||0,M=r.sparse.values.byteOffset||0,P=new S(o[1],T,r.sparse.count*_),R=new c(o[2],M,r.sparse.count*l);a!==null&&(g=new an(g.array.slice(),g.itemSize,g.normalized)),g.normalized=!1;for(let y=0,A=P.length;y<A;y++){let V=P[y];if(g.setX(V,R[y*l]),l>=2&&g.setY(V,R[y*l+1]),l>=3&&g.setZ(V,R[y*l+2]),l>=4&&g.setW(V,R[y*l+3]),l>=5)throw new Error("THREE.GLTFLoader: Unsupported itemSize in sparse BufferAttribute.")}g.normalized=m}return g})}loadTexture(e){let t=this.json,n=this.options,s=t.textures[e].source,o=t.images[s],a=this.textureLoader;if(o.uri){let l=n.manager.getHandler(o.uri);l!==null&&(a=l)}return this.loadTextureImage(e,s,a)}loadTextureImage(e,t,n){let r=this,s=this.json,o=s.textures[e],a=s.images[t],l=(a.uri||a.bufferView)+":"+o.sampler;if(this.textureCache[l])return this.textureCache[l];let c=this.loadImageSource(t,n).then(function(u){u.flipY=!1,u.name=o.name||a.name||"",u.name===""&&typeof a.uri=="string"&&a.uri.startsWith("data:image/")===!1&&(u.name=a.uri);let f=(s.samplers||{})[o.sampler]||{};return u.magFilter=r1[f.magFilter]||qt,u.minFilter=r1[f.minFilter]||Fi,u.wrapS=s1[f.wrapS]||Ns,u.wrapT=s1[f.wrapT]||Ns,u.generateMipmaps=!u.isCompressedTexture&&u.minFilter!==Ut&&u.minFilter!==qt,r.associations.set(u,{textures:e}),u}).catch(function(){return null});return this.textureCache[l]=c,c}loadImageSource(e,t){let n=this,r=this.json,s=this.options;if(this.sourceCache[e]!==void 0)return this.sourceCache[e].then(f=>f.clone());let o=r.images[e],a=self.URL||self.webkitURL,l=o.uri||"",c=!1,u;if(t.isKTX2Loader===!0&&o.bufferView!==void 0)u=n.getDependency("bufferView",o.bufferView).then(function(f){return new Promise(function(d,m){t.parse(f,d,m)})});else{if(o.bufferView!==void 0)l=n.getDependency("bufferView",o.bufferView).then(function(f){c=!0;let d=new Blob([f],{type:o.mimeType});return l=a.createObjectURL(d),l});else if(o.uri===void 0)throw new Error("THREE.GLTFLoader: Image "+e+" is missing URI and bufferView");u=Promise.resolve(l).then(function(f){return new Promise(function(d,m){let b=d;t.isImageBitmapLoader===!0&&(b=function(g){let _=new $n(g);_.needsUpdate=!0,d(_)}),t.load(os.resolveURL(f,s.path),b,void 0,m)})})}let h=u.then(function(f){return c===!0&&a.revokeObjectURL(l),Vr(f,o),f.userData.mimeType=o.mimeType||mE(o.uri),f}).catch(function(f){throw console.error("THREE.GLTFLoader: Couldn't load texture",l),f});return this.sourceCache[e]=h,h}assignTexture(e,t,n,r){let s=this;return this.getDependency("texture",n.index).then(function(o){if(!o)return null;if(n.texCoord!==void 0&&n.texCoord>0&&(o=o.clone(),o.channel=n.texCoord),s.extensions[Ct.KHR_TEXTURE_TRANSFORM]){let a=n.extensions!==void 0?n.extensions[Ct.KHR_TEXTURE_TRANSFORM]:void 0;if(a){let l=s.associations.get(o);o=s.extensions[Ct.KHR_TEXTURE_TRANSFORM].extendTexture(o,a),s.associations.set(o,l)}}return r!==void 0&&(o.colorSpace=r),e[t]=o,o})}assignFinalMaterial(e){let t=e.geometry,n=e.material,r=t.attributes.tangent===void 0,s=t.attributes.color!==void 0,o=t.attributes.normal===void 0;if(e.isPoints){let a="PointsMaterial:"+n.uuid,l=this.cache.get(a);l||(l=new lr,Kn.prototype.copy.call(l,n),l.color.copy(n.color),l.map=n.map,l.sizeAttenuation=!1,this.cache.add(a,l)),n=l}else if(e.isLine){let a="LineBasicMaterial:"+n.uuid,l=this.cache.get(a);l||(l=new Rr,Kn.prototype.copy.call(l,n),l.color.copy(n.color),l.map=n.map,this.cache.add(a,l)),n=l}if(r||s||o){let a="ClonedMaterial:"+n.uuid+":";r&&(a+="derivative-tangents:"),s&&(a+="vertex-colors:"),o&&(a+="flat-shading:");let l=this.cache.get(a);l||(l=n.clone(),s&&(l.vertexColors=!0),o&&(l.flatShading=!0),r&&(l.normalScale&&(l.normalScale.y*=-1),l.clearcoatNormalScale&&(l.clearcoatNormalScale.y*=-1)),this.cache.add(a,l),this.associations.set(l,this.associations.get(n))),n=l}e.material=n}getMaterialType(){return oo}loadMaterial(e){let t=this,n=this.json,r=this.extensions,s=n.materials[e],o,a={},l=s.extensions||{},c=[];if(l[Ct.KHR_MATERIALS_UNLIT]){let h=r[Ct.KHR_MATERIALS_UNLIT];o=h.getMaterialType(),c.push(h.extendParams(a,s,t))}else{let h=s.pbrMetallicRoughness||{};if(a.color=new ht(1,1,1),a.opacity=1,Array.isArray(h.baseColorFactor)){let f=h.baseColorFactor;a.color.setRGB(f[0],f[1],f[2],dn),a.opacity=f[3]}h.baseColorTexture!==void 0&&c.push(t.assignTexture(a,"map",h.baseColorTexture,Ln)),a.metalness=h.metallicFactor!==void 0?h.metallicFactor:1,a.roughness=h.roughnessFactor!==void 0?h.roughnessFactor:1,h.metallicRoughnessTexture!==void 0&&(c.push(t.assignTexture(a,"metalnessMap",h.metallicRoughnessTexture)),c.push(t.assignTexture(a,"roughnessMap",h.metallicRoughnessTexture))),o=this._invokeOne(function(f){return f.getMaterialType&&f.getMaterialType(e)}),c.push(Promise.all(this._invokeAll(function(f){return f.extendMaterialParams&&f.extendMaterialParams(e,a)})))}s.doubleSided===!0&&(a.side=Xi);let u=s.alphaMode||Gp.OPAQUE;if(u===Gp.BLEND?(a.transparent=!0,a.depthWrite=!1):(a.transparent=!1,u===Gp.MASK&&(a.alphaTest=s.alphaCutoff!==void 0?s.alphaCutoff:.5)),s.normalTexture!==void 0&&o!==Er&&(c.push(t.assignTexture(a,"normalMap",s.normalTexture)),a.normalScale=new xt(1,1),s.normalTexture.scale!==void 0)){let h=s.normalTexture.scale;a.normalScale.set(h,h)}if(s.occlusionTexture!==void 0&&o!==Er&&(c.push(t.assignTexture(a,"aoMap",s.occlusionTexture)),s.occlusionTexture.strength!==void 0&&(a.aoMapIntensity=s.occlusionTexture.strength)),s.emissiveFactor!==void 0&&o!==Er){let h=s.emissiveFactor;a.emissive=new ht().setRGB(h[0],h[1],h[2],dn)}return s.emissiveTexture!==void 0&&o!==Er&&c.push(t.assignTexture(a,"emissiveMap",s.emissiveTexture,Ln)),Promise.all(c).then(function(){let h=new o(a);return s.name&&(h.name=s.name),Vr(h,s),t.associations.set(h,{materials:e}),s.extensions&&Ao(r,h,s),h})}createUniqueName(e){let t=rn.sanitizeNodeName(e||"");return t in this.nodeNamesUsed?t+"_"+ ++this.nodeNamesUsed[t]:(this.nodeNamesUsed[t]=0,t)}loadGeometries(e){let t=this,n=this.extensions,r=this.primitiveCache;function s(a){return n[Ct.KHR_DRACO_MESH_COMPRESSION].decodePrimitive(a,t).then(function(l){return o1(l,a,t)})}let o=[];for(let a=0,l=e.length;a<l;a++){let c=e[a],u=pE(c),h=r[u];if(h)o.push(h.promise);else{let f;c.extensions&&c.extensions[Ct.KHR_DRACO_MESH_COMPRESSION]?f=s(c):f=o1(new _n,c,t),c.mode===Ki.TRIANGLE_STRIP?f=f.then(d=>Vp(d,Ll)):c.mode===Ki.TRIANGLE_FAN&&(f=f.then(d=>Vp(d,ma))),r[u]={primitive:c,promise:f},o.push(f)}}return Promise.all(o)}loadMesh(e){let t=this,n=this.json,r=this.extensions,s=n.meshes[e],o=s.primitives,a=[];for(let l=0,c=o.length;l<c;l++){let u=o[l].material===void 0?hE(this.cache):this.getDependency("material",o[l].material);a.push(u)}return a.push(t.loadGeometries(o)),Promise.all(a).then(async function(l){let c=l.slice(0,l.length-1),u=l[l.length-1],h=[];for(let d=0,m=u.length;d<m;d++){let b=u[d],g=o[d],_,S=c[d];if(g.mode===Ki.TRIANGLES||g.mode===Ki.TRIANGLE_STRIP||g.mode===Ki.TRIANGLE_FAN||g.mode===void 0){let T=s.isSkinnedMesh===!0,M=b.hasAttribute("skinIndex")&&b.hasAttribute("skinWeight");T&&M===!1&&console.warn("THREE.GLTFLoader: Missing skinIndex or skinWeight attributes. Skinning disabled."),_=T&&M?new cl(b,S):new In(b,S),_.isSkinnedMesh===!0&&_.normalizeSkinWeights()}else if(g.mode===Ki.LINES)_=new Fs(b,S);else if(g.mode===Ki.LINE_STRIP)_=new so(b,S);else if(g.mode===Ki.LINE_LOOP)_=new fl(b,S);else if(g.mode===Ki.POINTS)_=new es(b,S);else throw new Error("THREE.GLTFLoader: Primitive mode unsupported: "+g.mode);Object.keys(_.geometry.morphAttributes).length>0&&dE(_,s),_.name=t.createUniqueName(s.name||"mesh_"+e),Vr(_,s),g.extensions&&Ao(r,_,g),t.assignFinalMaterial(_),h.push(_)}for(let d=0,m=h.length;d<m;d++)t.associations.set(h[d],{meshes:e,primitives:d});if(h.length===1)return s.extensions&&Ao(r,h[0],s),h[0];let f=new Pi;s.extensions&&Ao(r,f,s),t.associations.set(f,{meshes:e});for(let d=0,m=h.length;d<m;d++)f.add(h[d]);return f})}loadCamera(e){let t,n=this.json.cameras[e],r=n[n.type];if(!r){console.warn("THREE.GLTFLoader: Missing camera parameters.");return}return n.type==="perspective"?t=new ei(Xu.radToDeg(r.yfov),r.aspectRatio||1,r.znear||1,r.zfar||2e6):n.type==="orthographic"&&(t=new co(-r.xmag,r.xmag,r.ymag,-r.ymag,r.znear,r.zfar)),n.name&&(t.name=this.createUniqueName(n.name)),Vr(t,n),Promise.resolve(t)}loadSkin(e){let t=this.json.skins[e],n=[];for(let r=0,s=t.joints.length;r<s;r++)n.push(this._loadNodeShallow(t.joints[r]));return t.inverseBindMatrices!==void 0?n.push(this.getDependency("accessor",t.inverseBindMatrices)):n.push(null),Promise.all(n).then(function(r){let s=r.pop(),o=r,a=[],l=[];for(let c=0,u=o.length;c<u;c++){let h=o[c];if(h){a.push(h);let f=new it;s!==null&&f.fromArray(s.array,c*16),l.push(f)}else console.warn('THREE.GLTFLoader: Joint "%s" could not be found.',t.joints[c])}return new ul(a,l)})}loadAnimation(e){let t=this.json,n=this,r=t.animations[e],s=r.name?r.name:"animation_"+e,o=[],a=[],l=[],c=[],u=[];for(let h=0,f=r.channels.length;h<f;h++){let d=r.channels[h],m=r.samplers[d.sampler],b=d.target,g=b.node,_=r.parameters!==void 0?r.parameters[m.input]:m.input,S=r.parameters!==void 0?r.parameters[m.output]:m.output;b.node!==void 0&&(o.push(this.getDependency("node",g)),a.push(this.getDependency("accessor",_)),l.push(this.getDependency("accessor",S)),c.push(m),u.push(b))}return Promise.all([Promise.all(o),Promise.all(a),Promise.all(l),Promise.all(c),Promise.all(u)]).then(function(h){let f=h[0],d=h[1],m=h[2],b=h[3],g=h[4],_=[];for(let T=0,M=f.length;T<M;T++){let P=f[T],R=d[T],y=m[T],A=b[T],V=g[T];if(P===void 0)continue;P.updateMatrix&&P.updateMatrix();let z=n._createAnimationTracks(P,R,y,A,V);if(z)for(let D=0;D<z.length;D++)_.push(z[D])}let S=new vl(s,void 0,_);return Vr(S,r),S})}createNodeMesh(e){let t=this.json,n=this,r=t.nodes[e];return r.mesh===void 0?null:n.getDependency("mesh",r.mesh).then(function(s){let o=n._getNodeRef(n.meshCache,r.mesh,s);return r.weights!==void 0&&o.traverse(function(a){if(a.isMesh)for(let l=0,c=r.weights.length;l<c;l++)a.morphTargetInfluences[l]=r.weights[l]}),o})}loadNode(e){let t=this.json,n=this,r=t.nodes[e],s=n._loadNodeShallow(e),o=[],a=r.children||[];for(let c=0,u=a.length;c<u;c++)o.push(n.getDependency("node",a[c]));let l=r.skin===void 0?Promise.resolve(null):n.getDependency("skin",r.skin);return Promise.all([s,Promise.all(o),l]).then(function(c){let u=c[0],h=c[1],f=c[2];f!==null&&u.traverse(function(d){d.isSkinnedMesh&&d.bind(f,gE)});for(let d=0,m=h.length;d<m;d++)u.add(h[d]);if(u.userData.pivot!==void 0&&h.length>0){let d=u.userData.pivot,m=h[0];u.pivot=new J().fromArray(d),u.position.x-=d[0],u.position.y-=d[1],u.position.z-=d[2],m.position.set(0,0,0),delete u.userData.pivot}return u})}_loadNodeShallow(e){let t=this.json,n=this.extensions,r=this;if(this.nodeCache[e]!==void 0)return this.nodeCache[e];let s=t.nodes[e],o=s.name?r.createUniqueName(s.name):"",a=[],l=r._invokeOne(function(c){return c.createNodeMesh&&c.createNodeMesh(e)});return l&&a.push(l),s.camera!==void 0&&a.push(r.getDependency("camera",s.camera).then(function(c){return r._getNodeRef(r.cameraCache,s.camera,c)})),r._invokeAll(function(c){return c.createNodeAttachment&&c.createNodeAttachment(e)}).forEach(function(c){a.push(c)}),this.nodeCache[e]=Promise.all(a).then(function(c){let u;if(s.isBone===!0?u=new ra:c.length>1?u=new Pi:c.length===1?u=c[0]:u=new wn,u!==c[0])for(let h=0,f=c.length;h<f;h++)u.add(c[h]);if(s.name&&(u.userData.name=s.name,u.name=o),Vr(u,s),s.extensions&&Ao(n,u,s),s.matrix!==void 0){let h=new it;h.fromArray(s.matrix),u.applyMatrix4(h)}else s.translation!==void 0&&u.position.fromArray(s.translation),s.rotation!==void 0&&u.quaternion.fromArray(s.rotation),s.scale!==void 0&&u.scale.fromArray(s.scale);if(!r.associations.has(u))r.associations.set(u,{});else if(s.mesh!==void 0&&r.meshCache.refs[s.mesh]>1){let h=r.associations.get(u);r.associations.set(u,{...h})}return r.associations.get(u).nodes=e,u}),this.nodeCache[e]}loadScene(e){let t=this.extensions,n=this.json.scenes[e],r=this,s=new Pi;n.name&&(s.name=r.createUniqueName(n.name)),Vr(s,n),n.extensions&&Ao(t,s,n);let o=n.nodes||[],a=[];for(let l=0,c=o.length;l<c;l++)a.push(r.getDependency("node",o[l]));return Promise.all(a).then(function(l){for(let u=0,h=l.length;u<h;u++){let f=l[u];f.parent!==null?s.add(t1(f)):s.add(f)}let c=u=>{let h=new Map;for(let[f,d]of r.associations)(f instanceof Kn||f instanceof $n)&&h.set(f,d);return u.traverse(f=>{let d=r.associations.get(f);d!=null&&h.set(f,d)}),h};return r.associations=c(s),s})}_createAnimationTracks(e,t,n,r,s){let o=[],a=e.name?e.name:e.uuid,l=[];function c(d){d.morphTargetInfluences&&l.push(d.name?d.name:d.uuid)}Gs[s.path]===Gs.weights?(c(e),e.isGroup&&e.children.forEach(c)):l.push(a);let u;switch(Gs[s.path]){case Gs.weights:u=ns;break;case Gs.rotation:u=is;break;case Gs.translation:case Gs.scale:u=Us;break;default:n.itemSize===1?u=ns:u=Us;break}let h=r.interpolation!==void 0?uE[r.interpolation]:to,f=this._getArrayFromAccessor(n);for(let d=0,m=l.length;d<m;d++){let b=new u(l[d]+"."+Gs[s.path],t.array,f,h);r.interpolation==="CUBICSPLINE"&&this._createCubicSplineTrackInterpolant(b),o.push(b)}return o}_getArrayFromAccessor(e){let t=e.array;if(e.normalized){let n=mm(t.constructor),r=new Float32Array(t.length);for(let s=0,o=t.length;s<o;s++)r[s]=t[s]*n;t=r}return t}_createCubicSplineTrackInterpolant(e){e.createInterpolant=function(n){let r=this instanceof is?dm:Vh;return new r(this.times,this.values,this.getValueSize()/3,n)},e.createInterpolant.isInterpolantFactoryMethodGLTFCubicSpline=!0}};function _E(i,e,t){let n=e.attributes,r=new Ni;if(n.POSITION!==void 0){let a=t.json.accessors[n.POSITION],l=a.min,c=a.max;if(l!==void 0&&c!==void 0){if(r.set(new J(l[0],l[1],l[2]),new J(c[0],c[1],c[2])),a.normalized){let u=mm(za[a.componentType]);r.min.multiplyScalar(u),r.max.multiplyScalar(u)}}else{console.warn("THREE.GLTFLoader: Missing min/max properties for accessor POSITION.");return}}else return;let s=e.targets;if(s!==void 0){let a=new J,l=new J;for(let c=0,u=s.length;c<u;c++){let h=s[c];if(h.POSITION!==void 0){let f=t.json.accessors[h.POSITION],d=f.min,m=f.max;if(d!==void 0&&m!==void 0){if(l.setX(Math.max(Math.abs(d[0]),Math.abs(m[0]))),l.setY(Math.max(Math.abs(d[1]),Math.abs(m[1]))),l.setZ(Math.max(Math.abs(d[2]),Math.abs(m[2]))),f.normalized){let b=mm(za[f.componentType]);l.multiplyScalar(b)}a.max(l)}else console.warn("THREE.GLTFLoader: Missing min/max properties for accessor POSITION.")}}r.expandByVector(a)}i.boundingBox=r;let o=new vi;r.getCenter(o.center),o.radius=r.min.distanceTo(r.max)/2,i.boundingSphere=o}function o1(i,e,t){let n=e.attributes,r=[];function s(o,a){return t.getDependency("accessor",o).then(function(l){i.setAttribute(a,l)})}for(let o in n){let a=pm[o]||o.toLowerCase();a in i.attributes||r.push(s(n[o],a))}if(e.indices!==void 0&&!i.index){let o=t.getDependency("accessor",e.indices).then(function(a){i.setIndex(a)});r.push(o)}return Rt.workingColorSpace!==dn&&"COLOR_0"in n&&console.warn(`THREE.GLTFLoader: Converting vertex colors from "srgb-linear" to "${Rt.workingColorSpace}" not supported.`),Vr(i,e),_E(i,e,t),Promise.all(r).then(function(){return e.targets!==void 0?fE(i,e.targets,t):i})}var xE=/^[og]\s*(.+)?/,vE=/^mtllib /,yE=/^usemtl /,bE=/^usemap /,Hh=/\s+/,l1=new J,_m=new J,c1=new J,u1=new J,Ji=new J,Gh=new ht;function wE(){let i={objects:[],object:{},vertices:[],normals:[],colors:[],uvs:[],materials:{},materialLibraries:[],startObject:function(e,t){if(this.object&&this.object.fromDeclaration===!1){this.object.name=e,this.object.fromDeclaration=t!==!1;return}let n=this.object&&typeof this.object.currentMaterial=="function"?this.object.currentMaterial():void 0;if(this.object&&typeof this.object._finalize=="function"&&this.object._finalize(!0),this.object={name:e||"",fromDeclaration:t!==!1,geometry:{vertices:[],normals:[],colors:[],uvs:[],hasUVIndices:!1},materials:[],smooth:!0,startMaterial:function(r,s){let o=this._finalize(!1);o&&(o.inherited||o.groupCount<=0)&&this.materials.splice(o.index,1);let a={index:this.materials.length,name:r||"",mtllib:Array.isArray(s)&&s.length>0?s[s.length-1]:"",smooth:o!==void 0?o.smooth:this.smooth,groupStart:o!==void 0?o.groupEnd:0,groupEnd:-1,groupCount:-1,inherited:!1,clone:function(l){let c={index:typeof l=="number"?l:this.index,name:this.name,mtllib:this.mtllib,smooth:this.smooth,groupStart:0,groupEnd:-1,groupCount:-1,inherited:!1};return c.clone=this.clone.bind(c),c}};return this.materials.push(a),a},currentMaterial:function(){if(this.materials.length>0)return this.materials[this.materials.length-1]},_finalize:function(r){let s=this.currentMaterial();if(s&&s.groupEnd===-1&&(s.groupEnd=this.geometry.vertices.length/3,s.groupCount=s.groupEnd-s.groupStart,s.inherited=!1),r&&this.materials.length>1)for(let o=this.materials.length-1;o>=0;o--)this.materials[o].groupCount<=0&&this.materials.splice(o,1);return r&&this.materials.length===0&&this.materials.push({name:"",smooth:this.smooth}),s}},n&&n.name&&typeof n.clone=="function"){let r=n.clone(0);r.inherited=!0,this.object.materials.push(r)}this.objects.push(this.object)},finalize:function(){this.object&&typeof this.object._finalize=="function"&&this.object._finalize(!0)},parseVertexIndex:function(e,t){let n=parseInt(e,10);return(n>=0?n-1:n+t/3)*3},parseNormalIndex:function(e,t){let n=parseInt(e,10);return(n>=0?n-1:n+t/3)*3},parseUVIndex:function(e,t){let n=parseInt(e,10);return(n>=0?n-1:n+t/2)*2},addVertex:function(e,t,n){let r=this.vertices,s=this.object.geometry.vertices;s.push(r[e+0],r[e+1],r[e+2]),s.push(r[t+0],r[t+1],r[t+2]),s.push(r[n+0],r[n+1],r[n+2])},addVertexPoint:function(e){let t=this.vertices;this.object.geometry.vertices.push(t[e+0],t[e+1],t[e+2])},addVertexLine:function(e){let t=this.vertices;this.object.geometry.vertices.push(t[e+0],t[e+1],t[e+2])},addNormal:function(e,t,n){let r=this.normals,s=this.object.geometry.normals;s.push(r[e+0],r[e+1],r[e+2]),s.push(r[t+0],r[t+1],r[t+2]),s.push(r[n+0],r[n+1],r[n+2])},addFaceNormal:function(e,t,n){let r=this.vertices,s=this.object.geometry.normals;l1.fromArray(r,e),_m.fromArray(r,t),c1.fromArray(r,n),Ji.subVectors(c1,_m),u1.subVectors(l1,_m),Ji.cross(u1),Ji.normalize(),s.push(Ji.x,Ji.y,Ji.z),s.push(Ji.x,Ji.y,Ji.z),s.push(Ji.x,Ji.y,Ji.z)},addColor:function(e,t,n){let r=this.colors,s=this.object.geometry.colors;r[e]!==void 0&&s.push(r[e+0],r[e+1],r[e+2]),r[t]!==void 0&&s.push(r[t+0],r[t+1],r[t+2]),r[n]!==void 0&&s.push(r[n+0],r[n+1],r[n+2])},addUV:function(e,t,n){let r=this.uvs,s=this.object.geometry.uvs;s.push(r[e+0],r[e+1]),s.push(r[t+0],r[t+1]),s.push(r[n+0],r[n+1])},addDefaultUV:function(){let e=this.object.geometry.uvs;e.push(0,0),e.push(0,0),e.push(0,0)},addUVLine:function(e){let t=this.uvs;this.object.geometry.uvs.push(t[e+0],t[e+1])},addFace:function(e,t,n,r,s,o,a,l,c){let u=this.vertices.length,h=this.parseVertexIndex(e,u),f=this.parseVertexIndex(t,u),d=this.parseVertexIndex(n,u);if(this.addVertex(h,f,d),this.addColor(h,f,d),a!==void 0&&a!==""){let m=this.normals.length;h=this.parseNormalIndex(a,m),f=this.parseNormalIndex(l,m),d=this.parseNormalIndex(c,m),this.addNormal(h,f,d)}else this.addFaceNormal(h,f,d);if(r!==void 0&&r!==""){let m=this.uvs.length;h=this.parseUVIndex(r,m),f=this.parseUVIndex(s,m),d=this.parseUVIndex(o,m),this.addUV(h,f,d),this.object.geometry.hasUVIndices=!0}else this.addDefaultUV()},addPointGeometry:function(e){this.object.geometry.type="Points";let t=this.vertices.length;for(let n=0,r=e.length;n<r;n++){let s=this.parseVertexIndex(e[n],t);this.addVertexPoint(s),this.addColor(s)}},addLineGeometry:function(e,t){this.object.geometry.type="Line";let n=this.vertices.length,r=this.uvs.length;for(let s=0,o=e.length-1;s<o;s++)this.addVertexLine(this.parseVertexIndex(e[s],n)),this.addVertexLine(this.parseVertexIndex(e[s+1],n));for(let s=0,o=t.length-1;s<o;s++)this.addUVLine(this.parseUVIndex(t[s],r)),this.addUVLine(this.parseUVIndex(t[s+1],r))}};return i.startObject("",!1),i}var Wh=class extends Di{constructor(e){super(e),this.materials=null}load(e,t,n,r){let s=this,o=new ss(this.manager);o.setPriority(this.priority),o.setCache(this.cache),o.setPath(this.path),o.setRequestHeader(this.requestHeader),o.setWithCredentials(this.withCredentials),o.load(e,function(a){try{t(s.parse(a))}catch(l){r?r(l):console.error(l),s.manager.itemError(e)}},n,r)}setMaterials(e){return this.materials=e,this}parse(e){let t=new wE;e.indexOf(`\r
`)!==-1&&(e=e.replace(/\r\n/g,`
`)),e.indexOf(`\\
`)!==-1&&(e=e.replace(/\\\n/g,""));let n=e.split(`
`),r=[];for(let a=0,l=n.length;a<l;a++){let c=n[a].trimStart();if(c.length===0)continue;let u=c.charAt(0);if(u!=="#")if(u==="v"){let h=c.split(Hh);switch(h[0]){case"v":t.vertices.push(parseFloat(h[1]),parseFloat(h[2]),parseFloat(h[3])),h.length>=7?(Gh.setRGB(parseFloat(h[4]),parseFloat(h[5]),parseFloat(h[6]),Ln),t.colors.push(Gh.r,Gh.g,Gh.b)):t.colors.push(void 0,void 0,void 0);break;case"vn":t.normals.push(parseFloat(h[1]),parseFloat(h[2]),parseFloat(h[3]));break;case"vt":t.uvs.push(parseFloat(h[1]),parseFloat(h[2]));break}}else if(u==="f"){let f=c.slice(1).trim().split(Hh),d=[];for(let b=0,g=f.length;b<g;b++){let _=f[b];if(_.length>0){let S=_.split("/");d.push(S)}}let m=d[0];for(let b=1,g=d.length-1;b<g;b++){let _=d[b],S=d[b+1];t.addFace(m[0],_[0],S[0],m[1],_[1],S[1],m[2],_[2],S[2])}}else if(u==="l"){let h=c.substring(1).trim().split(Hh),f=[],d=[];if(c.indexOf("/")===-1)f=h;else for(let m=0,b=h.length;m<b;m++){let g=h[m].split("/");g[0]!==""&&f.push(g[0]),g[1]!==""&&d.push(g[1])}t.addLineGeometry(f,d)}else if(u==="p"){let f=c.slice(1).trim().split(Hh);t.addPointGeometry(f)}else if((r=xE.exec(c))!==null){let h=(" "+r[0].slice(1).trim()).slice(1);t.startObject(h)}else if(yE.test(c))t.object.startMaterial(c.substring(7).trim(),t.materialLibraries);else if(vE.test(c))t.materialLibraries.push(c.substring(7).trim());else if(bE.test(c))console.warn('THREE.OBJLoader: Rendering identifier "usemap" not supported. Textures must be defined in MTL files.');else if(u==="s"){if(r=c.split(" "),r.length>1){let f=r[1].trim().toLowerCase();t.object.smooth=f!=="0"&&f!=="off"}else t.object.smooth=!0;let h=t.object.currentMaterial();h&&(h.smooth=t.object.smooth)}else{if(c==="\0")continue;console.warn('THREE.OBJLoader: Unexpected line: "'+c+'"')}}t.finalize();let s=new Pi;if(s.materialLibraries=[].concat(t.materialLibraries),!(t.objects.length===1&&t.objects[0].geometry.vertices.length===0)===!0)for(let a=0,l=t.objects.length;a<l;a++){let c=t.objects[a],u=c.geometry,h=c.materials,f=u.type==="Line",d=u.type==="Points",m=!1;if(u.vertices.length===0)continue;let b=new _n;b.setAttribute("position",new Cn(u.vertices,3)),u.normals.length>0&&b.setAttribute("normal",new Cn(u.normals,3)),u.colors.length>0&&(m=!0,b.setAttribute("color",new Cn(u.colors,3))),u.hasUVIndices===!0&&b.setAttribute("uv",new Cn(u.uvs,2));let g=[];for(let S=0,T=h.length;S<T;S++){let M=h[S],P=M.name+"_"+M.smooth+"_"+m,R=t.materials[P];if(this.materials!==null){if(R=this.materials.create(M.name),f&&R&&!(R instanceof Rr)){let y=new Rr;Kn.prototype.copy.call(y,R),y.color.copy(R.color),R=y}else if(d&&R&&!(R instanceof lr)){let y=new lr({size:10,sizeAttenuation:!1});Kn.prototype.copy.call(y,R),y.color.copy(R.color),y.map=R.map,R=y}}R===void 0&&(f?R=new Rr:d?R=new lr({size:1,sizeAttenuation:!1}):R=new _l,R.name=M.name,R.flatShading=!M.smooth,R.vertexColors=m,t.materials[P]=R),g.push(R)}let _;if(g.length>1){for(let S=0,T=h.length;S<T;S++){let M=h[S];b.addGroup(M.groupStart,M.groupCount,S)}f?_=new Fs(b,g):d?_=new es(b,g):_=new In(b,g)}else f?_=new Fs(b,g[0]):d?_=new es(b,g[0]):_=new In(b,g[0]);_.name=c.name,s.add(_)}else if(t.vertices.length>0){let a=new lr({size:1,sizeAttenuation:!1}),l=new _n;l.setAttribute("position",new Cn(t.vertices,3)),t.colors.length>0&&t.colors[0]!==void 0&&(l.setAttribute("color",new Cn(t.colors,3)),a.vertexColors=!0);let c=new es(l,a);s.add(c)}return s}};function h1(i,e){let[t,n,r]=["position","normal","uv"].map(l=>i.getAttribute(l)),s=i.index;if(!s)throw new Error("a geometry with indices is needed");let o=new Float32Array(4*t.count),a=l=>new J().fromBufferAttribute(t,l);for(let l=0;l<s.count;l+=3){let c=[s.getX(l),s.getX(l+1),s.getX(l+2)],[u,h,f]=c.map(a),[d,m]=[h.sub(u),f.sub(u)],b=V=>[r.getX(c[V]),(e?-1:1)*r.getY(c[V])],[g,_,S]=[0,1,2].map(b),[T,M]=[[_[0]-g[0],_[1]-g[1]],[S[0]-g[0],S[1]-g[1]]],P=T[0]*M[1]-T[1]*M[0];if(P===0)continue;let R=d.clone().multiplyScalar(M[1]).addScaledVector(m,-T[1]).multiplyScalar(Math.sign(P)).normalize(),y=m.clone().multiplyScalar(T[0]).addScaledVector(d,-M[0]).multiplyScalar(Math.sign(P)),A=d.clone().cross(m);for(let V of c){let z=new J().fromBufferAttribute(n,V);A.dot(z)<0&&A.negate();let D=R.clone().addScaledVector(z,-R.dot(z)).normalize();for(let[q,Y]of[D.x,D.y,D.z].entries())o[4*V+q]+=Y;o[4*V+3]=R.clone().cross(y).dot(A)<0?-1:1}}return o}var Eo=class extends Error{},SE=25,ME=1.04;async function f1(i){let e=/\.obj$/i.test(i.name),t;try{t=e?new Wh().parse(await i.text()):(await new zh().parseAsync(await i.arrayBuffer(),"")).scene}catch(n){throw new Eo(`${i.name} cannot be read: ${String(n)} A glTF file must hold everything itself (.glb).`)}return RE(TE(t,i.name),!e)}function TE(i,e){let t=[];if(i.updateMatrixWorld(!0),i.traverse(n=>{if(!(n instanceof In))return;let r=n.geometry.clone().applyMatrix4(n.matrixWorld);if(!r.getAttribute("uv"))throw new Eo(`${e} has no texture coordinates, so the structure has no direction on it. Unwrap the mesh and save it again.`);let s=new _n;s.setIndex(r.index);for(let o of["position","normal","uv"]){let a=r.getAttribute(o);a&&s.setAttribute(o,new an(Float32Array.from({length:a.count*a.itemSize},(l,c)=>a.getComponent(Math.floor(c/a.itemSize),c%a.itemSize)),a.itemSize))}s.getAttribute("normal")||s.computeVertexNormals(),t.push(s.index?s.toNonIndexed():s)}),!t.length)throw new Eo(`${e} holds no triangles.`);return e1(Qv(t),1e-7)}var AE=`
in vec3 position;
in vec3 normal;
in vec4 tangent;
uniform mat4 u_to_clip;
out vec3 v_place;
out vec3 v_normal;
out vec4 v_tangent;
void main() {
  v_place = position;
  v_normal = normal;
  v_tangent = tangent;
  gl_Position = u_to_clip * vec4(position, 1.0);
}
`,EE=`
${mh}
in vec3 v_normal;
in vec4 v_tangent;
uniform mat4 u_from_clip;
uniform vec2 u_size;
void main() {
  seen = true;
  vec3 normal = normalize(v_normal);
  vec2 clip = 2.0 * gl_FragCoord.xy / u_size - 1.0;
  vec4 near = u_from_clip * vec4(clip, -1.0, 1.0);
  vec3 to_viewer = normalize(near.xyz / near.w - v_place);
  shadow_place(v_place, normal);
  vec3 t = v_tangent.xyz - normal * dot(normal, v_tangent.xyz);
  if (dot(t, t) > 1e-12) {
    t = normalize(t);
    shade(Point(t, cross(normal, t) * (v_tangent.w < 0.0 ? -1.0 : 1.0), normal, to_viewer));
  }
  finish();
}
`;function RE(i,e){i.setAttribute("tangent",new an(h1(i,e),4)),i.computeBoundingBox();let t=i.boundingBox;if(!t)throw new Eo("The mesh has no size.");let n=t.getCenter(new J),r=t.getSize(new J).multiplyScalar(.5),s=r.length();if(!(s>0&&Number.isFinite(s)))throw new Eo("The mesh has no size, or places that are not finite.");let o=new Ta(i,{centre:n.toArray(),radius:1.05*s});return{geometry:i,view:CE(n,r),vertex:AE,fragment:EE,uniforms:o.uniforms,drawShadows:(a,l)=>o.draw(a,l)}}function CE(i,e){let t=Math.tan(.5*SE*Math.PI/180),r=ME*Math.max(e.x,e.y,.05*e.z)/t+e.z,s=e.length();return{position:[i.x,i.y,i.z+r],target:i.toArray(),parallel:!1,half:t,near:Math.max(.02*r,r-1.2*s),far:r+1.2*s}}function d1(i,e){i.addEventListener("dragover",t=>{t.preventDefault(),i.classList.add("dropping")}),i.addEventListener("dragleave",()=>i.classList.remove("dropping")),i.addEventListener("drop",t=>{t.preventDefault(),i.classList.remove("dropping"),e([...t.dataTransfer?.files??[]])})}function xm(i,e){let t=document.createElement("input");t.type="file",t.accept=i,t.addEventListener("change",()=>e([...t.files??[]])),t.click()}var IE=70,PE=400,Xh=36,LE=300,qh=.25,Yh=class{constructor(e,t,n){this.fault=n;this.page=qv({change:s=>this.set(s),current:()=>this.engine.state,savePng:()=>this.savePng(),record:()=>{this.record()},copyLink:()=>{this.copyLink()},theme:()=>{Kv(),this.stale.views=!0},exposure:()=>this.opened?this.engine.exposure():Math.PI,tables:()=>this.engine?.tableCount()??1,remeter:()=>{this.engine.remeter(),this.stale.picture=this.stale.controls=!0}}),this.engine=new vh(this.page.stage.canvas,t,jd(location.hash)),e.replaceChildren(this.page.element),this.page.map.onAsk=s=>{this.asked=s,this.stale.views=!0},this.page.spectrum.onChoose=s=>{this.measured=s,this.stale.views=!0};let{canvas:r}=this.page.stage;r.addEventListener("webglcontextlost",s=>{s.preventDefault(),this.fault(new Error("The graphics driver took its memory back (the WebGL context was lost). Load the page again."))}),d1(e,s=>{this.take(s)}),new ResizeObserver(()=>this.fit()).observe(this.page.stage.element),addEventListener("hashchange",()=>{location.hash!==xh(this.engine.state)&&this.set(jd(location.hash))})}fault;engine;page;pending=Promise.resolve();asked=null;measured=null;offeredFor="";stale={picture:!0,views:!0,controls:!0,address:!1};last={views:0,address:0,tick:0};frameMs=0;detail={now:1,moving:1};moved=0;tickMs=16;drew=!1;recording=!1;opened=!1;async start(){let{engine:e,page:t}=this;await e.open();let n=t.element.querySelector(".atlas-name");n&&(n.textContent=e.index.name),document.title=`${e.index.name} – diffraction atlas`,t.specimens.append(...await Yv(e,s=>this.set({specimen:s}))),await this.load(),this.opened=!0,this.firstFrames(),t.element.classList.add("ready");let r=s=>{try{this.tick(s),requestAnimationFrame(r)}catch(o){this.fault(o)}};requestAnimationFrame(r),this.load(!0)}firstFrames(){let{engine:e}=this;this.detail.now=qh,this.fit(),e.draw(0),e.restart();let t=performance.now();e.draw(0),e.finish();let n=(performance.now()-t)/qh**2;this.detail.moving=Math.min(1,Math.max(qh,Math.sqrt(Xh/n)))}set(e){let t=this.engine.state;if(e.shape==="model"&&!this.engine.model){this.stale.controls=!0,xm(".glb,.gltf,.obj",s=>{this.take(s)});return}if(e.environment==="own"&&t.environment!=="own"&&!this.engine.hasSky){this.stale.controls=!0,xm(".exr,.hdr",s=>{this.take(s)});return}this.engine.set(e)&&(this.moved=performance.now());let n=this.engine.state;if((e.pointer||e.specimen)&&(this.asked=this.measured=null),this.stale={picture:!0,views:!0,controls:!0,address:!0},t.size_px!==n.size_px&&this.fit(),!this.opened)return;let r=this.engine.wantsSpectral()&&!this.engine.loaded?.spectral;(t.specimen!==n.specimen||r)&&(this.pending=this.pending.then(()=>this.load()))}async load(e=!1){let{engine:t,page:n}=this,r=o=>{n.loading.value=o,n.loading.hidden=o>=1};try{r(.02),await t.loadSpecimen(r),(e||t.wantsSpectral()||this.opened)&&await t.loadSpectral(r),r(1)}catch(o){if(r(1),this.fault(o),!this.opened)throw o}this.stale={picture:!0,views:!0,controls:!0,address:!0};let s=t.loaded?.specimen.name??"";this.offeredFor!==s&&(this.offeredFor=s,n.spectrum.offer(await Om(t,s)))}fit(){let{size_px:e}=this.engine.state,t=this.page.stage.element.getBoundingClientRect(),n=Math.min(2,devicePixelRatio||1),r=Math.min(t.width,t.height);this.page.stage.square(e?r:null);let s=n*this.detail.now,[o,a]=e?[e,e]:[Math.round(t.width*s),Math.round(t.height*s)];o<1||a<1||(this.engine.resize(o,a),this.stale.picture=this.stale.views=!0)}tick(e){let{engine:t,page:n,stale:r}=this;if(this.move(e),r.controls){r.controls=!1;for(let s of n.controls)s.update(t.state);n.stage.update(t.state),n.facts.textContent=this.specimenFacts()}if(this.recording&&(r.picture=!0),this.chooseDetail(e),r.picture){let s=performance.now();r.picture=!t.draw(0),this.frameMs=.8*this.frameMs+.2*(performance.now()-s),this.updateStatus()}r.views&&e-this.last.views>IE&&(r.views=!1,this.last.views=e,this.updateViews()),r.address&&e-this.last.address>PE&&(r.address=!1,this.last.address=e,t.state.motion==="none"&&history.replaceState(null,"",xh(t.state)||location.pathname+location.search))}chooseDetail(e){let{detail:t,stale:n}=this,r=this.recording||e-this.moved<LE;if(r&&this.drew&&t.now===t.moving){let o=Math.min(1e3,this.tickMs);o>1.4*Xh?t.moving=Math.max(qh,t.moving*Math.max(.5,Math.sqrt(Xh/o))):o<.6*Xh&&t.moving<1&&(t.moving=Math.min(1,t.moving*1.1))}this.drew=n.picture;let s=r?t.moving:1;Math.abs(s-t.now)<.02*t.now&&s!==1||s!==t.now&&(t.now=s,this.fit())}move(e){this.tickMs=e-this.last.tick;let t=Math.min(.1,this.tickMs/1e3);this.last.tick=e;let{state:n}=this.engine;if(n.motion==="light"){let r=n.lights.map(s=>({...s,direction:DE(s.direction,40*t)}));this.set({lights:r})}else n.motion==="turntable"&&this.set({spin_deg:(n.spin_deg+30*t)%360})}updateViews(){let e=this.answer();for(let t of this.page.views)t.update(this.engine.state,this.engine,e);this.updateBadge(e),this.updateStatus()}answer(){let{engine:e}=this,t=e.evaluated(),n=this.measured?NE(this.measured):e.directions();if(!n||!t)return null;let r={wi:n.wi,wo:this.asked??n.wo},s=mx(r.wi).map(m=>({wi:r.wi,wo:m})),[o,...a]=e.probe.brdf(t,[r,...s]),l=e.loaded?.specimen,c=e.light()??uh(l?.optics.illuminant??"d65"),u=FE(c),h=e.spectralEvaluated(),f=l?.spectral,d=null;if(h&&f){let m=this.measured?.nm??[],b=[...new Set([...kp(f.shortest_nm,f.longest_nm),...m])].sort((_,S)=>_-S),g=b.map(_=>this.measured?.values[m.indexOf(_)]??null);d={nm:b,values:e.probe.spectrum(h,r,e.asks(b)),measured:g}}return{...r,chosen:this.measured!==null,xyz:o,plane:a,white:u,dominant:o?rx(o,u):null,spectrum:d}}updateBadge(e){let{badge:t}=this.page,n=this.engine.loaded?.specimen.tables.usable_radius??2,r=e?Math.hypot(e.wi[0]+e.wo[0],e.wi[1]+e.wo[1]):0,s=this.engine.lacking()||(e&&!e.xyz?"the tables do not cover the spot":r>n?"the spot lies beyond the scan’s sampling":"");t.textContent=s,t.hidden=s===""}updateStatus(){let{engine:e}=this,{taken:t,whole:n}=e.progress;this.page.status.textContent=`${Math.min(t,n)} / ${n} samples · ${e.size.width} × ${e.size.height} · ${e.lookups()} look-ups · ${e.clock.ms===null?`${Nn(this.frameMs,2)} ms`:`${Nn(e.clock.ms,2)} ms GPU`}`}specimenFacts(){let e=this.engine.loaded?.specimen;if(!e)return"";let{sigma_nm:t}=e.optics;return`${e.species??e.name} · coherence σ ${Nn(t/1e3)} µm`}async take(e){for(let t of e)try{if(/\.(glb|gltf|obj)$/i.test(t.name))this.engine.useModel(await f1(t)),this.set({shape:"model",view:{azimuth_deg:0,elevation_deg:0,zoom:1}});else if(/\.(exr|hdr)$/i.test(t.name))this.engine.useSky(await K_(t)),this.set({environment:"own"});else throw new Error("The page takes meshes (.glb, .gltf, .obj) and images of the surroundings (.exr, .hdr).")}catch(n){this.notice(`${t.name}: ${n instanceof Error?n.message:String(n)}`)}}notice(e){let t=Me("p",{className:"notice",role:"alert"},e);document.body.append(t),setTimeout(()=>t.remove(),7e3)}savePng(){this.detail.now=1,this.fit(),this.engine.draw(1/0),this.page.stage.canvas.toBlob(e=>e&&tp(e,`${this.engine.state.specimen}.${this.engine.state.shape}.png`))}async record(){let{state:e}=this.engine;e.motion==="none"&&this.set({motion:"light"}),this.recording=!0;let t=await sx(this.page.stage.canvas,5);this.recording=!1,e.motion==="none"&&this.set({motion:"none"}),t?tp(t,`${e.specimen}.${e.shape}.webm`):this.notice("This browser records no WebM.")}async copyLink(){history.replaceState(null,"",xh(this.engine.state)||location.pathname+location.search);try{await navigator.clipboard.writeText(location.href),this.notice("The link is copied.")}catch{this.notice("The link stands in the address bar.")}}api(e,t){let{engine:n}=this,r=(o,a,l,c)=>({wi:Xa(o,a),wo:Xa(l,c)}),s=async()=>{await e,await this.pending};return{ready:e,errors:t,set:o=>this.set(o),state:()=>structuredClone(n.state),frame:async()=>{await s(),this.detail.now=1,this.fit(),n.draw(1/0),this.updateViews()},pixels:()=>n.pixels(),xyz:()=>n.values(),exposure:()=>n.exposure(),brdfXyz:async(...o)=>{await s();let a=n.evaluated(!1,!1);return a?n.probe.brdf(a,[r(...o)])[0]:null},spectrumAt:async(o,a,l,c,u)=>{await s();let h=n.loaded?.specimen.spectral;if(!h||!await n.loadSpectral(()=>{}))throw new Error("the specimen has no spectral tables");let f=u??kp(h.shortest_nm,h.longest_nm),d=n.spectralEvaluated();if(!d)throw new Error("the specimen has no spectral tables");let m=n.probe.spectrum(d,r(o,a,l,c),n.asks(f));return{wavelengths_nm:f,values:Array.from(m)}}}}},NE=({angles_deg:[i,e,t,n]})=>({wi:Xa(i,e),wo:Xa(t,n)});function DE([i,e,t],n){let[r,,s]=va([i,0,e],n);return[r,s,t]}var p1=new Map;function FE(i){let e=p1.get(i.label);if(!e){let t=ch(i,[380,780],401).weights.reduce((n,r)=>n.map((s,o)=>s+r[o]),[0,0,0]);p1.set(i.label,e=t)}return e}var sc=[];addEventListener("error",i=>sc.push(i.message));addEventListener("unhandledrejection",i=>sc.push(String(i.reason)));function vm(i){let[e,t]=i instanceof ks?["This page cannot draw here",`${i.message} Try another browser, or switch on hardware acceleration.`]:i instanceof gi?["The atlas cannot be shown",i.message]:["Something went wrong",String(i)];sc.push(`${e}: ${t}`),document.querySelector(".fault")?.remove(),document.body.append(Me("div",{className:"fault",role:"alert"},Me("div",{},Me("h2",{},e),Me("p",{},t))))}Zv();var UE=document.getElementById("app")??document.body;try{let i=new Yh(UE,Gg(document),vm),e=i.start().catch(t=>{throw vm(t),t});e.catch(()=>{}),Object.assign(window,{atlasViewer:i.api(e,sc)})}catch(i){vm(i);let e=Promise.reject(i);e.catch(()=>{}),Object.assign(window,{atlasViewer:{ready:e,errors:sc}})}})();
/*! Bundled license information:

three/build/three.core.js:
three/build/three.module.js:
  (**
   * @license
   * Copyright 2010-2026 Three.js Authors
   * SPDX-License-Identifier: MIT
   *)

three/examples/jsm/libs/fflate.module.js:
  (*!
  fflate - fast JavaScript compression/decompression
  <https://101arrowz.github.io/fflate>
  Licensed under MIT. https://github.com/101arrowz/fflate/blob/master/LICENSE
  version 0.8.3
  *)
*/
/*
This page contains:

three

The MIT License

Copyright © 2010-2026 three.js authors

Permission is hereby granted, free of charge, to any person obtaining a copy
of this software and associated documentation files (the "Software"), to deal
in the Software without restriction, including without limitation the rights
to use, copy, modify, merge, publish, distribute, sublicense, and/or sell
copies of the Software, and to permit persons to whom the Software is
furnished to do so, subject to the following conditions:

The above copyright notice and this permission notice shall be included in
all copies or substantial portions of the Software.

THE SOFTWARE IS PROVIDED "AS IS", WITHOUT WARRANTY OF ANY KIND, EXPRESS OR
IMPLIED, INCLUDING BUT NOT LIMITED TO THE WARRANTIES OF MERCHANTABILITY,
FITNESS FOR A PARTICULAR PURPOSE AND NONINFRINGEMENT. IN NO EVENT SHALL THE
AUTHORS OR COPYRIGHT HOLDERS BE LIABLE FOR ANY CLAIM, DAMAGES OR OTHER
LIABILITY, WHETHER IN AN ACTION OF CONTRACT, TORT OR OTHERWISE, ARISING FROM,
OUT OF OR IN CONNECTION WITH THE SOFTWARE OR THE USE OR OTHER DEALINGS IN
THE SOFTWARE.

----

uplot

The MIT License (MIT)

Copyright (c) 2022 Leon Sorokin

Permission is hereby granted, free of charge, to any person obtaining a copy
of this software and associated documentation files (the "Software"), to deal
in the Software without restriction, including without limitation the rights
to use, copy, modify, merge, publish, distribute, sublicense, and/or sell
copies of the Software, and to permit persons to whom the Software is
furnished to do so, subject to the following conditions:

The above copyright notice and this permission notice shall be included in
all copies or substantial portions of the Software.

THE SOFTWARE IS PROVIDED "AS IS", WITHOUT WARRANTY OF ANY KIND, EXPRESS OR
IMPLIED, INCLUDING BUT NOT LIMITED TO THE WARRANTIES OF MERCHANTABILITY,
FITNESS FOR A PARTICULAR PURPOSE AND NONINFRINGEMENT. IN NO EVENT SHALL THE
AUTHORS OR COPYRIGHT HOLDERS BE LIABLE FOR ANY CLAIM, DAMAGES OR OTHER
LIABILITY, WHETHER IN AN ACTION OF CONTRACT, TORT OR OTHERWISE, ARISING FROM,
OUT OF OR IN CONNECTION WITH THE SOFTWARE OR THE USE OR OTHER DEALINGS IN
THE SOFTWARE.

----

fflate, as three carries it

Copyright (c) 2020 Arjun Barrett

Permission is hereby granted, free of charge, to any person obtaining a copy
of this software and associated documentation files (the "Software"), to deal
in the Software without restriction, including without limitation the rights
to use, copy, modify, merge, publish, distribute, sublicense, and/or sell
copies of the Software, and to permit persons to whom the Software is
furnished to do so, subject to the following conditions:

The above copyright notice and this permission notice shall be included in
all copies or substantial portions of the Software.

THE SOFTWARE IS PROVIDED "AS IS", WITHOUT WARRANTY OF ANY KIND, EXPRESS OR
IMPLIED, INCLUDING BUT NOT LIMITED TO THE WARRANTIES OF MERCHANTABILITY,
FITNESS FOR A PARTICULAR PURPOSE AND NONINFRINGEMENT. IN NO EVENT SHALL THE
AUTHORS OR COPYRIGHT HOLDERS BE LIABLE FOR ANY CLAIM, DAMAGES OR OTHER
LIABILITY, WHETHER IN AN ACTION OF CONTRACT, TORT OR OTHERWISE, ARISING FROM,
OUT OF OR IN CONNECTION WITH THE SOFTWARE OR THE USE OR OTHER DEALINGS IN
THE SOFTWARE.
*/
