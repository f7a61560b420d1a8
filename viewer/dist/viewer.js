"use strict";(()=>{var wr=Math.PI/180;function hu(i,e){let t=Math.sin(i*wr);return[t*Math.cos(e*wr),t*Math.sin(e*wr),Math.cos(i*wr)]}function fu([i,e,t]){let n=Math.atan2(e,i)/wr;return{theta_deg:Math.atan2(Math.hypot(i,e),t)/wr,phi_deg:n<0?n+360:n}}var vd=0,ku=1,yd=2;var Wa=1,bd=2,Yr=3,Fs=0,Vn=1,Hi=2,er=0,$r=1,Vu=2,Gu=3,Hu=4,Sd=5;var tr=100,Md=101,wd=102,Td=103,Ad=104,Ed=200,Rd=201,Cd=202,Pd=203,Wu=204,Xu=205,Id=206,Ld=207,Dd=208,Nd=209,Fd=210,Ud=211,Od=212,Bd=213,zd=214,Zo=0,Jo=1,Ko=2,zr=3,Qo=4,jo=5,el=6,tl=7,qu=0,kd=1,Vd=2,Wi=0,Yu=1,$u=2,Zu=3,Ju=4,Ku=5,Qu=6,ju=7;var eh=300,nr=301,Zr=302,Al=303,El=304,nl=1e3,ci=1001,il=1002,Mt=1003,Gd=1004;var Xa=1005;var An=1006,Rl=1007;var hs=1008;var ni=1009,th=1010,nh=1011,Jr=1012,Cl=1013,Ai=1014,Nt=1015,Ln=1016,Pl=1017,Il=1018,ir=1020,ih=35902,sh=35899,rh=1021,ah=1022,cn=1023,us=1026,fs=1027,oh=1028,Ll=1029,Xi=1030,Dl=1031;var Nl=1033,qa=33776,Ya=33777,$a=33778,Za=33779,Fl=35840,Ul=35841,Ol=35842,Bl=35843,zl=36196,kl=37492,Vl=37496,Gl=37488,Hl=37489,Ja=37490,Wl=37491,Xl=37808,ql=37809,Yl=37810,$l=37811,Zl=37812,Jl=37813,Kl=37814,Ql=37815,jl=37816,ec=37817,tc=37818,nc=37819,ic=37820,sc=37821,rc=36492,ac=36494,oc=36495,lc=36283,cc=36284,Ka=36285,uc=36286;var Pa=2300,sl=2301,Yo=2302,Nu=2303,Fu=2400,Uu=2401,Ou=2402;var Hd=3200;var lh=0,Wd=1,ds="",jn="srgb",Ia="srgb-linear",La="linear",Tt="srgb";var $o=7680;var Xd=519,qd=512,Yd=513,$d=514,ch=515,Zd=516,Jd=517,uh=518,hh=519,Kd=35044;var Qa="300 es",ui=2e3,Da=2001;function Gg(i){for(let e=i.length-1;e>=0;--e)if(i[e]>=65535)return!0;return!1}function Hg(i){return ArrayBuffer.isView(i)&&!(i instanceof DataView)}function Na(i){return document.createElementNS("http://www.w3.org/1999/xhtml",i)}function Qd(){let i=Na("canvas");return i.style.display="block",i}var Qf={},kr=null;function fh(...i){let e="THREE."+i.shift();kr?kr("log",e,...i):console.log(e,...i)}function jd(i){let e=i[0];if(typeof e=="string"&&e.startsWith("TSL:")){let t=i[1];t&&t.isStackTrace?i[0]+=" "+t.getLocation():i[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return i}function $e(...i){i=jd(i);let e="THREE."+i.shift();if(kr)kr("warn",e,...i);else{let t=i[0];t&&t.isStackTrace?console.warn(t.getError(e)):console.warn(e,...i)}}function Qe(...i){i=jd(i);let e="THREE."+i.shift();if(kr)kr("error",e,...i);else{let t=i[0];t&&t.isStackTrace?console.error(t.getError(e)):console.error(e,...i)}}function Ca(...i){let e=i.join(" ");e in Qf||(Qf[e]=!0,$e(...i))}function ep(i,e,t){return new Promise(function(n,s){function r(){switch(i.clientWaitSync(e,i.SYNC_FLUSH_COMMANDS_BIT,0)){case i.WAIT_FAILED:s();break;case i.TIMEOUT_EXPIRED:setTimeout(r,t);break;default:n()}}setTimeout(r,t)})}var tp={[Zo]:Zo,[Ko]:el,[Qo]:Qo,[zr]:jo,[Jo]:Jo,[el]:Ko,[tl]:tl,[jo]:zr},ki=class{addEventListener(e,t){this._listeners===void 0&&(this._listeners={});let n=this._listeners;n[e]===void 0&&(n[e]=[]),n[e].indexOf(t)===-1&&n[e].push(t)}hasEventListener(e,t){let n=this._listeners;return n===void 0?!1:n[e]!==void 0&&n[e].indexOf(t)!==-1}removeEventListener(e,t){let n=this._listeners;if(n===void 0)return;let s=n[e];if(s!==void 0){let r=s.indexOf(t);r!==-1&&s.splice(r,1)}}dispatchEvent(e){let t=this._listeners;if(t===void 0)return;let n=t[e.type];if(n!==void 0){e.target=this;let s=n.slice(0);for(let r=0,a=s.length;r<a;r++)s[r].call(this,e);e.target=null}}},Pn=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"];var du=Math.PI/180,rl=180/Math.PI;function ja(){let i=Math.random()*4294967295|0,e=Math.random()*4294967295|0,t=Math.random()*4294967295|0,n=Math.random()*4294967295|0;return(Pn[i&255]+Pn[i>>8&255]+Pn[i>>16&255]+Pn[i>>24&255]+"-"+Pn[e&255]+Pn[e>>8&255]+"-"+Pn[e>>16&15|64]+Pn[e>>24&255]+"-"+Pn[t&63|128]+Pn[t>>8&255]+"-"+Pn[t>>16&255]+Pn[t>>24&255]+Pn[n&255]+Pn[n>>8&255]+Pn[n>>16&255]+Pn[n>>24&255]).toLowerCase()}function _t(i,e,t){return Math.max(e,Math.min(t,i))}function Wg(i,e){return(i%e+e)%e}function pu(i,e,t){return(1-t)*i+t*e}function np(i){return Math.pow(2,Math.floor(Math.log(i)/Math.LN2))}function dh(i){switch(i.constructor){case Uint32Array:return 4294967295;case Uint16Array:return 65535;case Uint8Array:case Uint8ClampedArray:return 255;case Int32Array:return 2147483647;case Int16Array:return 32767;case Int8Array:return 127;default:return}}function Xg(i,e){if(e.constructor===Float32Array)return i;let t=dh(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.max(i/t,-1)}function qg(i,e){if(e.constructor===Float32Array)return i;let t=dh(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.round(i*t)}var ct=class{static{this.prototype.isVector2=!0}constructor(e=0,t=0){this.x=e,this.y=t}get width(){return this.x}set width(e){this.x=e}get height(){return this.y}set height(e){this.y=e}set(e,t){return this.x=e,this.y=t,this}setScalar(e){return this.x=e,this.y=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;default:throw new Error("THREE.Vector2: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;default:throw new Error("THREE.Vector2: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y)}copy(e){return this.x=e.x,this.y=e.y,this}add(e){return this.x+=e.x,this.y+=e.y,this}addScalar(e){return this.x+=e,this.y+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this}subScalar(e){return this.x-=e,this.y-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this}multiply(e){return this.x*=e.x,this.y*=e.y,this}multiplyScalar(e){return this.x*=e,this.y*=e,this}divide(e){return this.x/=e.x,this.y/=e.y,this}divideScalar(e){return this.multiplyScalar(1/e)}applyMatrix3(e){let t=this.x,n=this.y,s=e.elements;return this.x=s[0]*t+s[3]*n+s[6],this.y=s[1]*t+s[4]*n+s[7],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this}clamp(e,t){return this.x=_t(this.x,e.x,t.x),this.y=_t(this.y,e.y,t.y),this}clampScalar(e,t){return this.x=_t(this.x,e,t),this.y=_t(this.y,e,t),this}clampLength(e,t){let n=this.length();return this.divideScalar(n||1).multiplyScalar(_t(n,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(e){return this.x*e.x+this.y*e.y}cross(e){return this.x*e.y-this.y*e.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let n=this.dot(e)/t;return Math.acos(_t(n,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,n=this.y-e.y;return t*t+n*n}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this}lerpVectors(e,t,n){return this.x=e.x+(t.x-e.x)*n,this.y=e.y+(t.y-e.y)*n,this}equals(e){return e.x===this.x&&e.y===this.y}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this}rotateAround(e,t){let n=Math.cos(t),s=Math.sin(t),r=this.x-e.x,a=this.y-e.y;return this.x=r*n-a*s+e.x,this.y=r*s+a*n+e.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}},Vi=class{constructor(e=0,t=0,n=0,s=1){this.isQuaternion=!0,this._x=e,this._y=t,this._z=n,this._w=s}static slerpFlat(e,t,n,s,r,a,o){let l=n[s+0],c=n[s+1],u=n[s+2],f=n[s+3],h=r[a+0],d=r[a+1],g=r[a+2],b=r[a+3];if(f!==b||l!==h||c!==d||u!==g){let m=l*h+c*d+u*g+f*b;m<0&&(h=-h,d=-d,g=-g,b=-b,m=-m);let p=1-o;if(m<.9995){let v=Math.acos(m),E=Math.sin(v);p=Math.sin(p*v)/E,o=Math.sin(o*v)/E,l=l*p+h*o,c=c*p+d*o,u=u*p+g*o,f=f*p+b*o}else{l=l*p+h*o,c=c*p+d*o,u=u*p+g*o,f=f*p+b*o;let v=1/Math.sqrt(l*l+c*c+u*u+f*f);l*=v,c*=v,u*=v,f*=v}}e[t]=l,e[t+1]=c,e[t+2]=u,e[t+3]=f}static multiplyQuaternionsFlat(e,t,n,s,r,a){let o=n[s],l=n[s+1],c=n[s+2],u=n[s+3],f=r[a],h=r[a+1],d=r[a+2],g=r[a+3];return e[t]=o*g+u*f+l*d-c*h,e[t+1]=l*g+u*h+c*f-o*d,e[t+2]=c*g+u*d+o*h-l*f,e[t+3]=u*g-o*f-l*h-c*d,e}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get w(){return this._w}set w(e){this._w=e,this._onChangeCallback()}set(e,t,n,s){return this._x=e,this._y=t,this._z=n,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(e){return this._x=e.x,this._y=e.y,this._z=e.z,this._w=e.w,this._onChangeCallback(),this}setFromEuler(e,t=!0){let n=e._x,s=e._y,r=e._z,a=e._order,o=Math.cos,l=Math.sin,c=o(n/2),u=o(s/2),f=o(r/2),h=l(n/2),d=l(s/2),g=l(r/2);switch(a){case"XYZ":this._x=h*u*f+c*d*g,this._y=c*d*f-h*u*g,this._z=c*u*g+h*d*f,this._w=c*u*f-h*d*g;break;case"YXZ":this._x=h*u*f+c*d*g,this._y=c*d*f-h*u*g,this._z=c*u*g-h*d*f,this._w=c*u*f+h*d*g;break;case"ZXY":this._x=h*u*f-c*d*g,this._y=c*d*f+h*u*g,this._z=c*u*g+h*d*f,this._w=c*u*f-h*d*g;break;case"ZYX":this._x=h*u*f-c*d*g,this._y=c*d*f+h*u*g,this._z=c*u*g-h*d*f,this._w=c*u*f+h*d*g;break;case"YZX":this._x=h*u*f+c*d*g,this._y=c*d*f+h*u*g,this._z=c*u*g-h*d*f,this._w=c*u*f-h*d*g;break;case"XZY":this._x=h*u*f-c*d*g,this._y=c*d*f-h*u*g,this._z=c*u*g+h*d*f,this._w=c*u*f+h*d*g;break;default:$e("Quaternion: .setFromEuler() encountered an unknown order: "+a)}return t===!0&&this._onChangeCallback(),this}setFromAxisAngle(e,t){let n=t/2,s=Math.sin(n);return this._x=e.x*s,this._y=e.y*s,this._z=e.z*s,this._w=Math.cos(n),this._onChangeCallback(),this}setFromRotationMatrix(e){let t=e.elements,n=t[0],s=t[4],r=t[8],a=t[1],o=t[5],l=t[9],c=t[2],u=t[6],f=t[10],h=n+o+f;if(h>0){let d=.5/Math.sqrt(h+1);this._w=.25/d,this._x=(u-l)*d,this._y=(r-c)*d,this._z=(a-s)*d}else if(n>o&&n>f){let d=2*Math.sqrt(1+n-o-f);this._w=(u-l)/d,this._x=.25*d,this._y=(s+a)/d,this._z=(r+c)/d}else if(o>f){let d=2*Math.sqrt(1+o-n-f);this._w=(r-c)/d,this._x=(s+a)/d,this._y=.25*d,this._z=(l+u)/d}else{let d=2*Math.sqrt(1+f-n-o);this._w=(a-s)/d,this._x=(r+c)/d,this._y=(l+u)/d,this._z=.25*d}return this._onChangeCallback(),this}setFromUnitVectors(e,t){let n=e.dot(t)+1;return n<1e-8?(n=0,Math.abs(e.x)>Math.abs(e.z)?(this._x=-e.y,this._y=e.x,this._z=0,this._w=n):(this._x=0,this._y=-e.z,this._z=e.y,this._w=n)):(this._x=e.y*t.z-e.z*t.y,this._y=e.z*t.x-e.x*t.z,this._z=e.x*t.y-e.y*t.x,this._w=n),this.normalize()}angleTo(e){return 2*Math.acos(Math.abs(_t(this.dot(e),-1,1)))}rotateTowards(e,t){let n=this.angleTo(e);if(n===0)return this;let s=Math.min(1,t/n);return this.slerp(e,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(e){return this._x*e._x+this._y*e._y+this._z*e._z+this._w*e._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let e=this.length();return e===0?(this._x=0,this._y=0,this._z=0,this._w=1):(e=1/e,this._x=this._x*e,this._y=this._y*e,this._z=this._z*e,this._w=this._w*e),this._onChangeCallback(),this}multiply(e){return this.multiplyQuaternions(this,e)}premultiply(e){return this.multiplyQuaternions(e,this)}multiplyQuaternions(e,t){let n=e._x,s=e._y,r=e._z,a=e._w,o=t._x,l=t._y,c=t._z,u=t._w;return this._x=n*u+a*o+s*c-r*l,this._y=s*u+a*l+r*o-n*c,this._z=r*u+a*c+n*l-s*o,this._w=a*u-n*o-s*l-r*c,this._onChangeCallback(),this}slerp(e,t){let n=e._x,s=e._y,r=e._z,a=e._w,o=this.dot(e);o<0&&(n=-n,s=-s,r=-r,a=-a,o=-o);let l=1-t;if(o<.9995){let c=Math.acos(o),u=Math.sin(c);l=Math.sin(l*c)/u,t=Math.sin(t*c)/u,this._x=this._x*l+n*t,this._y=this._y*l+s*t,this._z=this._z*l+r*t,this._w=this._w*l+a*t,this._onChangeCallback()}else this._x=this._x*l+n*t,this._y=this._y*l+s*t,this._z=this._z*l+r*t,this._w=this._w*l+a*t,this.normalize();return this}slerpQuaternions(e,t,n){return this.copy(e).slerp(t,n)}random(){let e=2*Math.PI*Math.random(),t=2*Math.PI*Math.random(),n=Math.random(),s=Math.sqrt(1-n),r=Math.sqrt(n);return this.set(s*Math.sin(e),s*Math.cos(e),r*Math.sin(t),r*Math.cos(t))}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._w===this._w}fromArray(e,t=0){return this._x=e[t],this._y=e[t+1],this._z=e[t+2],this._w=e[t+3],this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._w,e}fromBufferAttribute(e,t){return this._x=e.getX(t),this._y=e.getY(t),this._z=e.getZ(t),this._w=e.getW(t),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},Y=class{static{this.prototype.isVector3=!0}constructor(e=0,t=0,n=0){this.x=e,this.y=t,this.z=n}set(e,t,n){return n===void 0&&(n=this.z),this.x=e,this.y=t,this.z=n,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;default:throw new Error("THREE.Vector3: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("THREE.Vector3: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this}multiplyVectors(e,t){return this.x=e.x*t.x,this.y=e.y*t.y,this.z=e.z*t.z,this}applyEuler(e){return this.applyQuaternion(jf.setFromEuler(e))}applyAxisAngle(e,t){return this.applyQuaternion(jf.setFromAxisAngle(e,t))}applyMatrix3(e){let t=this.x,n=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[3]*n+r[6]*s,this.y=r[1]*t+r[4]*n+r[7]*s,this.z=r[2]*t+r[5]*n+r[8]*s,this}applyNormalMatrix(e){return this.applyMatrix3(e).normalize()}applyMatrix4(e){let t=this.x,n=this.y,s=this.z,r=e.elements,a=1/(r[3]*t+r[7]*n+r[11]*s+r[15]);return this.x=(r[0]*t+r[4]*n+r[8]*s+r[12])*a,this.y=(r[1]*t+r[5]*n+r[9]*s+r[13])*a,this.z=(r[2]*t+r[6]*n+r[10]*s+r[14])*a,this}applyQuaternion(e){let t=this.x,n=this.y,s=this.z,r=e.x,a=e.y,o=e.z,l=e.w,c=2*(a*s-o*n),u=2*(o*t-r*s),f=2*(r*n-a*t);return this.x=t+l*c+a*f-o*u,this.y=n+l*u+o*c-r*f,this.z=s+l*f+r*u-a*c,this}project(e){return this.applyMatrix4(e.matrixWorldInverse).applyMatrix4(e.projectionMatrix)}unproject(e){return this.applyMatrix4(e.projectionMatrixInverse).applyMatrix4(e.matrixWorld)}transformDirection(e){let t=this.x,n=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[4]*n+r[8]*s,this.y=r[1]*t+r[5]*n+r[9]*s,this.z=r[2]*t+r[6]*n+r[10]*s,this.normalize()}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this}divideScalar(e){return this.multiplyScalar(1/e)}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this}clamp(e,t){return this.x=_t(this.x,e.x,t.x),this.y=_t(this.y,e.y,t.y),this.z=_t(this.z,e.z,t.z),this}clampScalar(e,t){return this.x=_t(this.x,e,t),this.y=_t(this.y,e,t),this.z=_t(this.z,e,t),this}clampLength(e,t){let n=this.length();return this.divideScalar(n||1).multiplyScalar(_t(n,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this}lerpVectors(e,t,n){return this.x=e.x+(t.x-e.x)*n,this.y=e.y+(t.y-e.y)*n,this.z=e.z+(t.z-e.z)*n,this}cross(e){return this.crossVectors(this,e)}crossVectors(e,t){let n=e.x,s=e.y,r=e.z,a=t.x,o=t.y,l=t.z;return this.x=s*l-r*o,this.y=r*a-n*l,this.z=n*o-s*a,this}projectOnVector(e){let t=e.lengthSq();if(t===0)return this.set(0,0,0);let n=e.dot(this)/t;return this.copy(e).multiplyScalar(n)}projectOnPlane(e){return mu.copy(this).projectOnVector(e),this.sub(mu)}reflect(e){return this.sub(mu.copy(e).multiplyScalar(2*this.dot(e)))}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let n=this.dot(e)/t;return Math.acos(_t(n,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,n=this.y-e.y,s=this.z-e.z;return t*t+n*n+s*s}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)+Math.abs(this.z-e.z)}setFromSpherical(e){return this.setFromSphericalCoords(e.radius,e.phi,e.theta)}setFromSphericalCoords(e,t,n){let s=Math.sin(t)*e;return this.x=s*Math.sin(n),this.y=Math.cos(t)*e,this.z=s*Math.cos(n),this}setFromCylindrical(e){return this.setFromCylindricalCoords(e.radius,e.theta,e.y)}setFromCylindricalCoords(e,t,n){return this.x=e*Math.sin(t),this.y=n,this.z=e*Math.cos(t),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this}setFromMatrixScale(e){let t=this.setFromMatrixColumn(e,0).length(),n=this.setFromMatrixColumn(e,1).length(),s=this.setFromMatrixColumn(e,2).length();return this.x=t,this.y=n,this.z=s,this}setFromMatrixColumn(e,t){return this.fromArray(e.elements,t*4)}setFromMatrix3Column(e,t){return this.fromArray(e.elements,t*3)}setFromEuler(e){return this.x=e._x,this.y=e._y,this.z=e._z,this}setFromColor(e){return this.x=e.r,this.y=e.g,this.z=e.b,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let e=Math.random()*Math.PI*2,t=Math.random()*2-1,n=Math.sqrt(1-t*t);return this.x=n*Math.cos(e),this.y=t,this.z=n*Math.sin(e),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},mu=new Y,jf=new Vi,je=class{static{this.prototype.isMatrix3=!0}constructor(e,t,n,s,r,a,o,l,c){this.elements=[1,0,0,0,1,0,0,0,1],e!==void 0&&this.set(e,t,n,s,r,a,o,l,c)}set(e,t,n,s,r,a,o,l,c){let u=this.elements;return u[0]=e,u[1]=s,u[2]=o,u[3]=t,u[4]=r,u[5]=l,u[6]=n,u[7]=a,u[8]=c,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(e){let t=this.elements,n=e.elements;return t[0]=n[0],t[1]=n[1],t[2]=n[2],t[3]=n[3],t[4]=n[4],t[5]=n[5],t[6]=n[6],t[7]=n[7],t[8]=n[8],this}extractBasis(e,t,n){return e.setFromMatrix3Column(this,0),t.setFromMatrix3Column(this,1),n.setFromMatrix3Column(this,2),this}setFromMatrix4(e){let t=e.elements;return this.set(t[0],t[4],t[8],t[1],t[5],t[9],t[2],t[6],t[10]),this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let n=e.elements,s=t.elements,r=this.elements,a=n[0],o=n[3],l=n[6],c=n[1],u=n[4],f=n[7],h=n[2],d=n[5],g=n[8],b=s[0],m=s[3],p=s[6],v=s[1],E=s[4],S=s[7],R=s[2],A=s[5],x=s[8];return r[0]=a*b+o*v+l*R,r[3]=a*m+o*E+l*A,r[6]=a*p+o*S+l*x,r[1]=c*b+u*v+f*R,r[4]=c*m+u*E+f*A,r[7]=c*p+u*S+f*x,r[2]=h*b+d*v+g*R,r[5]=h*m+d*E+g*A,r[8]=h*p+d*S+g*x,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[3]*=e,t[6]*=e,t[1]*=e,t[4]*=e,t[7]*=e,t[2]*=e,t[5]*=e,t[8]*=e,this}determinant(){let e=this.elements,t=e[0],n=e[1],s=e[2],r=e[3],a=e[4],o=e[5],l=e[6],c=e[7],u=e[8];return t*a*u-t*o*c-n*r*u+n*o*l+s*r*c-s*a*l}invert(){let e=this.elements,t=e[0],n=e[1],s=e[2],r=e[3],a=e[4],o=e[5],l=e[6],c=e[7],u=e[8],f=u*a-o*c,h=o*l-u*r,d=c*r-a*l,g=t*f+n*h+s*d;if(g===0)return this.set(0,0,0,0,0,0,0,0,0);let b=1/g;return e[0]=f*b,e[1]=(s*c-u*n)*b,e[2]=(o*n-s*a)*b,e[3]=h*b,e[4]=(u*t-s*l)*b,e[5]=(s*r-o*t)*b,e[6]=d*b,e[7]=(n*l-c*t)*b,e[8]=(a*t-n*r)*b,this}transpose(){let e,t=this.elements;return e=t[1],t[1]=t[3],t[3]=e,e=t[2],t[2]=t[6],t[6]=e,e=t[5],t[5]=t[7],t[7]=e,this}getNormalMatrix(e){return this.setFromMatrix4(e).invert().transpose()}transposeIntoArray(e){let t=this.elements;return e[0]=t[0],e[1]=t[3],e[2]=t[6],e[3]=t[1],e[4]=t[4],e[5]=t[7],e[6]=t[2],e[7]=t[5],e[8]=t[8],this}setUvTransform(e,t,n,s,r,a,o){let l=Math.cos(r),c=Math.sin(r);return this.set(n*l,n*c,-n*(l*a+c*o)+a+e,-s*c,s*l,-s*(-c*a+l*o)+o+t,0,0,1),this}scale(e,t){return Ca("Matrix3: .scale() is deprecated. Use .makeScale() instead."),this.premultiply(gu.makeScale(e,t)),this}rotate(e){return Ca("Matrix3: .rotate() is deprecated. Use .makeRotation() instead."),this.premultiply(gu.makeRotation(-e)),this}translate(e,t){return Ca("Matrix3: .translate() is deprecated. Use .makeTranslation() instead."),this.premultiply(gu.makeTranslation(e,t)),this}makeTranslation(e,t){return e.isVector2?this.set(1,0,e.x,0,1,e.y,0,0,1):this.set(1,0,e,0,1,t,0,0,1),this}makeRotation(e){let t=Math.cos(e),n=Math.sin(e);return this.set(t,-n,0,n,t,0,0,0,1),this}makeScale(e,t){return this.set(e,0,0,0,t,0,0,0,1),this}equals(e){let t=this.elements,n=e.elements;for(let s=0;s<9;s++)if(t[s]!==n[s])return!1;return!0}fromArray(e,t=0){for(let n=0;n<9;n++)this.elements[n]=e[n+t];return this}toArray(e=[],t=0){let n=this.elements;return e[t]=n[0],e[t+1]=n[1],e[t+2]=n[2],e[t+3]=n[3],e[t+4]=n[4],e[t+5]=n[5],e[t+6]=n[6],e[t+7]=n[7],e[t+8]=n[8],e}clone(){return new this.constructor().fromArray(this.elements)}},gu=new je,ed=new je().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),td=new je().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function Yg(){let i={enabled:!0,workingColorSpace:Ia,spaces:{},convert:function(s,r,a){return this.enabled===!1||r===a||!r||!a||(this.spaces[r].transfer===Tt&&(s.r=cs(s.r),s.g=cs(s.g),s.b=cs(s.b)),this.spaces[r].primaries!==this.spaces[a].primaries&&(s.applyMatrix3(this.spaces[r].toXYZ),s.applyMatrix3(this.spaces[a].fromXYZ)),this.spaces[a].transfer===Tt&&(s.r=Br(s.r),s.g=Br(s.g),s.b=Br(s.b))),s},workingToColorSpace:function(s,r){return this.convert(s,this.workingColorSpace,r)},colorSpaceToWorking:function(s,r){return this.convert(s,r,this.workingColorSpace)},getPrimaries:function(s){return this.spaces[s].primaries},getTransfer:function(s){return s===ds?La:this.spaces[s].transfer},getToneMappingMode:function(s){return this.spaces[s].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(s,r=this.workingColorSpace){return s.fromArray(this.spaces[r].luminanceCoefficients)},define:function(s){Object.assign(this.spaces,s)},_getMatrix:function(s,r,a){return s.copy(this.spaces[a].fromXYZ).multiply(this.spaces[r].toXYZ)},_getDrawingBufferColorSpace:function(s){return this.spaces[s].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(s=this.workingColorSpace){return this.spaces[s].workingColorSpaceConfig.unpackColorSpace}},e=[.64,.33,.3,.6,.15,.06],t=[.2126,.7152,.0722],n=[.3127,.329];return i.define({[Ia]:{primaries:e,whitePoint:n,transfer:La,toXYZ:ed,fromXYZ:td,luminanceCoefficients:t,workingColorSpaceConfig:{unpackColorSpace:jn},outputColorSpaceConfig:{drawingBufferColorSpace:jn}},[jn]:{primaries:e,whitePoint:n,transfer:Tt,toXYZ:ed,fromXYZ:td,luminanceCoefficients:t,outputColorSpaceConfig:{drawingBufferColorSpace:jn}}}),i}var mt=Yg();function cs(i){return i<.04045?i*.0773993808:Math.pow(i*.9478672986+.0521327014,2.4)}function Br(i){return i<.0031308?i*12.92:1.055*Math.pow(i,.41666)-.055}var Tr,al=class{static getDataURL(e,t="image/png"){if(/^data:/i.test(e.src)||typeof HTMLCanvasElement>"u")return e.src;let n;if(e instanceof HTMLCanvasElement)n=e;else{Tr===void 0&&(Tr=Na("canvas")),Tr.width=e.width,Tr.height=e.height;let s=Tr.getContext("2d");e instanceof ImageData?s.putImageData(e,0,0):s.drawImage(e,0,0,e.width,e.height),n=Tr}return n.toDataURL(t)}static sRGBToLinear(e){if(typeof HTMLImageElement<"u"&&e instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&e instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&e instanceof ImageBitmap){let t=Na("canvas");t.width=e.width,t.height=e.height;let n=t.getContext("2d");n.drawImage(e,0,0,e.width,e.height);let s=n.getImageData(0,0,e.width,e.height),r=s.data;for(let a=0;a<r.length;a++)r[a]=cs(r[a]/255)*255;return n.putImageData(s,0,0),t}else if(e.data){let t=e.data.slice(0);for(let n=0;n<t.length;n++)t instanceof Uint8Array||t instanceof Uint8ClampedArray?t[n]=Math.floor(cs(t[n]/255)*255):t[n]=cs(t[n]);return{data:t,width:e.width,height:e.height}}else return $e("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),e}},$g=0,Vr=class{constructor(e=null){this.isTextureSource=!0,Object.defineProperty(this,"id",{value:$g++}),this.uuid=ja(),this.data=e,this.dataReady=!0,this.version=0}getSize(e){let t=this.data;return typeof HTMLVideoElement<"u"&&t instanceof HTMLVideoElement?e.set(t.videoWidth,t.videoHeight,0):typeof VideoFrame<"u"&&t instanceof VideoFrame?e.set(t.displayWidth,t.displayHeight,0):t!==null?e.set(t.width||0,t.height||0,t.depth||0):e.set(0,0,0),e}set needsUpdate(e){e===!0&&this.version++}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.images[this.uuid]!==void 0)return e.images[this.uuid];let n={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let a=0,o=s.length;a<o;a++)s[a].isDataTexture?r.push(_u(s[a].image)):r.push(_u(s[a]))}else r=_u(s);n.url=r}return t||(e.images[this.uuid]=n),n}};function _u(i){return typeof HTMLImageElement<"u"&&i instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&i instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&i instanceof ImageBitmap?al.getDataURL(i):i.data?{data:Array.from(i.data),width:i.width,height:i.height,type:i.data.constructor.name}:($e("Texture: Unable to serialize Texture."),{})}var Zg=0,xu=new Y,Hn=class i extends ki{constructor(e=i.DEFAULT_IMAGE,t=i.DEFAULT_MAPPING,n=ci,s=ci,r=An,a=hs,o=cn,l=ni,c=i.DEFAULT_ANISOTROPY,u=ds){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:Zg++}),this.uuid=ja(),this.name="",this.source=new Vr(e),this.mipmaps=[],this.mapping=t,this.channel=0,this.wrapS=n,this.wrapT=s,this.magFilter=r,this.minFilter=a,this.anisotropy=c,this.format=o,this.internalFormat=null,this.type=l,this.offset=new ct(0,0),this.repeat=new ct(1,1),this.center=new ct(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new je,this.generateMipmaps=!0,this.mipmapsAutoUpdate=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=u,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(e&&e.depth&&e.depth>1),this.pmremVersion=0,this.isPMREMTexture=!1,this.normalized=!1}get width(){return this.source.getSize(xu).x}get height(){return this.source.getSize(xu).y}get depth(){return this.source.getSize(xu).z}get image(){return this.source.data}set image(e){this.source.data=e}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(e){return this.name=e.name,this.source=e.source,this.mipmaps=e.mipmaps.slice(0),this.mapping=e.mapping,this.channel=e.channel,this.wrapS=e.wrapS,this.wrapT=e.wrapT,this.magFilter=e.magFilter,this.minFilter=e.minFilter,this.anisotropy=e.anisotropy,this.format=e.format,this.internalFormat=e.internalFormat,this.type=e.type,this.normalized=e.normalized,this.offset.copy(e.offset),this.repeat.copy(e.repeat),this.center.copy(e.center),this.rotation=e.rotation,this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrix.copy(e.matrix),this.generateMipmaps=e.generateMipmaps,this.mipmapsAutoUpdate=e.mipmapsAutoUpdate,this.premultiplyAlpha=e.premultiplyAlpha,this.flipY=e.flipY,this.unpackAlignment=e.unpackAlignment,this.colorSpace=e.colorSpace,this.renderTarget=e.renderTarget,this.isRenderTargetTexture=e.isRenderTargetTexture,this.isPMREMTexture=e.isPMREMTexture,this.isArrayTexture=e.isArrayTexture,this.userData=JSON.parse(JSON.stringify(e.userData)),this.needsUpdate=!0,this}setValues(e){for(let t in e){let n=e[t];if(n===void 0){$e(`Texture.setValues(): parameter '${t}' has value of undefined.`);continue}let s=this[t];if(s===void 0){$e(`Texture.setValues(): property '${t}' does not exist.`);continue}s&&n&&s.isVector2&&n.isVector2||s&&n&&s.isVector3&&n.isVector3||s&&n&&s.isMatrix3&&n.isMatrix3?s.copy(n):this[t]=n}}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.textures[this.uuid]!==void 0)return e.textures[this.uuid];let n={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(e).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,mipmapsAutoUpdate:this.mipmapsAutoUpdate,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(n.userData=this.userData),t||(e.textures[this.uuid]=n),n}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(e){if(this.mapping!==eh)return e;if(e.applyMatrix3(this.matrix),e.x<0||e.x>1)switch(this.wrapS){case nl:e.x=e.x-Math.floor(e.x);break;case ci:e.x=e.x<0?0:1;break;case il:Math.abs(Math.floor(e.x)%2)===1?e.x=Math.ceil(e.x)-e.x:e.x=e.x-Math.floor(e.x);break}if(e.y<0||e.y>1)switch(this.wrapT){case nl:e.y=e.y-Math.floor(e.y);break;case ci:e.y=e.y<0?0:1;break;case il:Math.abs(Math.floor(e.y)%2)===1?e.y=Math.ceil(e.y)-e.y:e.y=e.y-Math.floor(e.y);break}return this.flipY&&(e.y=1-e.y),e}set needsUpdate(e){e===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(e){e===!0&&this.pmremVersion++}};Hn.DEFAULT_IMAGE=null;Hn.DEFAULT_MAPPING=eh;Hn.DEFAULT_ANISOTROPY=1;var Lt=class{static{this.prototype.isVector4=!0}constructor(e=0,t=0,n=0,s=1){this.x=e,this.y=t,this.z=n,this.w=s}get width(){return this.z}set width(e){this.z=e}get height(){return this.w}set height(e){this.w=e}set(e,t,n,s){return this.x=e,this.y=t,this.z=n,this.w=s,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this.w=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setW(e){return this.w=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;case 3:this.w=t;break;default:throw new Error("THREE.Vector4: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("THREE.Vector4: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this.w=e.w!==void 0?e.w:1,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this.w+=e.w,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this.w+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this.w=e.w+t.w,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this.w+=e.w*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this.w-=e.w,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this.w-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this.w=e.w-t.w,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this.w*=e.w,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this.w*=e,this}applyMatrix4(e){let t=this.x,n=this.y,s=this.z,r=this.w,a=e.elements;return this.x=a[0]*t+a[4]*n+a[8]*s+a[12]*r,this.y=a[1]*t+a[5]*n+a[9]*s+a[13]*r,this.z=a[2]*t+a[6]*n+a[10]*s+a[14]*r,this.w=a[3]*t+a[7]*n+a[11]*s+a[15]*r,this}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this.w/=e.w,this}divideScalar(e){return this.multiplyScalar(1/e)}setAxisAngleFromQuaternion(e){this.w=2*Math.acos(e.w);let t=Math.sqrt(1-e.w*e.w);return t<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=e.x/t,this.y=e.y/t,this.z=e.z/t),this}setAxisAngleFromRotationMatrix(e){let t,n,s,r,l=e.elements,c=l[0],u=l[4],f=l[8],h=l[1],d=l[5],g=l[9],b=l[2],m=l[6],p=l[10];if(Math.abs(u-h)<.01&&Math.abs(f-b)<.01&&Math.abs(g-m)<.01){if(Math.abs(u+h)<.1&&Math.abs(f+b)<.1&&Math.abs(g+m)<.1&&Math.abs(c+d+p-3)<.1)return this.set(1,0,0,0),this;t=Math.PI;let E=(c+1)/2,S=(d+1)/2,R=(p+1)/2,A=(u+h)/4,x=(f+b)/4,T=(g+m)/4;return E>S&&E>R?E<.01?(n=0,s=.707106781,r=.707106781):(n=Math.sqrt(E),s=A/n,r=x/n):S>R?S<.01?(n=.707106781,s=0,r=.707106781):(s=Math.sqrt(S),n=A/s,r=T/s):R<.01?(n=.707106781,s=.707106781,r=0):(r=Math.sqrt(R),n=x/r,s=T/r),this.set(n,s,r,t),this}let v=Math.sqrt((m-g)*(m-g)+(f-b)*(f-b)+(h-u)*(h-u));return Math.abs(v)<.001&&(v=1),this.x=(m-g)/v,this.y=(f-b)/v,this.z=(h-u)/v,this.w=Math.acos((c+d+p-1)/2),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this.w=t[15],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this.w=Math.min(this.w,e.w),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this.w=Math.max(this.w,e.w),this}clamp(e,t){return this.x=_t(this.x,e.x,t.x),this.y=_t(this.y,e.y,t.y),this.z=_t(this.z,e.z,t.z),this.w=_t(this.w,e.w,t.w),this}clampScalar(e,t){return this.x=_t(this.x,e,t),this.y=_t(this.y,e,t),this.z=_t(this.z,e,t),this.w=_t(this.w,e,t),this}clampLength(e,t){let n=this.length();return this.divideScalar(n||1).multiplyScalar(_t(n,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z+this.w*e.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this.w+=(e.w-this.w)*t,this}lerpVectors(e,t,n){return this.x=e.x+(t.x-e.x)*n,this.y=e.y+(t.y-e.y)*n,this.z=e.z+(t.z-e.z)*n,this.w=e.w+(t.w-e.w)*n,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z&&e.w===this.w}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this.w=e[t+3],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e[t+3]=this.w,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this.w=e.getW(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}},ol=class extends ki{constructor(e=1,t=1,n={}){super(),n=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:An,depthBuffer:!0,stencilBuffer:!1,resolveColorBuffer:!0,resolveDepthBuffer:!0,resolveStencilBuffer:!0,storeMultisampledColorBuffer:!0,storeMultisampledDepthBuffer:!0,storeMultisampledStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1,useArrayDepthTexture:!1},n),this.isRenderTarget=!0,this.width=e,this.height=t,this.depth=n.depth,this.scissor=new Lt(0,0,e,t),this.scissorTest=!1,this.viewport=new Lt(0,0,e,t),this.textures=[];let s=n.count;for(let r=0;r<s;r++)this.textures[r]=new Hn({width:e,height:t,depth:n.depth}),this.textures[r].isRenderTargetTexture=!0,this.textures[r].renderTarget=this;this._setTextureOptions(n),this.depthBuffer=n.depthBuffer,this.stencilBuffer=n.stencilBuffer,this.resolveColorBuffer=n.resolveColorBuffer,this.resolveDepthBuffer=n.resolveDepthBuffer,this.resolveStencilBuffer=n.resolveStencilBuffer,this.storeMultisampledColorBuffer=n.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=n.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=n.storeMultisampledStencilBuffer,this._depthTexture=null,this.depthTexture=n.depthTexture,this.samples=n.samples,this.multiview=n.multiview,this.useArrayDepthTexture=n.useArrayDepthTexture}_setTextureOptions(e={}){let t={minFilter:An,generateMipmaps:!1,flipY:!1,internalFormat:null};e.mapping!==void 0&&(t.mapping=e.mapping),e.wrapS!==void 0&&(t.wrapS=e.wrapS),e.wrapT!==void 0&&(t.wrapT=e.wrapT),e.wrapR!==void 0&&(t.wrapR=e.wrapR),e.magFilter!==void 0&&(t.magFilter=e.magFilter),e.minFilter!==void 0&&(t.minFilter=e.minFilter),e.format!==void 0&&(t.format=e.format),e.type!==void 0&&(t.type=e.type),e.anisotropy!==void 0&&(t.anisotropy=e.anisotropy),e.colorSpace!==void 0&&(t.colorSpace=e.colorSpace),e.flipY!==void 0&&(t.flipY=e.flipY),e.generateMipmaps!==void 0&&(t.generateMipmaps=e.generateMipmaps),e.mipmapsAutoUpdate!==void 0&&(t.mipmapsAutoUpdate=e.mipmapsAutoUpdate),e.internalFormat!==void 0&&(t.internalFormat=e.internalFormat);for(let n=0;n<this.textures.length;n++)this.textures[n].setValues(t)}get texture(){return this.textures[0]}set texture(e){this.textures[0]=e}set depthTexture(e){this._depthTexture!==null&&this._depthTexture.renderTarget===this&&(this._depthTexture.renderTarget=null),e!==null&&e.renderTarget===null&&(e.renderTarget=this),this._depthTexture=e}get depthTexture(){return this._depthTexture}setSize(e,t,n=1){if(this.width!==e||this.height!==t||this.depth!==n){this.width=e,this.height=t,this.depth=n;for(let s=0,r=this.textures.length;s<r;s++)this.textures[s].image.width=e,this.textures[s].image.height=t,this.textures[s].image.depth=n,this.textures[s].isData3DTexture!==!0&&(this.textures[s].isArrayTexture=this.textures[s].image.depth>1);this.dispose()}this.viewport.set(0,0,e,t),this.scissor.set(0,0,e,t)}clone(){return new this.constructor().copy(this)}copy(e){this.width=e.width,this.height=e.height,this.depth=e.depth,this.scissor.copy(e.scissor),this.scissorTest=e.scissorTest,this.viewport.copy(e.viewport),this.textures.length=0;for(let t=0,n=e.textures.length;t<n;t++){this.textures[t]=e.textures[t].clone(),this.textures[t].isRenderTargetTexture=!0,this.textures[t].renderTarget=this;let s=Object.assign({},e.textures[t].image);this.textures[t].source=new Vr(s)}if(this.depthBuffer=e.depthBuffer,this.stencilBuffer=e.stencilBuffer,this.resolveColorBuffer=e.resolveColorBuffer,this.resolveDepthBuffer=e.resolveDepthBuffer,this.resolveStencilBuffer=e.resolveStencilBuffer,this.storeMultisampledColorBuffer=e.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=e.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=e.storeMultisampledStencilBuffer,e.depthTexture!==null)if(e.depthTexture.renderTarget===e){let t=e.depthTexture.clone();t.renderTarget=null,this.depthTexture=t}else this.depthTexture=e.depthTexture;else this.depthTexture=null;return this.samples=e.samples,this.multiview=e.multiview,this.useArrayDepthTexture=e.useArrayDepthTexture,this}dispose(){this.dispatchEvent({type:"dispose"})}},wn=class extends ol{constructor(e=1,t=1,n={}){super(e,t,n),this.isWebGLRenderTarget=!0}},Js=class extends Hn{constructor(e=null,t=1,n=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:e,width:t,height:n,depth:s},this.magFilter=Mt,this.minFilter=Mt,this.wrapR=ci,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}addLayerUpdate(e){this.layerUpdates.add(e)}clearLayerUpdates(){this.layerUpdates.clear()}};var ll=class extends Hn{constructor(e=null,t=1,n=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:e,width:t,height:n,depth:s},this.magFilter=Mt,this.minFilter=Mt,this.wrapR=ci,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}};var dt=class i{static{this.prototype.isMatrix4=!0}constructor(e,t,n,s,r,a,o,l,c,u,f,h,d,g,b,m){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],e!==void 0&&this.set(e,t,n,s,r,a,o,l,c,u,f,h,d,g,b,m)}set(e,t,n,s,r,a,o,l,c,u,f,h,d,g,b,m){let p=this.elements;return p[0]=e,p[4]=t,p[8]=n,p[12]=s,p[1]=r,p[5]=a,p[9]=o,p[13]=l,p[2]=c,p[6]=u,p[10]=f,p[14]=h,p[3]=d,p[7]=g,p[11]=b,p[15]=m,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new i().fromArray(this.elements)}copy(e){let t=this.elements,n=e.elements;return t[0]=n[0],t[1]=n[1],t[2]=n[2],t[3]=n[3],t[4]=n[4],t[5]=n[5],t[6]=n[6],t[7]=n[7],t[8]=n[8],t[9]=n[9],t[10]=n[10],t[11]=n[11],t[12]=n[12],t[13]=n[13],t[14]=n[14],t[15]=n[15],this}copyPosition(e){let t=this.elements,n=e.elements;return t[12]=n[12],t[13]=n[13],t[14]=n[14],this}setFromMatrix3(e){let t=e.elements;return this.set(t[0],t[3],t[6],0,t[1],t[4],t[7],0,t[2],t[5],t[8],0,0,0,0,1),this}extractBasis(e,t,n){return this.determinantAffine()===0?(e.set(1,0,0),t.set(0,1,0),n.set(0,0,1),this):(e.setFromMatrixColumn(this,0),t.setFromMatrixColumn(this,1),n.setFromMatrixColumn(this,2),this)}makeBasis(e,t,n){return this.set(e.x,t.x,n.x,0,e.y,t.y,n.y,0,e.z,t.z,n.z,0,0,0,0,1),this}extractRotation(e){if(e.determinantAffine()===0)return this.identity();let t=this.elements,n=e.elements,s=1/Ar.setFromMatrixColumn(e,0).length(),r=1/Ar.setFromMatrixColumn(e,1).length(),a=1/Ar.setFromMatrixColumn(e,2).length();return t[0]=n[0]*s,t[1]=n[1]*s,t[2]=n[2]*s,t[3]=0,t[4]=n[4]*r,t[5]=n[5]*r,t[6]=n[6]*r,t[7]=0,t[8]=n[8]*a,t[9]=n[9]*a,t[10]=n[10]*a,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromEuler(e){let t=this.elements,n=e.x,s=e.y,r=e.z,a=Math.cos(n),o=Math.sin(n),l=Math.cos(s),c=Math.sin(s),u=Math.cos(r),f=Math.sin(r);if(e.order==="XYZ"){let h=a*u,d=a*f,g=o*u,b=o*f;t[0]=l*u,t[4]=-l*f,t[8]=c,t[1]=d+g*c,t[5]=h-b*c,t[9]=-o*l,t[2]=b-h*c,t[6]=g+d*c,t[10]=a*l}else if(e.order==="YXZ"){let h=l*u,d=l*f,g=c*u,b=c*f;t[0]=h+b*o,t[4]=g*o-d,t[8]=a*c,t[1]=a*f,t[5]=a*u,t[9]=-o,t[2]=d*o-g,t[6]=b+h*o,t[10]=a*l}else if(e.order==="ZXY"){let h=l*u,d=l*f,g=c*u,b=c*f;t[0]=h-b*o,t[4]=-a*f,t[8]=g+d*o,t[1]=d+g*o,t[5]=a*u,t[9]=b-h*o,t[2]=-a*c,t[6]=o,t[10]=a*l}else if(e.order==="ZYX"){let h=a*u,d=a*f,g=o*u,b=o*f;t[0]=l*u,t[4]=g*c-d,t[8]=h*c+b,t[1]=l*f,t[5]=b*c+h,t[9]=d*c-g,t[2]=-c,t[6]=o*l,t[10]=a*l}else if(e.order==="YZX"){let h=a*l,d=a*c,g=o*l,b=o*c;t[0]=l*u,t[4]=b-h*f,t[8]=g*f+d,t[1]=f,t[5]=a*u,t[9]=-o*u,t[2]=-c*u,t[6]=d*f+g,t[10]=h-b*f}else if(e.order==="XZY"){let h=a*l,d=a*c,g=o*l,b=o*c;t[0]=l*u,t[4]=-f,t[8]=c*u,t[1]=h*f+b,t[5]=a*u,t[9]=d*f-g,t[2]=g*f-d,t[6]=o*u,t[10]=b*f+h}return t[3]=0,t[7]=0,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromQuaternion(e){return this.compose(Jg,e,Kg)}lookAt(e,t,n){let s=this.elements;return Kn.subVectors(e,t),Kn.lengthSq()===0&&(Kn.z=1),Kn.normalize(),ws.crossVectors(n,Kn),ws.lengthSq()===0&&(Math.abs(n.z)===1?Kn.x+=1e-4:Kn.z+=1e-4,Kn.normalize(),ws.crossVectors(n,Kn)),ws.normalize(),Eo.crossVectors(Kn,ws),s[0]=ws.x,s[4]=Eo.x,s[8]=Kn.x,s[1]=ws.y,s[5]=Eo.y,s[9]=Kn.y,s[2]=ws.z,s[6]=Eo.z,s[10]=Kn.z,this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let n=e.elements,s=t.elements,r=this.elements,a=n[0],o=n[4],l=n[8],c=n[12],u=n[1],f=n[5],h=n[9],d=n[13],g=n[2],b=n[6],m=n[10],p=n[14],v=n[3],E=n[7],S=n[11],R=n[15],A=s[0],x=s[4],T=s[8],k=s[12],N=s[1],L=s[5],G=s[9],H=s[13],D=s[2],V=s[6],Z=s[10],z=s[14],le=s[3],J=s[7],Q=s[11],ie=s[15];return r[0]=a*A+o*N+l*D+c*le,r[4]=a*x+o*L+l*V+c*J,r[8]=a*T+o*G+l*Z+c*Q,r[12]=a*k+o*H+l*z+c*ie,r[1]=u*A+f*N+h*D+d*le,r[5]=u*x+f*L+h*V+d*J,r[9]=u*T+f*G+h*Z+d*Q,r[13]=u*k+f*H+h*z+d*ie,r[2]=g*A+b*N+m*D+p*le,r[6]=g*x+b*L+m*V+p*J,r[10]=g*T+b*G+m*Z+p*Q,r[14]=g*k+b*H+m*z+p*ie,r[3]=v*A+E*N+S*D+R*le,r[7]=v*x+E*L+S*V+R*J,r[11]=v*T+E*G+S*Z+R*Q,r[15]=v*k+E*H+S*z+R*ie,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[4]*=e,t[8]*=e,t[12]*=e,t[1]*=e,t[5]*=e,t[9]*=e,t[13]*=e,t[2]*=e,t[6]*=e,t[10]*=e,t[14]*=e,t[3]*=e,t[7]*=e,t[11]*=e,t[15]*=e,this}determinant(){let e=this.elements,t=e[0],n=e[4],s=e[8],r=e[12],a=e[1],o=e[5],l=e[9],c=e[13],u=e[2],f=e[6],h=e[10],d=e[14],g=e[3],b=e[7],m=e[11],p=e[15],v=l*d-c*h,E=o*d-c*f,S=o*h-l*f,R=a*d-c*u,A=a*h-l*u,x=a*f-o*u;return t*(b*v-m*E+p*S)-n*(g*v-m*R+p*A)+s*(g*E-b*R+p*x)-r*(g*S-b*A+m*x)}determinantAffine(){let e=this.elements,t=e[0],n=e[4],s=e[8],r=e[1],a=e[5],o=e[9],l=e[2],c=e[6],u=e[10];return t*(a*u-o*c)-n*(r*u-o*l)+s*(r*c-a*l)}transpose(){let e=this.elements,t;return t=e[1],e[1]=e[4],e[4]=t,t=e[2],e[2]=e[8],e[8]=t,t=e[6],e[6]=e[9],e[9]=t,t=e[3],e[3]=e[12],e[12]=t,t=e[7],e[7]=e[13],e[13]=t,t=e[11],e[11]=e[14],e[14]=t,this}setPosition(e,t,n){let s=this.elements;return e.isVector3?(s[12]=e.x,s[13]=e.y,s[14]=e.z):(s[12]=e,s[13]=t,s[14]=n),this}invert(){let e=this.elements,t=e[0],n=e[1],s=e[2],r=e[3],a=e[4],o=e[5],l=e[6],c=e[7],u=e[8],f=e[9],h=e[10],d=e[11],g=e[12],b=e[13],m=e[14],p=e[15],v=t*o-n*a,E=t*l-s*a,S=t*c-r*a,R=n*l-s*o,A=n*c-r*o,x=s*c-r*l,T=u*b-f*g,k=u*m-h*g,N=u*p-d*g,L=f*m-h*b,G=f*p-d*b,H=h*p-d*m,D=v*H-E*G+S*L+R*N-A*k+x*T;if(D===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let V=1/D;return e[0]=(o*H-l*G+c*L)*V,e[1]=(s*G-n*H-r*L)*V,e[2]=(b*x-m*A+p*R)*V,e[3]=(h*A-f*x-d*R)*V,e[4]=(l*N-a*H-c*k)*V,e[5]=(t*H-s*N+r*k)*V,e[6]=(m*S-g*x-p*E)*V,e[7]=(u*x-h*S+d*E)*V,e[8]=(a*G-o*N+c*T)*V,e[9]=(n*N-t*G-r*T)*V,e[10]=(g*A-b*S+p*v)*V,e[11]=(f*S-u*A-d*v)*V,e[12]=(o*k-a*L-l*T)*V,e[13]=(t*L-n*k+s*T)*V,e[14]=(b*E-g*R-m*v)*V,e[15]=(u*R-f*E+h*v)*V,this}scale(e){let t=this.elements,n=e.x,s=e.y,r=e.z;return t[0]*=n,t[4]*=s,t[8]*=r,t[1]*=n,t[5]*=s,t[9]*=r,t[2]*=n,t[6]*=s,t[10]*=r,t[3]*=n,t[7]*=s,t[11]*=r,this}getMaxScaleOnAxis(){let e=this.elements,t=e[0]*e[0]+e[1]*e[1]+e[2]*e[2],n=e[4]*e[4]+e[5]*e[5]+e[6]*e[6],s=e[8]*e[8]+e[9]*e[9]+e[10]*e[10];return Math.sqrt(Math.max(t,n,s))}makeTranslation(e,t,n){return e.isVector3?this.set(1,0,0,e.x,0,1,0,e.y,0,0,1,e.z,0,0,0,1):this.set(1,0,0,e,0,1,0,t,0,0,1,n,0,0,0,1),this}makeRotationX(e){let t=Math.cos(e),n=Math.sin(e);return this.set(1,0,0,0,0,t,-n,0,0,n,t,0,0,0,0,1),this}makeRotationY(e){let t=Math.cos(e),n=Math.sin(e);return this.set(t,0,n,0,0,1,0,0,-n,0,t,0,0,0,0,1),this}makeRotationZ(e){let t=Math.cos(e),n=Math.sin(e);return this.set(t,-n,0,0,n,t,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(e,t){let n=Math.cos(t),s=Math.sin(t),r=1-n,a=e.x,o=e.y,l=e.z,c=r*a,u=r*o;return this.set(c*a+n,c*o-s*l,c*l+s*o,0,c*o+s*l,u*o+n,u*l-s*a,0,c*l-s*o,u*l+s*a,r*l*l+n,0,0,0,0,1),this}makeScale(e,t,n){return this.set(e,0,0,0,0,t,0,0,0,0,n,0,0,0,0,1),this}makeShear(e,t,n,s,r,a){return this.set(1,n,r,0,e,1,a,0,t,s,1,0,0,0,0,1),this}compose(e,t,n){let s=this.elements,r=t._x,a=t._y,o=t._z,l=t._w,c=r+r,u=a+a,f=o+o,h=r*c,d=r*u,g=r*f,b=a*u,m=a*f,p=o*f,v=l*c,E=l*u,S=l*f,R=n.x,A=n.y,x=n.z;return s[0]=(1-(b+p))*R,s[1]=(d+S)*R,s[2]=(g-E)*R,s[3]=0,s[4]=(d-S)*A,s[5]=(1-(h+p))*A,s[6]=(m+v)*A,s[7]=0,s[8]=(g+E)*x,s[9]=(m-v)*x,s[10]=(1-(h+b))*x,s[11]=0,s[12]=e.x,s[13]=e.y,s[14]=e.z,s[15]=1,this}decompose(e,t,n){let s=this.elements;e.x=s[12],e.y=s[13],e.z=s[14];let r=this.determinantAffine();if(r===0)return n.set(1,1,1),t.identity(),this;let a=Ar.set(s[0],s[1],s[2]).length(),o=Ar.set(s[4],s[5],s[6]).length(),l=Ar.set(s[8],s[9],s[10]).length();r<0&&(a=-a),bi.copy(this);let c=1/a,u=1/o,f=1/l;return bi.elements[0]*=c,bi.elements[1]*=c,bi.elements[2]*=c,bi.elements[4]*=u,bi.elements[5]*=u,bi.elements[6]*=u,bi.elements[8]*=f,bi.elements[9]*=f,bi.elements[10]*=f,t.setFromRotationMatrix(bi),n.x=a,n.y=o,n.z=l,this}makePerspective(e,t,n,s,r,a,o=ui,l=!1){let c=this.elements,u=2*r/(t-e),f=2*r/(n-s),h=(t+e)/(t-e),d=(n+s)/(n-s),g,b;if(l)g=r/(a-r),b=a*r/(a-r);else if(o===ui)g=-(a+r)/(a-r),b=-2*a*r/(a-r);else if(o===Da)g=-a/(a-r),b=-a*r/(a-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+o);return c[0]=u,c[4]=0,c[8]=h,c[12]=0,c[1]=0,c[5]=f,c[9]=d,c[13]=0,c[2]=0,c[6]=0,c[10]=g,c[14]=b,c[3]=0,c[7]=0,c[11]=-1,c[15]=0,this}makeOrthographic(e,t,n,s,r,a,o=ui,l=!1){let c=this.elements,u=2/(t-e),f=2/(n-s),h=-(t+e)/(t-e),d=-(n+s)/(n-s),g,b;if(l)g=1/(a-r),b=a/(a-r);else if(o===ui)g=-2/(a-r),b=-(a+r)/(a-r);else if(o===Da)g=-1/(a-r),b=-r/(a-r);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+o);return c[0]=u,c[4]=0,c[8]=0,c[12]=h,c[1]=0,c[5]=f,c[9]=0,c[13]=d,c[2]=0,c[6]=0,c[10]=g,c[14]=b,c[3]=0,c[7]=0,c[11]=0,c[15]=1,this}equals(e){let t=this.elements,n=e.elements;for(let s=0;s<16;s++)if(t[s]!==n[s])return!1;return!0}fromArray(e,t=0){for(let n=0;n<16;n++)this.elements[n]=e[n+t];return this}toArray(e=[],t=0){let n=this.elements;return e[t]=n[0],e[t+1]=n[1],e[t+2]=n[2],e[t+3]=n[3],e[t+4]=n[4],e[t+5]=n[5],e[t+6]=n[6],e[t+7]=n[7],e[t+8]=n[8],e[t+9]=n[9],e[t+10]=n[10],e[t+11]=n[11],e[t+12]=n[12],e[t+13]=n[13],e[t+14]=n[14],e[t+15]=n[15],e}},Ar=new Y,bi=new dt,Jg=new Y(0,0,0),Kg=new Y(1,1,1),ws=new Y,Eo=new Y,Kn=new Y,nd=new dt,id=new Vi,Ps=class i{constructor(e=0,t=0,n=0,s=i.DEFAULT_ORDER){this.isEuler=!0,this._x=e,this._y=t,this._z=n,this._order=s}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get order(){return this._order}set order(e){this._order=e,this._onChangeCallback()}set(e,t,n,s=this._order){return this._x=e,this._y=t,this._z=n,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(e){return this._x=e._x,this._y=e._y,this._z=e._z,this._order=e._order,this._onChangeCallback(),this}setFromRotationMatrix(e,t=this._order,n=!0){let s=e.elements,r=s[0],a=s[4],o=s[8],l=s[1],c=s[5],u=s[9],f=s[2],h=s[6],d=s[10];switch(t){case"XYZ":this._y=Math.asin(_t(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(-u,d),this._z=Math.atan2(-a,r)):(this._x=Math.atan2(h,c),this._z=0);break;case"YXZ":this._x=Math.asin(-_t(u,-1,1)),Math.abs(u)<.9999999?(this._y=Math.atan2(o,d),this._z=Math.atan2(l,c)):(this._y=Math.atan2(-f,r),this._z=0);break;case"ZXY":this._x=Math.asin(_t(h,-1,1)),Math.abs(h)<.9999999?(this._y=Math.atan2(-f,d),this._z=Math.atan2(-a,c)):(this._y=0,this._z=Math.atan2(l,r));break;case"ZYX":this._y=Math.asin(-_t(f,-1,1)),Math.abs(f)<.9999999?(this._x=Math.atan2(h,d),this._z=Math.atan2(l,r)):(this._x=0,this._z=Math.atan2(-a,c));break;case"YZX":this._z=Math.asin(_t(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(-u,c),this._y=Math.atan2(-f,r)):(this._x=0,this._y=Math.atan2(o,d));break;case"XZY":this._z=Math.asin(-_t(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(h,c),this._y=Math.atan2(o,r)):(this._x=Math.atan2(-u,d),this._y=0);break;default:$e("Euler: .setFromRotationMatrix() encountered an unknown order: "+t)}return this._order=t,n===!0&&this._onChangeCallback(),this}setFromQuaternion(e,t,n){return nd.makeRotationFromQuaternion(e),this.setFromRotationMatrix(nd,t,n)}setFromVector3(e,t=this._order){return this.set(e.x,e.y,e.z,t)}reorder(e){return id.setFromEuler(this),this.setFromQuaternion(id,e)}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._order===this._order}fromArray(e){return this._x=e[0],this._y=e[1],this._z=e[2],e[3]!==void 0&&(this._order=e[3]),this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._order,e}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};Ps.DEFAULT_ORDER="XYZ";var Fa=class{constructor(){this.mask=1}set(e){this.mask=(1<<e|0)>>>0}enable(e){this.mask|=1<<e|0}enableAll(){this.mask=-1}toggle(e){this.mask^=1<<e|0}disable(e){this.mask&=~(1<<e|0)}disableAll(){this.mask=0}test(e){return(this.mask&e.mask)!==0}isEnabled(e){return(this.mask&(1<<e|0))!==0}},Qg=0,sd=new Y,Er=new Vi,ss=new dt,Ro=new Y,Ta=new Y,jg=new Y,e_=new Vi,rd=new Y(1,0,0),ad=new Y(0,1,0),od=new Y(0,0,1),ld={type:"added"},t_={type:"removed"},Rr={type:"childadded",child:null},vu={type:"childremoved",child:null},fi=class i extends ki{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:Qg++}),this.uuid=ja(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=i.DEFAULT_UP.clone();let e=new Y,t=new Ps,n=new Vi,s=new Y(1,1,1);function r(){n.setFromEuler(t,!1)}function a(){t.setFromQuaternion(n,void 0,!1)}t._onChange(r),n._onChange(a),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:e},rotation:{configurable:!0,enumerable:!0,value:t},quaternion:{configurable:!0,enumerable:!0,value:n},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new dt},normalMatrix:{value:new je}}),this.matrix=new dt,this.matrixWorld=new dt,this.matrixAutoUpdate=i.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=i.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new Fa,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(e){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(e),this.matrix.decompose(this.position,this.quaternion,this.scale),this.pivot!==null&&this.position.copy(this.pivot).applyMatrix4(this.matrix).sub(this.pivot)}applyQuaternion(e){return this.quaternion.premultiply(e),this}setRotationFromAxisAngle(e,t){this.quaternion.setFromAxisAngle(e,t)}setRotationFromEuler(e){this.quaternion.setFromEuler(e,!0)}setRotationFromMatrix(e){this.quaternion.setFromRotationMatrix(e)}setRotationFromQuaternion(e){this.quaternion.copy(e)}rotateOnAxis(e,t){return Er.setFromAxisAngle(e,t),this.quaternion.multiply(Er),this}rotateOnWorldAxis(e,t){return Er.setFromAxisAngle(e,t),this.quaternion.premultiply(Er),this}rotateX(e){return this.rotateOnAxis(rd,e)}rotateY(e){return this.rotateOnAxis(ad,e)}rotateZ(e){return this.rotateOnAxis(od,e)}translateOnAxis(e,t){return sd.copy(e).applyQuaternion(this.quaternion),this.position.add(sd.multiplyScalar(t)),this}translateX(e){return this.translateOnAxis(rd,e)}translateY(e){return this.translateOnAxis(ad,e)}translateZ(e){return this.translateOnAxis(od,e)}localToWorld(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(this.matrixWorld)}worldToLocal(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(ss.copy(this.matrixWorld).invert())}lookAt(e,t,n){e.isVector3?Ro.copy(e):Ro.set(e,t,n);let s=this.parent;this.updateWorldMatrix(!0,!1),Ta.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?ss.lookAt(Ta,Ro,this.up):ss.lookAt(Ro,Ta,this.up),this.quaternion.setFromRotationMatrix(ss),s&&(ss.extractRotation(s.matrixWorld),Er.setFromRotationMatrix(ss),this.quaternion.premultiply(Er.invert()))}add(e){if(arguments.length>1){for(let t=0;t<arguments.length;t++)this.add(arguments[t]);return this}return e===this?(Qe("Object3D.add: object can't be added as a child of itself.",e),this):(e&&e.isObject3D?(e.removeFromParent(),e.parent=this,this.children.push(e),e.dispatchEvent(ld),Rr.child=e,this.dispatchEvent(Rr),Rr.child=null):Qe("Object3D.add: object not an instance of THREE.Object3D.",e),this)}remove(e){if(arguments.length>1){for(let n=0;n<arguments.length;n++)this.remove(arguments[n]);return this}let t=this.children.indexOf(e);return t!==-1&&(e.parent=null,this.children.splice(t,1),e.dispatchEvent(t_),vu.child=e,this.dispatchEvent(vu),vu.child=null),this}removeFromParent(){let e=this.parent;return e!==null&&e.remove(this),this}clear(){return this.remove(...this.children)}attach(e){return this.updateWorldMatrix(!0,!1),ss.copy(this.matrixWorld).invert(),e.parent!==null&&(e.parent.updateWorldMatrix(!0,!1),ss.multiply(e.parent.matrixWorld)),e.applyMatrix4(ss),e.removeFromParent(),e.parent=this,this.children.push(e),e.updateWorldMatrix(!1,!0),e.dispatchEvent(ld),Rr.child=e,this.dispatchEvent(Rr),Rr.child=null,this}getObjectById(e){return this.getObjectByProperty("id",e)}getObjectByName(e){return this.getObjectByProperty("name",e)}getObjectByProperty(e,t){if(this[e]===t)return this;for(let n=0,s=this.children.length;n<s;n++){let a=this.children[n].getObjectByProperty(e,t);if(a!==void 0)return a}}getObjectsByProperty(e,t,n=[]){this[e]===t&&n.push(this);let s=this.children;for(let r=0,a=s.length;r<a;r++)s[r].getObjectsByProperty(e,t,n);return n}getWorldPosition(e){return this.updateWorldMatrix(!0,!1),e.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Ta,e,jg),e}getWorldScale(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Ta,e_,e),e}getWorldDirection(e){this.updateWorldMatrix(!0,!1);let t=this.matrixWorld.elements;return e.set(t[8],t[9],t[10]).normalize()}raycast(){}intersectsFrustum(){return!0}traverse(e){e(this);let t=this.children;for(let n=0,s=t.length;n<s;n++)t[n].traverse(e)}traverseVisible(e){if(this.visible===!1)return;e(this);let t=this.children;for(let n=0,s=t.length;n<s;n++)t[n].traverseVisible(e)}traverseAncestors(e){let t=this.parent;t!==null&&(e(t),t.traverseAncestors(e))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);let e=this.pivot;if(e!==null){let t=e.x,n=e.y,s=e.z,r=this.matrix.elements;r[12]+=t-r[0]*t-r[4]*n-r[8]*s,r[13]+=n-r[1]*t-r[5]*n-r[9]*s,r[14]+=s-r[2]*t-r[6]*n-r[10]*s}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(e){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||e)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,e=!0);let t=this.children;for(let n=0,s=t.length;n<s;n++)t[n].updateMatrixWorld(e)}updateWorldMatrix(e,t,n=!1){let s=this.parent;if(e===!0&&s!==null&&s.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||n)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,n=!0),t===!0){let r=this.children;for(let a=0,o=r.length;a<o;a++)r[a].updateWorldMatrix(!1,!0,n)}}toJSON(e){let t=e===void 0||typeof e=="string",n={};t&&(e={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},n.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let s={};s.uuid=this.uuid,s.type=this.type,s.name=this.name,s.castShadow=this.castShadow,s.receiveShadow=this.receiveShadow,s.visible=this.visible,s.frustumCulled=this.frustumCulled,s.renderOrder=this.renderOrder,s.static=this.static,s.matrixAutoUpdate=this.matrixAutoUpdate,Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.pivot!==null&&(s.pivot=this.pivot.toArray()),this.morphTargetDictionary!==void 0&&(s.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(s.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.geometryInfo=this._geometryInfo.map(o=>({...o,boundingBox:o.boundingBox?o.boundingBox.toJSON():void 0,boundingSphere:o.boundingSphere?o.boundingSphere.toJSON():void 0})),s.instanceInfo=this._instanceInfo.map(o=>({...o})),s.availableInstanceIds=this._availableInstanceIds.slice(),s.availableGeometryIds=this._availableGeometryIds.slice(),s.nextIndexStart=this._nextIndexStart,s.nextVertexStart=this._nextVertexStart,s.geometryCount=this._geometryCount,s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.matricesTexture=this._matricesTexture.toJSON(e),s.indirectTexture=this._indirectTexture.toJSON(e),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(e)),this.boundingSphere!==null&&(s.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(s.boundingBox=this.boundingBox.toJSON()));function r(o,l){return o[l.uuid]===void 0&&(o[l.uuid]=l.toJSON(e)),l.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(e).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(e).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(e.geometries,this.geometry);let o=this.geometry.parameters;if(o!==void 0&&o.shapes!==void 0){let l=o.shapes;if(Array.isArray(l))for(let c=0,u=l.length;c<u;c++){let f=l[c];r(e.shapes,f)}else r(e.shapes,l)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(e.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let o=[];for(let l=0,c=this.material.length;l<c;l++)o.push(r(e.materials,this.material[l]));s.material=o}else s.material=r(e.materials,this.material);if(this.children.length>0){s.children=[];for(let o=0;o<this.children.length;o++)s.children.push(this.children[o].toJSON(e).object)}if(this.animations.length>0){s.animations=[];for(let o=0;o<this.animations.length;o++){let l=this.animations[o];s.animations.push(r(e.animations,l))}}if(t){let o=a(e.geometries),l=a(e.materials),c=a(e.textures),u=a(e.images),f=a(e.shapes),h=a(e.skeletons),d=a(e.animations),g=a(e.nodes);o.length>0&&(n.geometries=o),l.length>0&&(n.materials=l),c.length>0&&(n.textures=c),u.length>0&&(n.images=u),f.length>0&&(n.shapes=f),h.length>0&&(n.skeletons=h),d.length>0&&(n.animations=d),g.length>0&&(n.nodes=g)}return n.object=s,n;function a(o){let l=[];for(let c in o){let u=o[c];delete u.metadata,l.push(u)}return l}}clone(e){return new this.constructor().copy(this,e)}copy(e,t=!0){if(this.name=e.name,this.up.copy(e.up),this.position.copy(e.position),this.rotation.order=e.rotation.order,this.quaternion.copy(e.quaternion),this.scale.copy(e.scale),this.pivot=e.pivot!==null?e.pivot.clone():null,this.matrix.copy(e.matrix),this.matrixWorld.copy(e.matrixWorld),this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrixWorldAutoUpdate=e.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=e.matrixWorldNeedsUpdate,this.layers.mask=e.layers.mask,this.visible=e.visible,this.castShadow=e.castShadow,this.receiveShadow=e.receiveShadow,this.frustumCulled=e.frustumCulled,this.renderOrder=e.renderOrder,this.static=e.static,this.animations=e.animations.slice(),this.userData=JSON.parse(JSON.stringify(e.userData)),t===!0)for(let n=0;n<e.children.length;n++){let s=e.children[n];this.add(s.clone())}return this}dispose(){this.dispatchEvent({type:"dispose"})}};fi.DEFAULT_UP=new Y(0,1,0);fi.DEFAULT_MATRIX_AUTO_UPDATE=!0;fi.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var Zs=class extends fi{constructor(){super(),this.isGroup=!0,this.type="Group"}},n_={type:"move"},Gr=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new Zs,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new Zs,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new Y,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new Y),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new Zs,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new Y,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new Y,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(e){return this._targetRay!==null&&this._targetRay.dispatchEvent(e),this._grip!==null&&this._grip.dispatchEvent(e),this._hand!==null&&this._hand.dispatchEvent(e),this}connect(e){if(e&&e.hand){let t=this._hand;if(t)for(let n of e.hand.values())this._getHandJoint(t,n)}return this.dispatchEvent({type:"connected",data:e}),this}disconnect(e){return this.dispatchEvent({type:"disconnected",data:e}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(e,t,n){let s=null,r=null,a=null,o=this._targetRay,l=this._grip,c=this._hand;if(e&&t.session.visibilityState!=="visible-blurred"){if(c&&e.hand){a=!0;for(let b of e.hand.values()){let m=t.getJointPose(b,n),p=this._getHandJoint(c,b);m!==null&&(p.matrix.fromArray(m.transform.matrix),p.matrix.decompose(p.position,p.quaternion,p.scale),p.matrixWorldNeedsUpdate=!0,p.jointRadius=m.radius),p.visible=m!==null}let u=c.joints["index-finger-tip"],f=c.joints["thumb-tip"],h=u.position.distanceTo(f.position),d=.02,g=.005;c.inputState.pinching&&h>d+g?(c.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:e.handedness,target:this})):!c.inputState.pinching&&h<=d-g&&(c.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:e.handedness,target:this}))}else l!==null&&e.gripSpace&&(r=t.getPose(e.gripSpace,n),r!==null&&(l.matrix.fromArray(r.transform.matrix),l.matrix.decompose(l.position,l.quaternion,l.scale),l.matrixWorldNeedsUpdate=!0,r.linearVelocity?(l.hasLinearVelocity=!0,l.linearVelocity.copy(r.linearVelocity)):l.hasLinearVelocity=!1,r.angularVelocity?(l.hasAngularVelocity=!0,l.angularVelocity.copy(r.angularVelocity)):l.hasAngularVelocity=!1,l.eventsEnabled&&l.dispatchEvent({type:"gripUpdated",data:e,target:this})));o!==null&&(s=t.getPose(e.targetRaySpace,n),s===null&&r!==null&&(s=r),s!==null&&(o.matrix.fromArray(s.transform.matrix),o.matrix.decompose(o.position,o.quaternion,o.scale),o.matrixWorldNeedsUpdate=!0,s.linearVelocity?(o.hasLinearVelocity=!0,o.linearVelocity.copy(s.linearVelocity)):o.hasLinearVelocity=!1,s.angularVelocity?(o.hasAngularVelocity=!0,o.angularVelocity.copy(s.angularVelocity)):o.hasAngularVelocity=!1,this.dispatchEvent(n_)))}return o!==null&&(o.visible=s!==null),l!==null&&(l.visible=r!==null),c!==null&&(c.visible=a!==null),this}_getHandJoint(e,t){if(e.joints[t.jointName]===void 0){let n=new Zs;n.matrixAutoUpdate=!1,n.visible=!1,e.joints[t.jointName]=n,e.add(n)}return e.joints[t.jointName]}},ip={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},Ts={h:0,s:0,l:0},Co={h:0,s:0,l:0};function yu(i,e,t){return t<0&&(t+=1),t>1&&(t-=1),t<1/6?i+(e-i)*6*t:t<1/2?e:t<2/3?i+(e-i)*6*(2/3-t):i}var vt=class{constructor(e,t,n){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(e,t,n)}set(e,t,n){if(t===void 0&&n===void 0){let s=e;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(e,t,n);return this}setScalar(e){return this.r=e,this.g=e,this.b=e,this}setHex(e,t=jn){return e=Math.floor(e),this.r=(e>>16&255)/255,this.g=(e>>8&255)/255,this.b=(e&255)/255,mt.colorSpaceToWorking(this,t),this}setRGB(e,t,n,s=mt.workingColorSpace){return this.r=e,this.g=t,this.b=n,mt.colorSpaceToWorking(this,s),this}setHSL(e,t,n,s=mt.workingColorSpace){if(e=Wg(e,1),t=_t(t,0,1),n=_t(n,0,1),t===0)this.r=this.g=this.b=n;else{let r=n<=.5?n*(1+t):n+t-n*t,a=2*n-r;this.r=yu(a,r,e+1/3),this.g=yu(a,r,e),this.b=yu(a,r,e-1/3)}return mt.colorSpaceToWorking(this,s),this}setStyle(e,t=jn){function n(r){r!==void 0&&parseFloat(r)<1&&$e("Color: Alpha component of "+e+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(e)){let r,a=s[1],o=s[2];switch(a){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(o))return n(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,t);if(r=/^\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(o))return n(r[4]),this.setRGB(Math.min(100,parseFloat(r[1]))/100,Math.min(100,parseFloat(r[2]))/100,Math.min(100,parseFloat(r[3]))/100,t);break;case"hsl":case"hsla":if(r=/^\s*([+-]?(?:\d+(?:\.\d+)?|\.\d+))\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(o))return n(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,t);break;default:$e("Color: Unknown color model "+e)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(e)){let r=s[1],a=r.length;if(a===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,t);if(a===6)return this.setHex(parseInt(r,16),t);$e("Color: Invalid hex color "+e)}else if(e&&e.length>0)return this.setColorName(e,t);return this}setColorName(e,t=jn){let n=ip[e.toLowerCase()];return n!==void 0?this.setHex(n,t):$e("Color: Unknown color "+e),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(e){return this.r=e.r,this.g=e.g,this.b=e.b,this}copySRGBToLinear(e){return this.r=cs(e.r),this.g=cs(e.g),this.b=cs(e.b),this}copyLinearToSRGB(e){return this.r=Br(e.r),this.g=Br(e.g),this.b=Br(e.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(e=jn){return mt.workingToColorSpace(In.copy(this),e),Math.round(_t(In.r*255,0,255))*65536+Math.round(_t(In.g*255,0,255))*256+Math.round(_t(In.b*255,0,255))}getHexString(e=jn){return("000000"+this.getHex(e).toString(16)).slice(-6)}getHSL(e,t=mt.workingColorSpace){mt.workingToColorSpace(In.copy(this),t);let n=In.r,s=In.g,r=In.b,a=Math.max(n,s,r),o=Math.min(n,s,r),l,c,u=(o+a)/2;if(o===a)l=0,c=0;else{let f=a-o;switch(c=u<=.5?f/(a+o):f/(2-a-o),a){case n:l=(s-r)/f+(s<r?6:0);break;case s:l=(r-n)/f+2;break;case r:l=(n-s)/f+4;break}l/=6}return e.h=l,e.s=c,e.l=u,e}getRGB(e,t=mt.workingColorSpace){return mt.workingToColorSpace(In.copy(this),t),e.r=In.r,e.g=In.g,e.b=In.b,e}getStyle(e=jn){mt.workingToColorSpace(In.copy(this),e);let t=In.r,n=In.g,s=In.b;return e!==jn?`color(${e} ${t.toFixed(3)} ${n.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(t*255)},${Math.round(n*255)},${Math.round(s*255)})`}offsetHSL(e,t,n){return this.getHSL(Ts),this.setHSL(Ts.h+e,Ts.s+t,Ts.l+n)}add(e){return this.r+=e.r,this.g+=e.g,this.b+=e.b,this}addColors(e,t){return this.r=e.r+t.r,this.g=e.g+t.g,this.b=e.b+t.b,this}addScalar(e){return this.r+=e,this.g+=e,this.b+=e,this}sub(e){return this.r=Math.max(0,this.r-e.r),this.g=Math.max(0,this.g-e.g),this.b=Math.max(0,this.b-e.b),this}multiply(e){return this.r*=e.r,this.g*=e.g,this.b*=e.b,this}multiplyScalar(e){return this.r*=e,this.g*=e,this.b*=e,this}lerp(e,t){return this.r+=(e.r-this.r)*t,this.g+=(e.g-this.g)*t,this.b+=(e.b-this.b)*t,this}lerpColors(e,t,n){return this.r=e.r+(t.r-e.r)*n,this.g=e.g+(t.g-e.g)*n,this.b=e.b+(t.b-e.b)*n,this}lerpHSL(e,t){this.getHSL(Ts),e.getHSL(Co);let n=pu(Ts.h,Co.h,t),s=pu(Ts.s,Co.s,t),r=pu(Ts.l,Co.l,t);return this.setHSL(n,s,r),this}setFromVector3(e){return this.r=e.x,this.g=e.y,this.b=e.z,this}applyMatrix3(e){let t=this.r,n=this.g,s=this.b,r=e.elements;return this.r=r[0]*t+r[3]*n+r[6]*s,this.g=r[1]*t+r[4]*n+r[7]*s,this.b=r[2]*t+r[5]*n+r[8]*s,this}equals(e){return e.r===this.r&&e.g===this.g&&e.b===this.b}fromArray(e,t=0){return this.r=e[t],this.g=e[t+1],this.b=e[t+2],this}toArray(e=[],t=0){return e[t]=this.r,e[t+1]=this.g,e[t+2]=this.b,e}fromBufferAttribute(e,t){return this.r=e.getX(t),this.g=e.getY(t),this.b=e.getZ(t),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},In=new vt;vt.NAMES=ip;var Ua=class extends fi{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new Ps,this.environmentIntensity=1,this.environmentRotation=new Ps,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(e,t){return super.copy(e,t),this.background=e.background!==null?e.background.clone():null,this.environment=e.environment!==null?e.environment.clone():null,this.fog=e.fog!==null?e.fog.clone():null,this.backgroundBlurriness=e.backgroundBlurriness,this.backgroundIntensity=e.backgroundIntensity,this.backgroundRotation.copy(e.backgroundRotation),this.environmentIntensity=e.environmentIntensity,this.environmentRotation.copy(e.environmentRotation),this.overrideMaterial=e.overrideMaterial!==null?e.overrideMaterial.clone():null,this.matrixAutoUpdate=e.matrixAutoUpdate,this}toJSON(e){let t=super.toJSON(e);return this.fog!==null&&(t.object.fog=this.fog.toJSON()),t.object.backgroundBlurriness=this.backgroundBlurriness,t.object.backgroundIntensity=this.backgroundIntensity,t.object.backgroundRotation=this.backgroundRotation.toArray(),t.object.environmentIntensity=this.environmentIntensity,t.object.environmentRotation=this.environmentRotation.toArray(),t}},Si=new Y,rs=new Y,bu=new Y,as=new Y,Cr=new Y,Pr=new Y,cd=new Y,Su=new Y,Mu=new Y,wu=new Y,Tu=new Lt,Au=new Lt,Eu=new Lt,Cs=class i{constructor(e=new Y,t=new Y,n=new Y){this.a=e,this.b=t,this.c=n}static getNormal(e,t,n,s){s.subVectors(n,t),Si.subVectors(e,t),s.cross(Si);let r=s.lengthSq();return r>0?s.multiplyScalar(1/Math.sqrt(r)):s.set(0,0,0)}static getBarycoord(e,t,n,s,r){Si.subVectors(s,t),rs.subVectors(n,t),bu.subVectors(e,t);let a=Si.dot(Si),o=Si.dot(rs),l=Si.dot(bu),c=rs.dot(rs),u=rs.dot(bu),f=a*c-o*o;if(f===0)return r.set(0,0,0),null;let h=1/f,d=(c*l-o*u)*h,g=(a*u-o*l)*h;return r.set(1-d-g,g,d)}static containsPoint(e,t,n,s){return this.getBarycoord(e,t,n,s,as)===null?!1:as.x>=0&&as.y>=0&&as.x+as.y<=1}static getInterpolation(e,t,n,s,r,a,o,l){return this.getBarycoord(e,t,n,s,as)===null?(l.x=0,l.y=0,"z"in l&&(l.z=0),"w"in l&&(l.w=0),null):(l.setScalar(0),l.addScaledVector(r,as.x),l.addScaledVector(a,as.y),l.addScaledVector(o,as.z),l)}static getInterpolatedAttribute(e,t,n,s,r,a){return Tu.setScalar(0),Au.setScalar(0),Eu.setScalar(0),Tu.fromBufferAttribute(e,t),Au.fromBufferAttribute(e,n),Eu.fromBufferAttribute(e,s),a.setScalar(0),a.addScaledVector(Tu,r.x),a.addScaledVector(Au,r.y),a.addScaledVector(Eu,r.z),a}static isFrontFacing(e,t,n,s){return Si.subVectors(n,t),rs.subVectors(e,t),Si.cross(rs).dot(s)<0}set(e,t,n){return this.a.copy(e),this.b.copy(t),this.c.copy(n),this}setFromPointsAndIndices(e,t,n,s){return this.a.copy(e[t]),this.b.copy(e[n]),this.c.copy(e[s]),this}setFromAttributeAndIndices(e,t,n,s){return this.a.fromBufferAttribute(e,t),this.b.fromBufferAttribute(e,n),this.c.fromBufferAttribute(e,s),this}clone(){return new this.constructor().copy(this)}copy(e){return this.a.copy(e.a),this.b.copy(e.b),this.c.copy(e.c),this}getArea(){return Si.subVectors(this.c,this.b),rs.subVectors(this.a,this.b),Si.cross(rs).length()*.5}getMidpoint(e){return e.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(e){return i.getNormal(this.a,this.b,this.c,e)}getPlane(e){return e.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(e,t){return i.getBarycoord(e,this.a,this.b,this.c,t)}getInterpolation(e,t,n,s,r){return i.getInterpolation(e,this.a,this.b,this.c,t,n,s,r)}containsPoint(e){return i.containsPoint(e,this.a,this.b,this.c)}isFrontFacing(e){return i.isFrontFacing(this.a,this.b,this.c,e)}intersectsBox(e){return e.intersectsTriangle(this)}closestPointToPoint(e,t){let n=this.a,s=this.b,r=this.c,a,o;Cr.subVectors(s,n),Pr.subVectors(r,n),Su.subVectors(e,n);let l=Cr.dot(Su),c=Pr.dot(Su);if(l<=0&&c<=0)return t.copy(n);Mu.subVectors(e,s);let u=Cr.dot(Mu),f=Pr.dot(Mu);if(u>=0&&f<=u)return t.copy(s);let h=l*f-u*c;if(h<=0&&l>=0&&u<=0&&l-u>0)return a=l/(l-u),t.copy(n).addScaledVector(Cr,a);wu.subVectors(e,r);let d=Cr.dot(wu),g=Pr.dot(wu);if(g>=0&&d<=g)return t.copy(r);let b=d*c-l*g;if(b<=0&&c>=0&&g<=0)return o=c/(c-g),t.copy(n).addScaledVector(Pr,o);let m=u*g-d*f;if(m<=0&&f-u>=0&&d-g>=0)return cd.subVectors(r,s),o=(f-u)/(f-u+(d-g)),t.copy(s).addScaledVector(cd,o);let p=1/(m+b+h);return a=b*p,o=h*p,t.copy(n).addScaledVector(Cr,a).addScaledVector(Pr,o)}equals(e){return e.a.equals(this.a)&&e.b.equals(this.b)&&e.c.equals(this.c)}},Is=class{constructor(e=new Y(1/0,1/0,1/0),t=new Y(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=e,this.max=t}set(e,t){return this.min.copy(e),this.max.copy(t),this}setFromArray(e){this.makeEmpty();for(let t=0,n=e.length;t<n;t+=3)this.expandByPoint(Mi.fromArray(e,t));return this}setFromBufferAttribute(e){this.makeEmpty();for(let t=0,n=e.count;t<n;t++)this.expandByPoint(Mi.fromBufferAttribute(e,t));return this}setFromPoints(e){this.makeEmpty();for(let t=0,n=e.length;t<n;t++)this.expandByPoint(e[t]);return this}setFromCenterAndSize(e,t){let n=Mi.copy(t).multiplyScalar(.5);return this.min.copy(e).sub(n),this.max.copy(e).add(n),this}setFromObject(e,t=!1){return this.makeEmpty(),this.expandByObject(e,t)}clone(){return new this.constructor().copy(this)}copy(e){return this.min.copy(e.min),this.max.copy(e.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(e){return this.isEmpty()?e.set(0,0,0):e.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(e){return this.isEmpty()?e.set(0,0,0):e.subVectors(this.max,this.min)}expandByPoint(e){return this.min.min(e),this.max.max(e),this}expandByVector(e){return this.min.sub(e),this.max.add(e),this}expandByScalar(e){return this.min.addScalar(-e),this.max.addScalar(e),this}expandByObject(e,t=!1){e.updateWorldMatrix(!1,!1);let n=e.geometry;if(n!==void 0){let r=n.getAttribute("position");if(t===!0&&r!==void 0&&e.isInstancedMesh!==!0&&e.isBatchedMesh!==!0)for(let a=0,o=r.count;a<o;a++)e.isMesh===!0?e.getVertexPosition(a,Mi):Mi.fromBufferAttribute(r,a),Mi.applyMatrix4(e.matrixWorld),this.expandByPoint(Mi);else e.boundingBox!==void 0?(e.boundingBox===null&&e.computeBoundingBox(),Po.copy(e.boundingBox)):(n.boundingBox===null&&n.computeBoundingBox(),Po.copy(n.boundingBox)),Po.applyMatrix4(e.matrixWorld),this.union(Po)}let s=e.children;for(let r=0,a=s.length;r<a;r++)this.expandByObject(s[r],t);return this}containsPoint(e){return e.x>=this.min.x&&e.x<=this.max.x&&e.y>=this.min.y&&e.y<=this.max.y&&e.z>=this.min.z&&e.z<=this.max.z}containsBox(e){return this.min.x<=e.min.x&&e.max.x<=this.max.x&&this.min.y<=e.min.y&&e.max.y<=this.max.y&&this.min.z<=e.min.z&&e.max.z<=this.max.z}getParameter(e,t){return t.set((e.x-this.min.x)/(this.max.x-this.min.x),(e.y-this.min.y)/(this.max.y-this.min.y),(e.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(e){return e.max.x>=this.min.x&&e.min.x<=this.max.x&&e.max.y>=this.min.y&&e.min.y<=this.max.y&&e.max.z>=this.min.z&&e.min.z<=this.max.z}intersectsSphere(e){return this.clampPoint(e.center,Mi),Mi.distanceToSquared(e.center)<=e.radius*e.radius}intersectsPlane(e){let t,n;return e.normal.x>0?(t=e.normal.x*this.min.x,n=e.normal.x*this.max.x):(t=e.normal.x*this.max.x,n=e.normal.x*this.min.x),e.normal.y>0?(t+=e.normal.y*this.min.y,n+=e.normal.y*this.max.y):(t+=e.normal.y*this.max.y,n+=e.normal.y*this.min.y),e.normal.z>0?(t+=e.normal.z*this.min.z,n+=e.normal.z*this.max.z):(t+=e.normal.z*this.max.z,n+=e.normal.z*this.min.z),t<=-e.constant&&n>=-e.constant}intersectsTriangle(e){if(this.isEmpty())return!1;this.getCenter(Aa),Io.subVectors(this.max,Aa),Ir.subVectors(e.a,Aa),Lr.subVectors(e.b,Aa),Dr.subVectors(e.c,Aa),As.subVectors(Lr,Ir),Es.subVectors(Dr,Lr),Xs.subVectors(Ir,Dr);let t=[0,-As.z,As.y,0,-Es.z,Es.y,0,-Xs.z,Xs.y,As.z,0,-As.x,Es.z,0,-Es.x,Xs.z,0,-Xs.x,-As.y,As.x,0,-Es.y,Es.x,0,-Xs.y,Xs.x,0];return!Ru(t,Ir,Lr,Dr,Io)||(t=[1,0,0,0,1,0,0,0,1],!Ru(t,Ir,Lr,Dr,Io))?!1:(Lo.crossVectors(As,Es),t=[Lo.x,Lo.y,Lo.z],Ru(t,Ir,Lr,Dr,Io))}clampPoint(e,t){return t.copy(e).clamp(this.min,this.max)}distanceToPoint(e){return this.clampPoint(e,Mi).distanceTo(e)}getBoundingSphere(e){return this.isEmpty()?e.makeEmpty():(this.getCenter(e.center),e.radius=this.getSize(Mi).length()*.5),e}intersect(e){return this.min.max(e.min),this.max.min(e.max),this.isEmpty()&&this.makeEmpty(),this}union(e){return this.min.min(e.min),this.max.max(e.max),this}applyMatrix4(e){return this.isEmpty()?this:(os[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(e),os[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(e),os[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(e),os[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(e),os[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(e),os[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(e),os[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(e),os[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(e),this.setFromPoints(os),this)}translate(e){return this.min.add(e),this.max.add(e),this}equals(e){return e.min.equals(this.min)&&e.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(e){return this.min.fromArray(e.min),this.max.fromArray(e.max),this}},os=[new Y,new Y,new Y,new Y,new Y,new Y,new Y,new Y],Mi=new Y,Po=new Is,Ir=new Y,Lr=new Y,Dr=new Y,As=new Y,Es=new Y,Xs=new Y,Aa=new Y,Io=new Y,Lo=new Y,qs=new Y;function Ru(i,e,t,n,s){for(let r=0,a=i.length-3;r<=a;r+=3){qs.fromArray(i,r);let o=s.x*Math.abs(qs.x)+s.y*Math.abs(qs.y)+s.z*Math.abs(qs.z),l=e.dot(qs),c=t.dot(qs),u=n.dot(qs);if(Math.max(-Math.max(l,c,u),Math.min(l,c,u))>o)return!1}return!0}var ln=new Y,Do=new ct,i_=0,kn=class extends ki{constructor(e,t,n=!1){if(super(),Array.isArray(e))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:i_++}),this.name="",this.array=e,this.itemSize=t,this.count=e!==void 0?e.length/t:0,this.normalized=n,this.usage=Kd,this.updateRanges=[],this.gpuType=Nt,this.version=0,this._normalizationScale=e!==void 0?dh(e):void 0}onUploadCallback(){}set needsUpdate(e){e===!0&&this.version++}setUsage(e){return this.usage=e,this}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}copy(e){return this.name=e.name,this.array=new e.array.constructor(e.array),this.itemSize=e.itemSize,this.count=e.count,this.normalized=e.normalized,this.usage=e.usage,this.gpuType=e.gpuType,this._normalizationScale=e._normalizationScale,this}copyAt(e,t,n){e*=this.itemSize,n*=t.itemSize;for(let s=0,r=this.itemSize;s<r;s++)this.array[e+s]=t.array[n+s];return this}copyArray(e){return this.array.set(e),this}applyMatrix3(e){if(this.itemSize===2)for(let t=0,n=this.count;t<n;t++)Do.fromBufferAttribute(this,t),Do.applyMatrix3(e),this.setXY(t,Do.x,Do.y);else if(this.itemSize===3)for(let t=0,n=this.count;t<n;t++)ln.fromBufferAttribute(this,t),ln.applyMatrix3(e),this.setXYZ(t,ln.x,ln.y,ln.z);return this}applyMatrix4(e){for(let t=0,n=this.count;t<n;t++)ln.fromBufferAttribute(this,t),ln.applyMatrix4(e),this.setXYZ(t,ln.x,ln.y,ln.z);return this}applyNormalMatrix(e){for(let t=0,n=this.count;t<n;t++)ln.fromBufferAttribute(this,t),ln.applyNormalMatrix(e),this.setXYZ(t,ln.x,ln.y,ln.z);return this}transformDirection(e){for(let t=0,n=this.count;t<n;t++)ln.fromBufferAttribute(this,t),ln.transformDirection(e),this.setXYZ(t,ln.x,ln.y,ln.z);return this}set(e,t=0){return this.array.set(e,t),this}getComponent(e,t){let n=this.array[e*this.itemSize+t];return this.normalized&&(n=this._denormalize(n)),n}setComponent(e,t,n){return this.normalized&&(n=this._normalize(n)),this.array[e*this.itemSize+t]=n,this}getX(e){let t=this.array[e*this.itemSize];return this.normalized&&(t=this._denormalize(t)),t}setX(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize]=t,this}getY(e){let t=this.array[e*this.itemSize+1];return this.normalized&&(t=this._denormalize(t)),t}setY(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+1]=t,this}getZ(e){let t=this.array[e*this.itemSize+2];return this.normalized&&(t=this._denormalize(t)),t}setZ(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+2]=t,this}getW(e){let t=this.array[e*this.itemSize+3];return this.normalized&&(t=this._denormalize(t)),t}setW(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+3]=t,this}setXY(e,t,n){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),n=this._normalize(n)),this.array[e+0]=t,this.array[e+1]=n,this}setXYZ(e,t,n,s){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),n=this._normalize(n),s=this._normalize(s)),this.array[e+0]=t,this.array[e+1]=n,this.array[e+2]=s,this}setXYZW(e,t,n,s,r){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),n=this._normalize(n),s=this._normalize(s),r=this._normalize(r)),this.array[e+0]=t,this.array[e+1]=n,this.array[e+2]=s,this.array[e+3]=r,this}onUpload(e){return this.onUploadCallback=e,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let e={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return e.name=this.name,e.usage=this.usage,e.gpuType=this.gpuType,e}dispose(){this.dispatchEvent({type:"dispose"})}_denormalize(e){let t=this._normalizationScale;return t!==void 0?Math.max(e/t,-1):Xg(e,this.array)}_normalize(e){let t=this._normalizationScale;return t!==void 0?Math.round(e*t):qg(e,this.array)}};var Oa=class extends kn{constructor(e,t,n){super(new Uint16Array(e),t,n)}};var Ba=class extends kn{constructor(e,t,n){super(new Uint32Array(e),t,n)}};var hi=class extends kn{constructor(e,t,n){super(new Float32Array(e),t,n)}},s_=new Is,Ea=new Y,Cu=new Y,Hr=class{constructor(e=new Y,t=-1){this.isSphere=!0,this.center=e,this.radius=t}set(e,t){return this.center.copy(e),this.radius=t,this}setFromPoints(e,t){let n=this.center;t!==void 0?n.copy(t):s_.setFromPoints(e).getCenter(n);let s=0;for(let r=0,a=e.length;r<a;r++)s=Math.max(s,n.distanceToSquared(e[r]));return this.radius=Math.sqrt(s),this}copy(e){return this.center.copy(e.center),this.radius=e.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(e){return e.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(e){return e.distanceTo(this.center)-this.radius}intersectsSphere(e){let t=this.radius+e.radius;return e.center.distanceToSquared(this.center)<=t*t}intersectsBox(e){return e.intersectsSphere(this)}intersectsPlane(e){return Math.abs(e.distanceToPoint(this.center))<=this.radius}clampPoint(e,t){let n=this.center.distanceToSquared(e);return t.copy(e),n>this.radius*this.radius&&(t.sub(this.center).normalize(),t.multiplyScalar(this.radius).add(this.center)),t}getBoundingBox(e){return this.isEmpty()?(e.makeEmpty(),e):(e.set(this.center,this.center),e.expandByScalar(this.radius),e)}applyMatrix4(e){return this.center.applyMatrix4(e),this.radius=this.radius*e.getMaxScaleOnAxis(),this}translate(e){return this.center.add(e),this}expandByPoint(e){if(this.isEmpty())return this.center.copy(e),this.radius=0,this;Ea.subVectors(e,this.center);let t=Ea.lengthSq();if(t>this.radius*this.radius){let n=Math.sqrt(t),s=(n-this.radius)*.5;this.center.addScaledVector(Ea,s/n),this.radius+=s}return this}union(e){return e.isEmpty()?this:this.isEmpty()?(this.copy(e),this):(this.center.equals(e.center)===!0?this.radius=Math.max(this.radius,e.radius):(Cu.subVectors(e.center,this.center).setLength(e.radius),this.expandByPoint(Ea.copy(e.center).add(Cu)),this.expandByPoint(Ea.copy(e.center).sub(Cu))),this)}equals(e){return e.center.equals(this.center)&&e.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(e){return this.radius=e.radius,this.center.fromArray(e.center),this}},r_=0,li=new dt,Pu=new fi,Nr=new Y,Qn=new Is,Ra=new Is,Mn=new Y,di=class i extends ki{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:r_++}),this.uuid=ja(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(e){return Array.isArray(e)?this.index=new(Gg(e)?Ba:Oa)(e,1):this.index=e,this}setIndirect(e,t=0){return this.indirect=e,this.indirectOffset=t,this}getIndirect(){return this.indirect}getAttribute(e){return this.attributes[e]}setAttribute(e,t){return this.attributes[e]=t,this}deleteAttribute(e){return delete this.attributes[e],this}hasAttribute(e){return this.attributes[e]!==void 0}addGroup(e,t,n=0){this.groups.push({start:e,count:t,materialIndex:n})}clearGroups(){this.groups=[]}setDrawRange(e,t){this.drawRange.start=e,this.drawRange.count=t}applyMatrix4(e){let t=this.attributes.position;t!==void 0&&(t.applyMatrix4(e),t.needsUpdate=!0);let n=this.attributes.normal;if(n!==void 0){let r=new je().getNormalMatrix(e);n.applyNormalMatrix(r),n.needsUpdate=!0}let s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(e),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(e){return li.makeRotationFromQuaternion(e),this.applyMatrix4(li),this}rotateX(e){return li.makeRotationX(e),this.applyMatrix4(li),this}rotateY(e){return li.makeRotationY(e),this.applyMatrix4(li),this}rotateZ(e){return li.makeRotationZ(e),this.applyMatrix4(li),this}translate(e,t,n){return li.makeTranslation(e,t,n),this.applyMatrix4(li),this}scale(e,t,n){return li.makeScale(e,t,n),this.applyMatrix4(li),this}lookAt(e){return Pu.lookAt(e),Pu.updateMatrix(),this.applyMatrix4(Pu.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(Nr).negate(),this.translate(Nr.x,Nr.y,Nr.z),this}setFromPoints(e){let t=this.getAttribute("position");if(t===void 0){let n=[];for(let s=0,r=e.length;s<r;s++){let a=e[s];n.push(a.x,a.y,a.z||0)}this.setAttribute("position",new hi(n,3))}else{let n=Math.min(e.length,t.count);for(let s=0;s<n;s++){let r=e[s];t.setXYZ(s,r.x,r.y,r.z||0)}e.length>t.count&&$e("BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),t.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new Is);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){Qe("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new Y(-1/0,-1/0,-1/0),new Y(1/0,1/0,1/0));return}if(e!==void 0){if(this.boundingBox.setFromBufferAttribute(e),t)for(let n=0,s=t.length;n<s;n++){let r=t[n];Qn.setFromBufferAttribute(r),this.morphTargetsRelative?(Mn.addVectors(this.boundingBox.min,Qn.min),this.boundingBox.expandByPoint(Mn),Mn.addVectors(this.boundingBox.max,Qn.max),this.boundingBox.expandByPoint(Mn)):(this.boundingBox.expandByPoint(Qn.min),this.boundingBox.expandByPoint(Qn.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&Qe('BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new Hr);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){Qe("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new Y,1/0);return}if(e){let n=this.boundingSphere.center;if(Qn.setFromBufferAttribute(e),t)for(let r=0,a=t.length;r<a;r++){let o=t[r];Ra.setFromBufferAttribute(o),this.morphTargetsRelative?(Mn.addVectors(Qn.min,Ra.min),Qn.expandByPoint(Mn),Mn.addVectors(Qn.max,Ra.max),Qn.expandByPoint(Mn)):(Qn.expandByPoint(Ra.min),Qn.expandByPoint(Ra.max))}Qn.getCenter(n);let s=0;for(let r=0,a=e.count;r<a;r++)Mn.fromBufferAttribute(e,r),s=Math.max(s,n.distanceToSquared(Mn));if(t)for(let r=0,a=t.length;r<a;r++){let o=t[r],l=this.morphTargetsRelative;for(let c=0,u=o.count;c<u;c++)Mn.fromBufferAttribute(o,c),l&&(Nr.fromBufferAttribute(e,c),Mn.add(Nr)),s=Math.max(s,n.distanceToSquared(Mn))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&Qe('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let e=this.index,t=this.attributes;if(e===null||t.position===void 0||t.normal===void 0||t.uv===void 0){Qe("BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let n=t.position,s=t.normal,r=t.uv,a=this.getAttribute("tangent");(a===void 0||a.count!==n.count)&&(a=new kn(new Float32Array(4*n.count),4),this.setAttribute("tangent",a));let o=[],l=[],c=new Uint8Array(n.count);for(let k=0;k<n.count;k++)o[k]=new Y,l[k]=new Y;let u=new Y,f=new Y,h=new Y,d=new ct,g=new ct,b=new ct,m=new Y,p=new Y;function v(k,N,L){c[k]=c[N]=c[L]=1,u.fromBufferAttribute(n,k),f.fromBufferAttribute(n,N),h.fromBufferAttribute(n,L),d.fromBufferAttribute(r,k),g.fromBufferAttribute(r,N),b.fromBufferAttribute(r,L),f.sub(u),h.sub(u),g.sub(d),b.sub(d);let G=1/(g.x*b.y-b.x*g.y);isFinite(G)&&(m.copy(f).multiplyScalar(b.y).addScaledVector(h,-g.y).multiplyScalar(G),p.copy(h).multiplyScalar(g.x).addScaledVector(f,-b.x).multiplyScalar(G),o[k].add(m),o[N].add(m),o[L].add(m),l[k].add(p),l[N].add(p),l[L].add(p))}let E=this.groups;E.length===0&&(E=[{start:0,count:e.count}]);for(let k=0,N=E.length;k<N;++k){let L=E[k],G=L.start,H=L.count;for(let D=G,V=G+H;D<V;D+=3)v(e.getX(D+0),e.getX(D+1),e.getX(D+2))}let S=new Y,R=new Y,A=new Y,x=new Y;function T(k){A.fromBufferAttribute(s,k),x.copy(A);let N=o[k];S.copy(N),S.sub(A.multiplyScalar(A.dot(N))).normalize(),R.crossVectors(x,N);let G=R.dot(l[k])<0?-1:1;a.setXYZW(k,S.x,S.y,S.z,G)}for(let k=0,N=n.count;k<N;++k)c[k]&&T(k);this._transformed=!0}computeVertexNormals(){let e=this.index,t=this.getAttribute("position");if(t!==void 0){let n=this.getAttribute("normal");if(n===void 0||n.count!==t.count)n=new kn(new Float32Array(t.count*3),3),this.setAttribute("normal",n);else for(let h=0,d=n.count;h<d;h++)n.setXYZ(h,0,0,0);let s=new Y,r=new Y,a=new Y,o=new Y,l=new Y,c=new Y,u=new Y,f=new Y;if(e)for(let h=0,d=e.count;h<d;h+=3){let g=e.getX(h+0),b=e.getX(h+1),m=e.getX(h+2);s.fromBufferAttribute(t,g),r.fromBufferAttribute(t,b),a.fromBufferAttribute(t,m),u.subVectors(a,r),f.subVectors(s,r),u.cross(f),o.fromBufferAttribute(n,g),l.fromBufferAttribute(n,b),c.fromBufferAttribute(n,m),o.add(u),l.add(u),c.add(u),n.setXYZ(g,o.x,o.y,o.z),n.setXYZ(b,l.x,l.y,l.z),n.setXYZ(m,c.x,c.y,c.z)}else for(let h=0,d=t.count;h<d;h+=3)s.fromBufferAttribute(t,h+0),r.fromBufferAttribute(t,h+1),a.fromBufferAttribute(t,h+2),u.subVectors(a,r),f.subVectors(s,r),u.cross(f),n.setXYZ(h+0,u.x,u.y,u.z),n.setXYZ(h+1,u.x,u.y,u.z),n.setXYZ(h+2,u.x,u.y,u.z);this.normalizeNormals(),n.needsUpdate=!0}}normalizeNormals(){let e=this.attributes.normal;for(let t=0,n=e.count;t<n;t++)Mn.fromBufferAttribute(e,t),Mn.normalize(),e.setXYZ(t,Mn.x,Mn.y,Mn.z)}toNonIndexed(){function e(o,l){let c=o.array,u=o.itemSize,f=o.normalized,h=new c.constructor(l.length*u),d=0,g=0;for(let b=0,m=l.length;b<m;b++){o.isInterleavedBufferAttribute?d=l[b]*o.data.stride+o.offset:d=l[b]*u;for(let p=0;p<u;p++)h[g++]=c[d++]}return new kn(h,u,f)}if(this.index===null)return $e("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let t=new i,n=this.index.array,s=this.attributes;for(let o in s){let l=s[o],c=e(l,n);t.setAttribute(o,c)}let r=this.morphAttributes;for(let o in r){let l=[],c=r[o];for(let u=0,f=c.length;u<f;u++){let h=c[u],d=e(h,n);l.push(d)}t.morphAttributes[o]=l}t.morphTargetsRelative=this.morphTargetsRelative;let a=this.groups;for(let o=0,l=a.length;o<l;o++){let c=a[o];t.addGroup(c.start,c.count,c.materialIndex)}return t}toJSON(){let e={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(e.uuid=this.uuid,e.type=this.parameters!==void 0&&this._transformed===!0?"BufferGeometry":this.type,e.name=this.name,Object.keys(this.userData).length>0&&(e.userData=this.userData),this.parameters!==void 0&&this._transformed!==!0){let l=this.parameters;for(let c in l)l[c]!==void 0&&(e[c]=l[c]);return e}e.data={attributes:{}};let t=this.index;t!==null&&(e.data.index={type:t.array.constructor.name,array:Array.prototype.slice.call(t.array)});let n=this.attributes;for(let l in n){let c=n[l];e.data.attributes[l]=c.toJSON(e.data)}let s={},r=!1;for(let l in this.morphAttributes){let c=this.morphAttributes[l],u=[];for(let f=0,h=c.length;f<h;f++){let d=c[f];u.push(d.toJSON(e.data))}u.length>0&&(s[l]=u,r=!0)}r&&(e.data.morphAttributes=s,e.data.morphTargetsRelative=this.morphTargetsRelative);let a=this.groups;a.length>0&&(e.data.groups=JSON.parse(JSON.stringify(a)));let o=this.boundingSphere;return o!==null&&(e.data.boundingSphere=o.toJSON()),e}clone(){return new this.constructor().copy(this)}copy(e){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let t={};this.name=e.name;let n=e.index;n!==null&&this.setIndex(n.clone());let s=e.attributes;for(let c in s){let u=s[c];this.setAttribute(c,u.clone(t))}let r=e.morphAttributes;for(let c in r){let u=[],f=r[c];for(let h=0,d=f.length;h<d;h++)u.push(f[h].clone(t));this.morphAttributes[c]=u}this.morphTargetsRelative=e.morphTargetsRelative;let a=e.groups;for(let c=0,u=a.length;c<u;c++){let f=a[c];this.addGroup(f.start,f.count,f.materialIndex)}let o=e.boundingBox;o!==null&&(this.boundingBox=o.clone());let l=e.boundingSphere;return l!==null&&(this.boundingSphere=l.clone()),this.drawRange.start=e.drawRange.start,this.drawRange.count=e.drawRange.count,this.userData=e.userData,this._transformed=e._transformed,this}dispose(){this.dispatchEvent({type:"dispose"})}};var Iu=new Y,a_=new Y,o_=new je,wi=class{constructor(e=new Y(1,0,0),t=0){this.isPlane=!0,this.normal=e,this.constant=t}set(e,t){return this.normal.copy(e),this.constant=t,this}setComponents(e,t,n,s){return this.normal.set(e,t,n),this.constant=s,this}setFromNormalAndCoplanarPoint(e,t){return this.normal.copy(e),this.constant=-t.dot(this.normal),this}setFromCoplanarPoints(e,t,n){let s=Iu.subVectors(n,t).cross(a_.subVectors(e,t)).normalize();return this.setFromNormalAndCoplanarPoint(s,e),this}copy(e){return this.normal.copy(e.normal),this.constant=e.constant,this}normalize(){let e=1/this.normal.length();return this.normal.multiplyScalar(e),this.constant*=e,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(e){return this.normal.dot(e)+this.constant}distanceToSphere(e){return this.distanceToPoint(e.center)-e.radius}projectPoint(e,t){return t.copy(e).addScaledVector(this.normal,-this.distanceToPoint(e))}intersectLine(e,t,n=!0){let s=e.delta(Iu),r=this.normal.dot(s);if(r===0)return this.distanceToPoint(e.start)===0?t.copy(e.start):null;let a=-(e.start.dot(this.normal)+this.constant)/r;return n===!0&&(a<0||a>1)?null:t.copy(e.start).addScaledVector(s,a)}intersectsLine(e){let t=this.distanceToPoint(e.start),n=this.distanceToPoint(e.end);return t<0&&n>0||n<0&&t>0}intersectsBox(e){return e.intersectsPlane(this)}intersectsSphere(e){return e.intersectsPlane(this)}coplanarPoint(e){return e.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(e,t){let n=t||o_.getNormalMatrix(e),s=this.coplanarPoint(Iu).applyMatrix4(e),r=this.normal.applyMatrix3(n).normalize();return this.constant=-s.dot(r),this}translate(e){return this.constant-=e.dot(this.normal),this}equals(e){return e.normal.equals(this.normal)&&e.constant===this.constant}clone(){return new this.constructor().copy(this)}toJSON(){return{normal:this.normal.toArray(),constant:this.constant}}fromJSON(e){return this.normal.fromArray(e.normal),this.constant=e.constant,this}},l_=0,Ks=class extends ki{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:l_++}),this.uuid=ja(),this.name="",this.type="Material",this.blending=$r,this.side=Fs,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=Wu,this.blendDst=Xu,this.blendEquation=tr,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new vt(0,0,0),this.blendAlpha=0,this.depthFunc=zr,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=Xd,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=$o,this.stencilZFail=$o,this.stencilZPass=$o,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(e){this._alphaTest>0!=e>0&&this.version++,this._alphaTest=e}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(e){if(e!==void 0)for(let t in e){let n=e[t];if(n===void 0){$e(`Material: parameter '${t}' has value of undefined.`);continue}let s=this[t];if(s===void 0){$e(`Material: '${t}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(n):s&&s.isVector2&&n&&n.isVector2||s&&s.isEuler&&n&&n.isEuler||s&&s.isVector3&&n&&n.isVector3?s.copy(n):this[t]=n}}toJSON(e){let t=e===void 0||typeof e=="string";t&&(e={textures:{},images:{}});let n={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};n.uuid=this.uuid,n.type=this.type,n.blending=this.blending,n.side=this.side,n.shadowSide=this.shadowSide,n.vertexColors=this.vertexColors,n.opacity=this.opacity,n.transparent=this.transparent,n.blendSrc=this.blendSrc,n.blendDst=this.blendDst,n.blendEquation=this.blendEquation,n.blendSrcAlpha=this.blendSrcAlpha,n.blendDstAlpha=this.blendDstAlpha,n.blendEquationAlpha=this.blendEquationAlpha,n.blendColor=this.blendColor.getHex(),n.blendAlpha=this.blendAlpha,n.depthFunc=this.depthFunc,n.depthTest=this.depthTest,n.depthWrite=this.depthWrite,n.colorWrite=this.colorWrite,n.clipIntersection=this.clipIntersection,n.clipShadows=this.clipShadows,n.stencilWriteMask=this.stencilWriteMask,n.stencilFunc=this.stencilFunc,n.stencilRef=this.stencilRef,n.stencilFuncMask=this.stencilFuncMask,n.stencilFail=this.stencilFail,n.stencilZFail=this.stencilZFail,n.stencilZPass=this.stencilZPass,n.stencilWrite=this.stencilWrite,n.polygonOffset=this.polygonOffset,n.polygonOffsetFactor=this.polygonOffsetFactor,n.polygonOffsetUnits=this.polygonOffsetUnits,n.dithering=this.dithering,n.alphaTest=this.alphaTest,n.alphaHash=this.alphaHash,n.alphaToCoverage=this.alphaToCoverage,n.premultipliedAlpha=this.premultipliedAlpha,n.forceSinglePass=this.forceSinglePass,n.allowOverride=this.allowOverride,n.visible=this.visible,n.toneMapped=this.toneMapped,n.name=this.name,this.color&&this.color.isColor&&(n.color=this.color.getHex()),this.roughness!==void 0&&(n.roughness=this.roughness),this.metalness!==void 0&&(n.metalness=this.metalness),this.sheen!==void 0&&(n.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(n.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(n.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(n.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&(n.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(n.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(n.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(n.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(n.shininess=this.shininess),this.clearcoat!==void 0&&(n.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(n.clearcoatRoughness=this.clearcoatRoughness),this.diffuseRoughness!==void 0&&(n.diffuseRoughness=this.diffuseRoughness),this.diffuseRoughnessMap&&this.diffuseRoughnessMap.isTexture&&(n.diffuseRoughnessMap=this.diffuseRoughnessMap.toJSON(e).uuid),this.clearcoatMap&&this.clearcoatMap.isTexture&&(n.clearcoatMap=this.clearcoatMap.toJSON(e).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(n.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(e).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(n.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(e).uuid,n.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(n.sheenColorMap=this.sheenColorMap.toJSON(e).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(n.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(e).uuid),this.dispersion!==void 0&&(n.dispersion=this.dispersion),this.retroreflectivity!==void 0&&(n.retroreflectivity=this.retroreflectivity),this.iridescence!==void 0&&(n.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(n.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessMinimum!==void 0&&(n.iridescenceThicknessMinimum=this.iridescenceThicknessMinimum),this.iridescenceThicknessMaximum!==void 0&&(n.iridescenceThicknessMaximum=this.iridescenceThicknessMaximum),this.iridescenceMap&&this.iridescenceMap.isTexture&&(n.iridescenceMap=this.iridescenceMap.toJSON(e).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(n.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(e).uuid),this.anisotropy!==void 0&&(n.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(n.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(n.anisotropyMap=this.anisotropyMap.toJSON(e).uuid),this.map&&this.map.isTexture&&(n.map=this.map.toJSON(e).uuid),this.matcap&&this.matcap.isTexture&&(n.matcap=this.matcap.toJSON(e).uuid),this.alphaMap&&this.alphaMap.isTexture&&(n.alphaMap=this.alphaMap.toJSON(e).uuid),this.lightMap&&this.lightMap.isTexture&&(n.lightMap=this.lightMap.toJSON(e).uuid,n.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(n.aoMap=this.aoMap.toJSON(e).uuid,n.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(n.bumpMap=this.bumpMap.toJSON(e).uuid,n.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(n.normalMap=this.normalMap.toJSON(e).uuid,n.normalMapType=this.normalMapType,n.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(n.displacementMap=this.displacementMap.toJSON(e).uuid,n.displacementScale=this.displacementScale,n.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(n.roughnessMap=this.roughnessMap.toJSON(e).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(n.metalnessMap=this.metalnessMap.toJSON(e).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(n.emissiveMap=this.emissiveMap.toJSON(e).uuid),this.specularMap&&this.specularMap.isTexture&&(n.specularMap=this.specularMap.toJSON(e).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(n.specularIntensityMap=this.specularIntensityMap.toJSON(e).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(n.specularColorMap=this.specularColorMap.toJSON(e).uuid),this.envMap&&this.envMap.isTexture&&(n.envMap=this.envMap.toJSON(e).uuid,this.combine!==void 0&&(n.combine=this.combine)),this.envMapRotation!==void 0&&(n.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(n.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(n.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(n.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(n.gradientMap=this.gradientMap.toJSON(e).uuid),this.transmission!==void 0&&(n.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(n.transmissionMap=this.transmissionMap.toJSON(e).uuid),this.thickness!==void 0&&(n.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(n.thicknessMap=this.thicknessMap.toJSON(e).uuid),this.attenuationDistance!==void 0&&(n.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(n.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(n.size=this.size),this.sizeAttenuation!==void 0&&(n.sizeAttenuation=this.sizeAttenuation),Array.isArray(this.clippingPlanes)&&this.clippingPlanes.length>0&&(n.clippingPlanes=this.clippingPlanes.map(r=>r.toJSON())),this.rotation!==void 0&&(n.rotation=this.rotation),this.depthPacking!==void 0&&(n.depthPacking=this.depthPacking),this.linewidth!==void 0&&(n.linewidth=this.linewidth),this.linecap!==void 0&&(n.linecap=this.linecap),this.linejoin!==void 0&&(n.linejoin=this.linejoin),this.dashSize!==void 0&&(n.dashSize=this.dashSize),this.gapSize!==void 0&&(n.gapSize=this.gapSize),this.scale!==void 0&&(n.scale=this.scale),this.wireframe!==void 0&&(n.wireframe=this.wireframe),this.wireframeLinewidth!==void 0&&(n.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!==void 0&&(n.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!==void 0&&(n.wireframeLinejoin=this.wireframeLinejoin),this.flatShading!==void 0&&(n.flatShading=this.flatShading),this.fog!==void 0&&(n.fog=this.fog),Object.keys(this.userData).length>0&&(n.userData=this.userData);function s(r){let a=[];for(let o in r){let l=r[o];delete l.metadata,a.push(l)}return a}if(t){let r=s(e.textures),a=s(e.images);r.length>0&&(n.textures=r),a.length>0&&(n.images=a)}return n}fromJSON(e,t){if(e.uuid!==void 0&&(this.uuid=e.uuid),e.name!==void 0&&(this.name=e.name),e.color!==void 0&&this.color!==void 0&&this.color.setHex(e.color),e.roughness!==void 0&&(this.roughness=e.roughness),e.metalness!==void 0&&(this.metalness=e.metalness),e.sheen!==void 0&&(this.sheen=e.sheen),e.sheenColor!==void 0&&(this.sheenColor=new vt().setHex(e.sheenColor)),e.sheenRoughness!==void 0&&(this.sheenRoughness=e.sheenRoughness),e.emissive!==void 0&&this.emissive!==void 0&&this.emissive.setHex(e.emissive),e.specular!==void 0&&this.specular!==void 0&&this.specular.setHex(e.specular),e.specularIntensity!==void 0&&(this.specularIntensity=e.specularIntensity),e.specularColor!==void 0&&this.specularColor!==void 0&&this.specularColor.setHex(e.specularColor),e.shininess!==void 0&&(this.shininess=e.shininess),e.clearcoat!==void 0&&(this.clearcoat=e.clearcoat),e.clearcoatRoughness!==void 0&&(this.clearcoatRoughness=e.clearcoatRoughness),e.diffuseRoughness!==void 0&&(this.diffuseRoughness=e.diffuseRoughness),e.dispersion!==void 0&&(this.dispersion=e.dispersion),e.retroreflectivity!==void 0&&(this.retroreflectivity=e.retroreflectivity),e.iridescence!==void 0&&(this.iridescence=e.iridescence),e.iridescenceIOR!==void 0&&(this.iridescenceIOR=e.iridescenceIOR),e.iridescenceThicknessMinimum!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessMinimum),e.iridescenceThicknessMaximum!==void 0&&(this.iridescenceThicknessMaximum=e.iridescenceThicknessMaximum),e.iridescenceThicknessRange!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessRange[0],this.iridescenceThicknessMaximum=e.iridescenceThicknessRange[1]),e.transmission!==void 0&&(this.transmission=e.transmission),e.thickness!==void 0&&(this.thickness=e.thickness),e.attenuationDistance!==void 0&&(this.attenuationDistance=e.attenuationDistance),e.attenuationColor!==void 0&&this.attenuationColor!==void 0&&this.attenuationColor.setHex(e.attenuationColor),e.anisotropy!==void 0&&(this.anisotropy=e.anisotropy),e.anisotropyRotation!==void 0&&(this.anisotropyRotation=e.anisotropyRotation),e.fog!==void 0&&(this.fog=e.fog),e.flatShading!==void 0&&(this.flatShading=e.flatShading),e.blending!==void 0&&(this.blending=e.blending),e.combine!==void 0&&(this.combine=e.combine),e.side!==void 0&&(this.side=e.side),e.shadowSide!==void 0&&(this.shadowSide=e.shadowSide),e.opacity!==void 0&&(this.opacity=e.opacity),e.transparent!==void 0&&(this.transparent=e.transparent),e.alphaTest!==void 0&&(this.alphaTest=e.alphaTest),e.alphaHash!==void 0&&(this.alphaHash=e.alphaHash),e.depthFunc!==void 0&&(this.depthFunc=e.depthFunc),e.depthTest!==void 0&&(this.depthTest=e.depthTest),e.depthWrite!==void 0&&(this.depthWrite=e.depthWrite),e.colorWrite!==void 0&&(this.colorWrite=e.colorWrite),e.clippingPlanes!==void 0&&(this.clippingPlanes=e.clippingPlanes.map(n=>new wi().fromJSON(n))),e.clipIntersection!==void 0&&(this.clipIntersection=e.clipIntersection),e.clipShadows!==void 0&&(this.clipShadows=e.clipShadows),e.depthPacking!==void 0&&(this.depthPacking=e.depthPacking),e.blendSrc!==void 0&&(this.blendSrc=e.blendSrc),e.blendDst!==void 0&&(this.blendDst=e.blendDst),e.blendEquation!==void 0&&(this.blendEquation=e.blendEquation),e.blendSrcAlpha!==void 0&&(this.blendSrcAlpha=e.blendSrcAlpha),e.blendDstAlpha!==void 0&&(this.blendDstAlpha=e.blendDstAlpha),e.blendEquationAlpha!==void 0&&(this.blendEquationAlpha=e.blendEquationAlpha),e.blendColor!==void 0&&this.blendColor!==void 0&&this.blendColor.setHex(e.blendColor),e.blendAlpha!==void 0&&(this.blendAlpha=e.blendAlpha),e.stencilWriteMask!==void 0&&(this.stencilWriteMask=e.stencilWriteMask),e.stencilFunc!==void 0&&(this.stencilFunc=e.stencilFunc),e.stencilRef!==void 0&&(this.stencilRef=e.stencilRef),e.stencilFuncMask!==void 0&&(this.stencilFuncMask=e.stencilFuncMask),e.stencilFail!==void 0&&(this.stencilFail=e.stencilFail),e.stencilZFail!==void 0&&(this.stencilZFail=e.stencilZFail),e.stencilZPass!==void 0&&(this.stencilZPass=e.stencilZPass),e.stencilWrite!==void 0&&(this.stencilWrite=e.stencilWrite),e.wireframe!==void 0&&(this.wireframe=e.wireframe),e.wireframeLinewidth!==void 0&&(this.wireframeLinewidth=e.wireframeLinewidth),e.wireframeLinecap!==void 0&&(this.wireframeLinecap=e.wireframeLinecap),e.wireframeLinejoin!==void 0&&(this.wireframeLinejoin=e.wireframeLinejoin),e.rotation!==void 0&&(this.rotation=e.rotation),e.linewidth!==void 0&&(this.linewidth=e.linewidth),e.linecap!==void 0&&(this.linecap=e.linecap),e.linejoin!==void 0&&(this.linejoin=e.linejoin),e.dashSize!==void 0&&(this.dashSize=e.dashSize),e.gapSize!==void 0&&(this.gapSize=e.gapSize),e.scale!==void 0&&(this.scale=e.scale),e.polygonOffset!==void 0&&(this.polygonOffset=e.polygonOffset),e.polygonOffsetFactor!==void 0&&(this.polygonOffsetFactor=e.polygonOffsetFactor),e.polygonOffsetUnits!==void 0&&(this.polygonOffsetUnits=e.polygonOffsetUnits),e.dithering!==void 0&&(this.dithering=e.dithering),e.alphaToCoverage!==void 0&&(this.alphaToCoverage=e.alphaToCoverage),e.premultipliedAlpha!==void 0&&(this.premultipliedAlpha=e.premultipliedAlpha),e.forceSinglePass!==void 0&&(this.forceSinglePass=e.forceSinglePass),e.allowOverride!==void 0&&(this.allowOverride=e.allowOverride),e.visible!==void 0&&(this.visible=e.visible),e.toneMapped!==void 0&&(this.toneMapped=e.toneMapped),e.userData!==void 0&&(this.userData=e.userData),e.vertexColors!==void 0&&(typeof e.vertexColors=="number"?this.vertexColors=e.vertexColors>0:this.vertexColors=e.vertexColors),e.size!==void 0&&(this.size=e.size),e.sizeAttenuation!==void 0&&(this.sizeAttenuation=e.sizeAttenuation),e.map!==void 0&&(this.map=t[e.map]||null),e.matcap!==void 0&&(this.matcap=t[e.matcap]||null),e.alphaMap!==void 0&&(this.alphaMap=t[e.alphaMap]||null),e.bumpMap!==void 0&&(this.bumpMap=t[e.bumpMap]||null),e.bumpScale!==void 0&&(this.bumpScale=e.bumpScale),e.normalMap!==void 0&&(this.normalMap=t[e.normalMap]||null),e.normalMapType!==void 0&&(this.normalMapType=e.normalMapType),e.normalScale!==void 0){let n=e.normalScale;Array.isArray(n)===!1&&(n=[n,n]),this.normalScale=new ct().fromArray(n)}return e.displacementMap!==void 0&&(this.displacementMap=t[e.displacementMap]||null),e.displacementScale!==void 0&&(this.displacementScale=e.displacementScale),e.displacementBias!==void 0&&(this.displacementBias=e.displacementBias),e.roughnessMap!==void 0&&(this.roughnessMap=t[e.roughnessMap]||null),e.metalnessMap!==void 0&&(this.metalnessMap=t[e.metalnessMap]||null),e.emissiveMap!==void 0&&(this.emissiveMap=t[e.emissiveMap]||null),e.emissiveIntensity!==void 0&&(this.emissiveIntensity=e.emissiveIntensity),e.specularMap!==void 0&&(this.specularMap=t[e.specularMap]||null),e.specularIntensityMap!==void 0&&(this.specularIntensityMap=t[e.specularIntensityMap]||null),e.specularColorMap!==void 0&&(this.specularColorMap=t[e.specularColorMap]||null),e.envMap!==void 0&&(this.envMap=t[e.envMap]||null),e.envMapRotation!==void 0&&this.envMapRotation.fromArray(e.envMapRotation),e.envMapIntensity!==void 0&&(this.envMapIntensity=e.envMapIntensity),e.reflectivity!==void 0&&(this.reflectivity=e.reflectivity),e.refractionRatio!==void 0&&(this.refractionRatio=e.refractionRatio),e.lightMap!==void 0&&(this.lightMap=t[e.lightMap]||null),e.lightMapIntensity!==void 0&&(this.lightMapIntensity=e.lightMapIntensity),e.aoMap!==void 0&&(this.aoMap=t[e.aoMap]||null),e.aoMapIntensity!==void 0&&(this.aoMapIntensity=e.aoMapIntensity),e.gradientMap!==void 0&&(this.gradientMap=t[e.gradientMap]||null),e.clearcoatMap!==void 0&&(this.clearcoatMap=t[e.clearcoatMap]||null),e.clearcoatRoughnessMap!==void 0&&(this.clearcoatRoughnessMap=t[e.clearcoatRoughnessMap]||null),e.clearcoatNormalMap!==void 0&&(this.clearcoatNormalMap=t[e.clearcoatNormalMap]||null),e.clearcoatNormalScale!==void 0&&(this.clearcoatNormalScale=new ct().fromArray(e.clearcoatNormalScale)),e.diffuseRoughnessMap!==void 0&&(this.diffuseRoughnessMap=t[e.diffuseRoughnessMap]||null),e.iridescenceMap!==void 0&&(this.iridescenceMap=t[e.iridescenceMap]||null),e.iridescenceThicknessMap!==void 0&&(this.iridescenceThicknessMap=t[e.iridescenceThicknessMap]||null),e.transmissionMap!==void 0&&(this.transmissionMap=t[e.transmissionMap]||null),e.thicknessMap!==void 0&&(this.thicknessMap=t[e.thicknessMap]||null),e.anisotropyMap!==void 0&&(this.anisotropyMap=t[e.anisotropyMap]||null),e.sheenColorMap!==void 0&&(this.sheenColorMap=t[e.sheenColorMap]||null),e.sheenRoughnessMap!==void 0&&(this.sheenRoughnessMap=t[e.sheenRoughnessMap]||null),this}clone(){return new this.constructor().copy(this)}copy(e){this.name=e.name,this.blending=e.blending,this.side=e.side,this.vertexColors=e.vertexColors,this.opacity=e.opacity,this.transparent=e.transparent,this.blendSrc=e.blendSrc,this.blendDst=e.blendDst,this.blendEquation=e.blendEquation,this.blendSrcAlpha=e.blendSrcAlpha,this.blendDstAlpha=e.blendDstAlpha,this.blendEquationAlpha=e.blendEquationAlpha,this.blendColor.copy(e.blendColor),this.blendAlpha=e.blendAlpha,this.depthFunc=e.depthFunc,this.depthTest=e.depthTest,this.depthWrite=e.depthWrite,this.stencilWriteMask=e.stencilWriteMask,this.stencilFunc=e.stencilFunc,this.stencilRef=e.stencilRef,this.stencilFuncMask=e.stencilFuncMask,this.stencilFail=e.stencilFail,this.stencilZFail=e.stencilZFail,this.stencilZPass=e.stencilZPass,this.stencilWrite=e.stencilWrite;let t=e.clippingPlanes,n=null;if(t!==null){let s=t.length;n=new Array(s);for(let r=0;r!==s;++r)n[r]=t[r].clone()}return this.clippingPlanes=n,this.clipIntersection=e.clipIntersection,this.clipShadows=e.clipShadows,this.shadowSide=e.shadowSide,this.colorWrite=e.colorWrite,this.precision=e.precision,this.polygonOffset=e.polygonOffset,this.polygonOffsetFactor=e.polygonOffsetFactor,this.polygonOffsetUnits=e.polygonOffsetUnits,this.dithering=e.dithering,this.alphaTest=e.alphaTest,this.alphaHash=e.alphaHash,this.alphaToCoverage=e.alphaToCoverage,this.premultipliedAlpha=e.premultipliedAlpha,this.forceSinglePass=e.forceSinglePass,this.allowOverride=e.allowOverride,this.visible=e.visible,this.toneMapped=e.toneMapped,this.userData=JSON.parse(JSON.stringify(e.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(e){e===!0&&this.version++}};var ls=new Y,Lu=new Y,No=new Y,Fo=new Y,cl=class{constructor(e=new Y,t=new Y(0,0,-1)){this.origin=e,this.direction=t}set(e,t){return this.origin.copy(e),this.direction.copy(t),this}copy(e){return this.origin.copy(e.origin),this.direction.copy(e.direction),this}at(e,t){return t.copy(this.origin).addScaledVector(this.direction,e)}lookAt(e){return this.direction.copy(e).sub(this.origin).normalize(),this}recast(e){return this.origin.copy(this.at(e,ls)),this}closestPointToPoint(e,t){t.subVectors(e,this.origin);let n=t.dot(this.direction);return n<0?t.copy(this.origin):t.copy(this.origin).addScaledVector(this.direction,n)}distanceToPoint(e){return Math.sqrt(this.distanceSqToPoint(e))}distanceSqToPoint(e){let t=ls.subVectors(e,this.origin).dot(this.direction);return t<0?this.origin.distanceToSquared(e):(ls.copy(this.origin).addScaledVector(this.direction,t),ls.distanceToSquared(e))}distanceSqToSegment(e,t,n,s){Lu.copy(e).add(t).multiplyScalar(.5),No.copy(t).sub(e).normalize(),Fo.copy(this.origin).sub(Lu);let r=e.distanceTo(t)*.5,a=-this.direction.dot(No),o=Fo.dot(this.direction),l=-Fo.dot(No),c=Fo.lengthSq(),u=Math.abs(1-a*a),f,h,d,g;if(u>0)if(f=a*l-o,h=a*o-l,g=r*u,f>=0)if(h>=-g)if(h<=g){let b=1/u;f*=b,h*=b,d=f*(f+a*h+2*o)+h*(a*f+h+2*l)+c}else h=r,f=Math.max(0,-(a*h+o)),d=-f*f+h*(h+2*l)+c;else h=-r,f=Math.max(0,-(a*h+o)),d=-f*f+h*(h+2*l)+c;else h<=-g?(f=Math.max(0,-(-a*r+o)),h=f>0?-r:Math.min(Math.max(-r,-l),r),d=-f*f+h*(h+2*l)+c):h<=g?(f=0,h=Math.min(Math.max(-r,-l),r),d=h*(h+2*l)+c):(f=Math.max(0,-(a*r+o)),h=f>0?r:Math.min(Math.max(-r,-l),r),d=-f*f+h*(h+2*l)+c);else h=a>0?-r:r,f=Math.max(0,-(a*h+o)),d=-f*f+h*(h+2*l)+c;return n&&n.copy(this.origin).addScaledVector(this.direction,f),s&&s.copy(Lu).addScaledVector(No,h),d}intersectSphere(e,t){if(e.radius<0)return null;ls.subVectors(e.center,this.origin);let n=ls.dot(this.direction),s=ls.dot(ls)-n*n,r=e.radius*e.radius;if(s>r)return null;let a=Math.sqrt(r-s),o=n-a,l=n+a;return l<0?null:o<0?this.at(l,t):this.at(o,t)}intersectsSphere(e){return e.radius<0?!1:this.distanceSqToPoint(e.center)<=e.radius*e.radius}distanceToPlane(e){let t=e.normal.dot(this.direction);if(t===0)return e.distanceToPoint(this.origin)===0?0:null;let n=-(this.origin.dot(e.normal)+e.constant)/t;return n>=0?n:null}intersectPlane(e,t){let n=this.distanceToPlane(e);return n===null?null:this.at(n,t)}intersectsPlane(e){let t=e.distanceToPoint(this.origin);return t===0||e.normal.dot(this.direction)*t<0}intersectBox(e,t){let n,s,r,a,o,l,c=1/this.direction.x,u=1/this.direction.y,f=1/this.direction.z,h=this.origin;return c>=0?(n=(e.min.x-h.x)*c,s=(e.max.x-h.x)*c):(n=(e.max.x-h.x)*c,s=(e.min.x-h.x)*c),u>=0?(r=(e.min.y-h.y)*u,a=(e.max.y-h.y)*u):(r=(e.max.y-h.y)*u,a=(e.min.y-h.y)*u),n>a||r>s||((r>n||isNaN(n))&&(n=r),(a<s||isNaN(s))&&(s=a),f>=0?(o=(e.min.z-h.z)*f,l=(e.max.z-h.z)*f):(o=(e.max.z-h.z)*f,l=(e.min.z-h.z)*f),n>l||o>s)||((o>n||n!==n)&&(n=o),(l<s||s!==s)&&(s=l),s<0)?null:this.at(n>=0?n:s,t)}intersectsBox(e){return this.intersectBox(e,ls)!==null}intersectTriangle(e,t,n,s,r){let a=this.origin,o=this.direction,l=o.x,c=o.y,u=o.z,f=e.x-a.x,h=e.y-a.y,d=e.z-a.z,g=t.x-a.x,b=t.y-a.y,m=t.z-a.z,p=n.x-a.x,v=n.y-a.y,E=n.z-a.z,S=Math.abs(l),R=Math.abs(c),A=Math.abs(u),x,T,k,N,L,G,H,D,V,Z,z,le;if(S>=R&&S>=A?(k=l,G=f,V=g,le=p,l>=0?(x=c,T=u,N=h,L=d,H=b,D=m,Z=v,z=E):(x=u,T=c,N=d,L=h,H=m,D=b,Z=E,z=v)):R>=A?(k=c,G=h,V=b,le=v,c>=0?(x=u,T=l,N=d,L=f,H=m,D=g,Z=E,z=p):(x=l,T=u,N=f,L=d,H=g,D=m,Z=p,z=E)):(k=u,G=d,V=m,le=E,u>=0?(x=l,T=c,N=f,L=h,H=g,D=b,Z=p,z=v):(x=c,T=l,N=h,L=f,H=b,D=g,Z=v,z=p)),k===0)return null;let J=x/k,Q=T/k,ie=1/k,he=N-J*G,ue=L-Q*G,j=H-J*V,me=D-Q*V,xe=Z-J*le,Ee=z-Q*le,Se=xe*me-Ee*j,He=he*Ee-ue*xe,nt=j*ue-me*he;if(s){if(Se<0||He<0||nt<0)return null}else if((Se<0||He<0||nt<0)&&(Se>0||He>0||nt>0))return null;let Ve=Se+He+nt;if(Ve===0)return null;let lt=ie*(Se*G+He*V+nt*le);return(Ve>0?lt<0:lt>0)?null:this.at(lt/Ve,r)}applyMatrix4(e){return this.origin.applyMatrix4(e),this.direction.transformDirection(e),this}equals(e){return e.origin.equals(this.origin)&&e.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},ul=class extends Ks{constructor(e){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new vt(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Ps,this.combine=qu,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.fog=e.fog,this}},ud=new dt,Ys=new cl,Uo=new Hr,hd=new Y,Oo=new Y,Bo=new Y,zo=new Y,Du=new Y,ko=new Y,fd=new Y,Vo=new Y,pi=class extends fi{constructor(e=new di,t=new ul){super(),this.isMesh=!0,this.type="Mesh",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}updateMorphTargets(){let t=this.geometry.morphAttributes,n=Object.keys(t);if(n.length>0){let s=t[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,a=s.length;r<a;r++){let o=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[o]=r}}}}getVertexPosition(e,t){let n=this.geometry,s=n.attributes.position,r=n.morphAttributes.position,a=n.morphTargetsRelative;t.fromBufferAttribute(s,e);let o=this.morphTargetInfluences;if(r&&o){ko.set(0,0,0);for(let l=0,c=r.length;l<c;l++){let u=o[l],f=r[l];u!==0&&(Du.fromBufferAttribute(f,e),a?ko.addScaledVector(Du,u):ko.addScaledVector(Du.sub(t),u))}t.add(ko)}return t}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let n=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(n.boundingSphere===null&&n.computeBoundingSphere(),Uo.copy(n.boundingSphere),Uo.applyMatrix4(r),Ys.copy(e.ray).recast(e.near),!(Uo.containsPoint(Ys.origin)===!1&&(Ys.intersectSphere(Uo,hd)===null||Ys.origin.distanceToSquared(hd)>(e.far-e.near)**2))&&(ud.copy(r).invert(),Ys.copy(e.ray).applyMatrix4(ud),!(n.boundingBox!==null&&Ys.intersectsBox(n.boundingBox)===!1)&&this._computeIntersections(e,t,Ys)))}_computeIntersections(e,t,n){let s,r=this.geometry,a=this.material,o=r.index,l=r.attributes.position,c=r.attributes.uv,u=r.attributes.uv1,f=r.attributes.normal,h=r.groups,d=r.drawRange;if(o!==null)if(Array.isArray(a))for(let g=0,b=h.length;g<b;g++){let m=h[g],p=a[m.materialIndex],v=Math.max(m.start,d.start),E=Math.min(o.count,Math.min(m.start+m.count,d.start+d.count));for(let S=v,R=E;S<R;S+=3){let A=o.getX(S),x=o.getX(S+1),T=o.getX(S+2);s=Go(this,p,e,n,c,u,f,A,x,T),s&&(s.faceIndex=Math.floor(S/3),s.face.materialIndex=m.materialIndex,t.push(s))}}else{let g=Math.max(0,d.start),b=Math.min(o.count,d.start+d.count);for(let m=g,p=b;m<p;m+=3){let v=o.getX(m),E=o.getX(m+1),S=o.getX(m+2);s=Go(this,a,e,n,c,u,f,v,E,S),s&&(s.faceIndex=Math.floor(m/3),t.push(s))}}else if(l!==void 0)if(Array.isArray(a))for(let g=0,b=h.length;g<b;g++){let m=h[g],p=a[m.materialIndex],v=Math.max(m.start,d.start),E=Math.min(l.count,Math.min(m.start+m.count,d.start+d.count));for(let S=v,R=E;S<R;S+=3){let A=S,x=S+1,T=S+2;s=Go(this,p,e,n,c,u,f,A,x,T),s&&(s.faceIndex=Math.floor(S/3),s.face.materialIndex=m.materialIndex,t.push(s))}}else{let g=Math.max(0,d.start),b=Math.min(l.count,d.start+d.count);for(let m=g,p=b;m<p;m+=3){let v=m,E=m+1,S=m+2;s=Go(this,a,e,n,c,u,f,v,E,S),s&&(s.faceIndex=Math.floor(m/3),t.push(s))}}}};function c_(i,e,t,n,s,r,a,o){let l;if(e.side===Vn?l=n.intersectTriangle(a,r,s,!0,o):l=n.intersectTriangle(s,r,a,e.side===Fs,o),l===null)return null;Vo.copy(o),Vo.applyMatrix4(i.matrixWorld);let c=t.ray.origin.distanceTo(Vo);return c<t.near||c>t.far?null:{distance:c,point:Vo.clone(),object:i}}function Go(i,e,t,n,s,r,a,o,l,c){i.getVertexPosition(o,Oo),i.getVertexPosition(l,Bo),i.getVertexPosition(c,zo);let u=c_(i,e,t,n,Oo,Bo,zo,fd);if(u){let f=new Y;Cs.getBarycoord(fd,Oo,Bo,zo,f),s&&(u.uv=Cs.getInterpolatedAttribute(s,o,l,c,f,new ct)),r&&(u.uv1=Cs.getInterpolatedAttribute(r,o,l,c,f,new ct)),a&&(u.normal=Cs.getInterpolatedAttribute(a,o,l,c,f,new Y),u.normal.dot(n.direction)>0&&u.normal.multiplyScalar(-1));let h={a:o,b:l,c,normal:new Y,materialIndex:0};Cs.getNormal(Oo,Bo,zo,h.normal),u.face=h,u.barycoord=f}return u}var mi=class extends Hn{constructor(e=null,t=1,n=1,s,r,a,o,l,c=Mt,u=Mt,f,h){super(null,a,o,l,c,u,s,r,f,h),this.isDataTexture=!0,this.image={data:e,width:t,height:n},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var $s=new Hr,u_=new ct(.5,.5),Ho=new Y,Qs=class{constructor(e=new wi,t=new wi,n=new wi,s=new wi,r=new wi,a=new wi){this.planes=[e,t,n,s,r,a]}set(e,t,n,s,r,a){let o=this.planes;return o[0].copy(e),o[1].copy(t),o[2].copy(n),o[3].copy(s),o[4].copy(r),o[5].copy(a),this}copy(e){let t=this.planes;for(let n=0;n<6;n++)t[n].copy(e.planes[n]);return this}setFromProjectionMatrix(e,t=ui,n=!1){let s=this.planes,r=e.elements,a=r[0],o=r[1],l=r[2],c=r[3],u=r[4],f=r[5],h=r[6],d=r[7],g=r[8],b=r[9],m=r[10],p=r[11],v=r[12],E=r[13],S=r[14],R=r[15];if(s[0].setComponents(c-a,d-u,p-g,R-v).normalize(),s[1].setComponents(c+a,d+u,p+g,R+v).normalize(),s[2].setComponents(c+o,d+f,p+b,R+E).normalize(),s[3].setComponents(c-o,d-f,p-b,R-E).normalize(),n)s[4].setComponents(l,h,m,S).normalize(),s[5].setComponents(c-l,d-h,p-m,R-S).normalize();else if(s[4].setComponents(c-l,d-h,p-m,R-S).normalize(),t===ui)s[5].setComponents(c+l,d+h,p+m,R+S).normalize();else if(t===Da)s[5].setComponents(l,h,m,S).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+t);return this}intersectsObject(e){if(e.boundingSphere!==void 0)e.boundingSphere===null&&e.computeBoundingSphere(),$s.copy(e.boundingSphere).applyMatrix4(e.matrixWorld);else{let t=e.geometry;t.boundingSphere===null&&t.computeBoundingSphere(),$s.copy(t.boundingSphere).applyMatrix4(e.matrixWorld)}return this.intersectsSphere($s)}intersectsSprite(e){$s.center.set(0,0,0);let t=u_.distanceTo(e.center);return $s.radius=.7071067811865476+t,$s.applyMatrix4(e.matrixWorld),this.intersectsSphere($s)}intersectsSphere(e){let t=this.planes,n=e.center,s=-e.radius;for(let r=0;r<6;r++)if(t[r].distanceToPoint(n)<s)return!1;return!0}intersectsBox(e){let t=this.planes;for(let n=0;n<6;n++){let s=t[n];if(Ho.x=s.normal.x>0?e.max.x:e.min.x,Ho.y=s.normal.y>0?e.max.y:e.min.y,Ho.z=s.normal.z>0?e.max.z:e.min.z,s.distanceToPoint(Ho)<0)return!1}return!0}containsPoint(e){let t=this.planes;for(let n=0;n<6;n++)if(t[n].distanceToPoint(e)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}},dd=new dt,hl=class i{constructor(){this.coordinateSystem=ui,this._frustums=[],this._count=0}setFromArrayCamera(e){let t=e.cameras,n=this._frustums;for(let s=0;s<t.length;s++){let r=t[s];dd.multiplyMatrices(r.projectionMatrix,r.matrixWorldInverse),n[s]===void 0&&(n[s]=new Qs),n[s].setFromProjectionMatrix(dd,r.coordinateSystem,r.reversedDepth)}return this._count=t.length,this}getFrustum(e){return this._frustums[e]}intersectsObject(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsObject(e))return!0;return!1}intersectsSprite(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsSprite(e))return!0;return!1}intersectsSphere(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsSphere(e))return!0;return!1}intersectsBox(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsBox(e))return!0;return!1}containsPoint(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].containsPoint(e))return!0;return!1}copy(e){this.coordinateSystem=e.coordinateSystem;let t=this._frustums,n=e._frustums;for(let s=0;s<e._count;s++)t[s]===void 0&&(t[s]=new Qs),t[s].copy(n[s]);return this._count=e._count,this}clone(){return new i().copy(this)}};var za=class extends Hn{constructor(e=[],t=nr,n,s,r,a,o,l,c,u){super(e,t,n,s,r,a,o,l,c,u),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(e){this.image=e}};var Ti=class extends Hn{constructor(e,t,n=Ai,s,r,a,o=Mt,l=Mt,c,u=us,f=1){if(u!==us&&u!==fs)throw new Error("THREE.DepthTexture: format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let h={width:e,height:t,depth:f};super(h,s,r,a,o,l,u,n,c),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(e){return super.copy(e),this.source=new Vr(Object.assign({},e.image)),this.compareFunction=e.compareFunction,this}toJSON(e){let t=super.toJSON(e);return t.compareFunction=this.compareFunction,t}},ka=class extends Ti{constructor(e,t=Ai,n=nr,s,r,a=Mt,o=Mt,l,c=us){let u={width:e,height:e,depth:1},f=[u,u,u,u,u,u];super(e,e,t,n,s,r,a,o,l,c),this.image=f,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(e){this.image=e}},Va=class extends Hn{constructor(e=null){super(),this.sourceTexture=e,this.isExternalTexture=!0}copy(e){return super.copy(e),this.sourceTexture=e.sourceTexture,this}},Wr=class i extends di{constructor(e=1,t=1,n=1,s=1,r=1,a=1){super(),this.type="BoxGeometry",this.parameters={width:e,height:t,depth:n,widthSegments:s,heightSegments:r,depthSegments:a};let o=this;s=Math.floor(s),r=Math.floor(r),a=Math.floor(a);let l=[],c=[],u=[],f=[],h=0,d=0;g("z","y","x",-1,-1,n,t,e,a,r,0),g("z","y","x",1,-1,n,t,-e,a,r,1),g("x","z","y",1,1,e,n,t,s,a,2),g("x","z","y",1,-1,e,n,-t,s,a,3),g("x","y","z",1,-1,e,t,n,s,r,4),g("x","y","z",-1,-1,e,t,-n,s,r,5),this.setIndex(l),this.setAttribute("position",new hi(c,3)),this.setAttribute("normal",new hi(u,3)),this.setAttribute("uv",new hi(f,2));function g(b,m,p,v,E,S,R,A,x,T,k){let N=S/x,L=R/T,G=S/2,H=R/2,D=A/2,V=x+1,Z=T+1,z=0,le=0,J=new Y;for(let Q=0;Q<Z;Q++){let ie=Q*L-H;for(let he=0;he<V;he++){let ue=he*N-G;J[b]=ue*v,J[m]=ie*E,J[p]=D,c.push(J.x,J.y,J.z),J[b]=0,J[m]=0,J[p]=A>0?1:-1,u.push(J.x,J.y,J.z),f.push(he/x),f.push(1-Q/T),z+=1}}for(let Q=0;Q<T;Q++)for(let ie=0;ie<x;ie++){let he=h+ie+V*Q,ue=h+ie+V*(Q+1),j=h+(ie+1)+V*(Q+1),me=h+(ie+1)+V*Q;l.push(he,ue,me),l.push(ue,j,me),le+=6}o.addGroup(d,le,k),d+=le,h+=z}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.width,e.height,e.depth,e.widthSegments,e.heightSegments,e.depthSegments)}};var Ga=class i extends di{constructor(e=1,t=1,n=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:e,height:t,widthSegments:n,heightSegments:s};let r=e/2,a=t/2,o=Math.floor(n),l=Math.floor(s),c=o+1,u=l+1,f=e/o,h=t/l,d=[],g=[],b=[],m=[];for(let p=0;p<u;p++){let v=p*h-a;for(let E=0;E<c;E++){let S=E*f-r;g.push(S,-v,0),b.push(0,0,1),m.push(E/o),m.push(1-p/l)}}for(let p=0;p<l;p++)for(let v=0;v<o;v++){let E=v+c*p,S=v+c*(p+1),R=v+1+c*(p+1),A=v+1+c*p;d.push(E,S,A),d.push(S,R,A)}this.setIndex(d),this.setAttribute("position",new hi(g,3)),this.setAttribute("normal",new hi(b,3)),this.setAttribute("uv",new hi(m,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.width,e.height,e.widthSegments,e.heightSegments)}};function sr(i){let e={};for(let t in i){e[t]={};for(let n in i[t]){let s=i[t][n];if(pd(s))s.isRenderTargetTexture?($e("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),e[t][n]=null):e[t][n]=s.clone();else if(Array.isArray(s))if(pd(s[0])){let r=[];for(let a=0,o=s.length;a<o;a++)r[a]=s[a].clone();e[t][n]=r}else e[t][n]=s.slice();else e[t][n]=s}}return e}function Dn(i){let e={};for(let t=0;t<i.length;t++){let n=sr(i[t]);for(let s in n)e[s]=n[s]}return e}function pd(i){return i&&(i.isColor||i.isMatrix3||i.isMatrix4||i.isVector2||i.isVector3||i.isVector4||i.isTexture||i.isQuaternion)}function h_(i){let e=[];for(let t=0;t<i.length;t++)e.push(i[t].clone());return e}function ph(i){let e=i.getRenderTarget();return e===null?i.outputColorSpace:e.isXRRenderTarget===!0?e.texture.colorSpace:mt.workingColorSpace}var sp={clone:sr,merge:Dn},f_=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,d_=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,Gi=class extends Ks{constructor(e){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=f_,this.fragmentShader=d_,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,e!==void 0&&this.setValues(e)}copy(e){return super.copy(e),this.fragmentShader=e.fragmentShader,this.vertexShader=e.vertexShader,this.uniforms=sr(e.uniforms),this.uniformsGroups=h_(e.uniformsGroups),this.defines=Object.assign({},e.defines),this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.fog=e.fog,this.lights=e.lights,this.clipping=e.clipping,this.extensions=Object.assign({},e.extensions),this.glslVersion=e.glslVersion,this.defaultAttributeValues=Object.assign({},e.defaultAttributeValues),this.index0AttributeName=e.index0AttributeName,this.uniformsNeedUpdate=e.uniformsNeedUpdate,this}toJSON(e){let t=super.toJSON(e);t.glslVersion=this.glslVersion,t.uniforms={};for(let s in this.uniforms){let a=this.uniforms[s].value;a&&a.isTexture?t.uniforms[s]={type:"t",value:a.toJSON(e).uuid}:a&&a.isColor?t.uniforms[s]={type:"c",value:a.getHex()}:a&&a.isVector2?t.uniforms[s]={type:"v2",value:a.toArray()}:a&&a.isVector3?t.uniforms[s]={type:"v3",value:a.toArray()}:a&&a.isVector4?t.uniforms[s]={type:"v4",value:a.toArray()}:a&&a.isMatrix3?t.uniforms[s]={type:"m3",value:a.toArray()}:a&&a.isMatrix4?t.uniforms[s]={type:"m4",value:a.toArray()}:t.uniforms[s]={value:a}}Object.keys(this.defines).length>0&&(t.defines=this.defines),t.vertexShader=this.vertexShader,t.fragmentShader=this.fragmentShader,t.lights=this.lights,t.clipping=this.clipping;let n={};for(let s in this.extensions)this.extensions[s]===!0&&(n[s]=!0);return Object.keys(n).length>0&&(t.extensions=n),t}fromJSON(e,t){if(super.fromJSON(e,t),e.uniforms!==void 0)for(let n in e.uniforms){let s=e.uniforms[n];switch(this.uniforms[n]={},s.type){case"t":this.uniforms[n].value=t[s.value]||null;break;case"c":this.uniforms[n].value=new vt().setHex(s.value);break;case"v2":this.uniforms[n].value=new ct().fromArray(s.value);break;case"v3":this.uniforms[n].value=new Y().fromArray(s.value);break;case"v4":this.uniforms[n].value=new Lt().fromArray(s.value);break;case"m3":this.uniforms[n].value=new je().fromArray(s.value);break;case"m4":this.uniforms[n].value=new dt().fromArray(s.value);break;default:this.uniforms[n].value=s.value}}if(e.defines!==void 0&&(this.defines=e.defines),e.vertexShader!==void 0&&(this.vertexShader=e.vertexShader),e.fragmentShader!==void 0&&(this.fragmentShader=e.fragmentShader),e.glslVersion!==void 0&&(this.glslVersion=e.glslVersion),e.extensions!==void 0)for(let n in e.extensions)this.extensions[n]=e.extensions[n];return e.lights!==void 0&&(this.lights=e.lights),e.clipping!==void 0&&(this.clipping=e.clipping),this}},Xr=class extends Gi{constructor(e){super(e),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}};var fl=class extends Ks{constructor(e){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=Hd,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(e)}copy(e){return super.copy(e),this.depthPacking=e.depthPacking,this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this}},dl=class extends Ks{constructor(e){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(e)}copy(e){return super.copy(e),this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this}};function Fr(i,e){return!i||i.constructor===e?i:typeof e.BYTES_PER_ELEMENT=="number"?new e(i):Array.prototype.slice.call(i)}function Wo(i){return i!==void 0&&i.inTangents!==void 0&&i.outTangents!==void 0}var Ls=class{constructor(e,t,n,s){this.parameterPositions=e,this._cachedIndex=0,this.resultBuffer=s!==void 0?s:new t.constructor(n),this.sampleValues=t,this.valueSize=n,this.settings=null,this.DefaultSettings_={}}evaluate(e){let t=this.parameterPositions,n=this._cachedIndex,s=t[n],r=t[n-1];n:{e:{let a;t:{i:if(!(e<s)){for(let o=n+2;;){if(s===void 0){if(e<r)break i;return n=t.length,this._cachedIndex=n,this.copySampleValue_(n-1)}if(n===o)break;if(r=s,s=t[++n],e<s)break e}a=t.length;break t}if(!(e>=r)){let o=t[1];e<o&&(n=2,r=o);for(let l=n-2;;){if(r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(n===l)break;if(s=r,r=t[--n-1],e>=r)break e}a=n,n=0;break t}break n}for(;n<a;){let o=n+a>>>1;e<t[o]?a=o:n=o+1}if(s=t[n],r=t[n-1],r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(s===void 0)return n=t.length,this._cachedIndex=n,this.copySampleValue_(n-1)}this._cachedIndex=n,this.intervalChanged_(n,r,s)}return this.interpolate_(n,r,e,s)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(e){let t=this.resultBuffer,n=this.sampleValues,s=this.valueSize,r=e*s;for(let a=0;a!==s;++a)t[a]=n[r+a];return t}interpolate_(){throw new Error("THREE.Interpolant: Call to abstract method.")}intervalChanged_(){}},pl=class extends Ls{constructor(e,t,n,s){super(e,t,n,s),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:Fu,endingEnd:Fu}}intervalChanged_(e,t,n){let s=this.parameterPositions,r=e-2,a=e+1,o=s[r],l=s[a];if(o===void 0)switch(this.getSettings_().endingStart){case Uu:r=e,o=2*t-n;break;case Ou:r=s.length-2,o=t+s[r]-s[r+1];break;default:r=e,o=n}if(l===void 0)switch(this.getSettings_().endingEnd){case Uu:a=e,l=2*n-t;break;case Ou:a=1,l=n+s[1]-s[0];break;default:a=e-1,l=t}let c=(n-t)*.5,u=this.valueSize;this._weightPrev=c/(t-o),this._weightNext=c/(l-n),this._offsetPrev=r*u,this._offsetNext=a*u}interpolate_(e,t,n,s){let r=this.resultBuffer,a=this.sampleValues,o=this.valueSize,l=e*o,c=l-o,u=this._offsetPrev,f=this._offsetNext,h=this._weightPrev,d=this._weightNext,g=(n-t)/(s-t),b=g*g,m=b*g,p=-h*m+2*h*b-h*g,v=(1+h)*m+(-1.5-2*h)*b+(-.5+h)*g+1,E=(-1-d)*m+(1.5+d)*b+.5*g,S=d*m-d*b;for(let R=0;R!==o;++R)r[R]=p*a[u+R]+v*a[c+R]+E*a[l+R]+S*a[f+R];return r}},ml=class extends Ls{constructor(e,t,n,s){super(e,t,n,s)}interpolate_(e,t,n,s){let r=this.resultBuffer,a=this.sampleValues,o=this.valueSize,l=e*o,c=l-o,u=(n-t)/(s-t),f=1-u;for(let h=0;h!==o;++h)r[h]=a[c+h]*f+a[l+h]*u;return r}},gl=class extends Ls{constructor(e,t,n,s){super(e,t,n,s)}interpolate_(e){return this.copySampleValue_(e-1)}},_l=class extends Ls{interpolate_(e,t,n,s){let r=this.resultBuffer,a=this.sampleValues,o=this.valueSize,l=e*o,c=l-o,u=this.inTangents,f=this.outTangents;if(!u||!f){let g=(n-t)/(s-t),b=1-g;for(let m=0;m!==o;++m)r[m]=a[c+m]*b+a[l+m]*g;return r}let h=o*2,d=e-1;for(let g=0;g!==o;++g){let b=a[c+g],m=a[l+g],p=d*h+g*2,v=f[p],E=f[p+1],S=e*h+g*2,R=u[S],A=u[S+1],x=m_(n,t,v,R,s);r[g]=rp(x,b,E,A,m)}return r}};function rp(i,e,t,n,s){let r=1-i;return r*r*r*e+3*r*r*i*t+3*r*i*i*n+i*i*i*s}function p_(i,e,t,n,s){let r=1-i;return 3*r*r*(t-e)+6*r*i*(n-t)+3*i*i*(s-n)}function m_(i,e,t,n,s){let r=(i-e)/(s-e);for(let a=0;a<8;a++){let o=rp(r,e,t,n,s)-i;if(Math.abs(o)<1e-10)break;let l=p_(r,e,t,n,s);if(Math.abs(l)<1e-10)break;r=Math.max(0,Math.min(1,r-o/l))}return r}var ti=class{constructor(e,t,n,s){if(e===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(t===void 0||t.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+e);this.name=e,this.times=Fr(t,this.TimeBufferType),this.values=Fr(n,this.ValueBufferType),this.setInterpolation(s||this.DefaultInterpolation)}static toJSON(e){let t=e.constructor,n;if(t.toJSON!==this.toJSON)n=t.toJSON(e);else{n={name:e.name,times:Fr(e.times,Array),values:Fr(e.values,Array)};let s=e.getInterpolation();s!==e.DefaultInterpolation&&(n.interpolation=s),Wo(e.settings)&&(n.settings={inTangents:Fr(e.settings.inTangents,Array),outTangents:Fr(e.settings.outTangents,Array)})}return n.type=e.ValueTypeName,n}InterpolantFactoryMethodDiscrete(e){return new gl(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodLinear(e){return new ml(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodSmooth(e){return new pl(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodBezier(e){let t=new _l(this.times,this.values,this.getValueSize(),e);return this.settings&&(t.inTangents=this.settings.inTangents,t.outTangents=this.settings.outTangents),t}setInterpolation(e){let t;switch(e){case Pa:t=this.InterpolantFactoryMethodDiscrete;break;case sl:t=this.InterpolantFactoryMethodLinear;break;case Yo:t=this.InterpolantFactoryMethodSmooth;break;case Nu:t=this.InterpolantFactoryMethodBezier;break}if(t===void 0){let n="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(e!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(n);return $e("KeyframeTrack:",n),this}return this.createInterpolant=t,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return Pa;case this.InterpolantFactoryMethodLinear:return sl;case this.InterpolantFactoryMethodSmooth:return Yo;case this.InterpolantFactoryMethodBezier:return Nu}}getValueSize(){return this.values.length/this.times.length}shift(e){if(e!==0){let t=this.times;for(let n=0,s=t.length;n!==s;++n)t[n]+=e;Wo(this.settings)&&(md(this.settings.inTangents,e),md(this.settings.outTangents,e))}return this}scale(e){if(e!==1){let t=this.times;for(let n=0,s=t.length;n!==s;++n)t[n]*=e;Wo(this.settings)&&(gd(this.settings.inTangents,e),gd(this.settings.outTangents,e))}return this}trim(e,t){let n=this.times,s=n.length,r=0,a=s-1;for(;r!==s&&n[r]<e;)++r;for(;a!==-1&&n[a]>t;)--a;if(++a,r!==0||a!==s){r>=a&&(a=Math.max(a,1),r=a-1);let o=this.getValueSize();this.times=n.slice(r,a),this.values=this.values.slice(r*o,a*o)}return this}validate(){let e=!0,t=this.getValueSize();t-Math.floor(t)!==0&&(Qe("KeyframeTrack: Invalid value size in track.",this),e=!1);let n=this.times,s=this.values,r=n.length;r===0&&(Qe("KeyframeTrack: Track is empty.",this),e=!1);let a=null;for(let o=0;o!==r;o++){let l=n[o];if(typeof l=="number"&&isNaN(l)){Qe("KeyframeTrack: Time is not a valid number.",this,o,l),e=!1;break}if(a!==null&&a>l){Qe("KeyframeTrack: Out of order keys.",this,o,l,a),e=!1;break}a=l}if(s!==void 0&&Hg(s))for(let o=0,l=s.length;o!==l;++o){let c=s[o];if(isNaN(c)){Qe("KeyframeTrack: Value is not a valid number.",this,o,c),e=!1;break}}return e}optimize(){let e=this.times.slice(),t=this.values.slice(),n=this.getValueSize(),s=this.getInterpolation()===Yo,r=e.length-1,a=1;for(let o=1;o<r;++o){let l=!1,c=e[o],u=e[o+1];if(c!==u&&(o!==1||c!==e[0]))if(s)l=!0;else{let f=o*n,h=f-n,d=f+n;for(let g=0;g!==n;++g){let b=t[f+g];if(b!==t[h+g]||b!==t[d+g]){l=!0;break}}}if(l){if(o!==a){e[a]=e[o];let f=o*n,h=a*n;for(let d=0;d!==n;++d)t[h+d]=t[f+d]}++a}}if(r>0){e[a]=e[r];for(let o=r*n,l=a*n,c=0;c!==n;++c)t[l+c]=t[o+c];++a}return a!==e.length?(this.times=e.slice(0,a),this.values=t.slice(0,a*n)):(this.times=e,this.values=t),this}clone(){let e=this.times.slice(),t=this.values.slice(),n=this.constructor,s=new n(this.name,e,t);return s.createInterpolant=this.createInterpolant,Wo(this.settings)&&(s.settings={inTangents:this.settings.inTangents.slice(),outTangents:this.settings.outTangents.slice()}),s}};function md(i,e){for(let t=0,n=i.length;t!==n;t+=2)i[t]+=e}function gd(i,e){for(let t=0,n=i.length;t!==n;t+=2)i[t]*=e}ti.prototype.ValueTypeName="";ti.prototype.TimeBufferType=Float32Array;ti.prototype.ValueBufferType=Float32Array;ti.prototype.DefaultInterpolation=sl;var Ds=class extends ti{constructor(e,t,n){super(e,t,n)}};Ds.prototype.ValueTypeName="bool";Ds.prototype.ValueBufferType=Array;Ds.prototype.DefaultInterpolation=Pa;Ds.prototype.InterpolantFactoryMethodLinear=void 0;Ds.prototype.InterpolantFactoryMethodSmooth=void 0;var xl=class extends ti{constructor(e,t,n,s){super(e,t,n,s)}};xl.prototype.ValueTypeName="color";var vl=class extends ti{constructor(e,t,n,s){super(e,t,n,s)}};vl.prototype.ValueTypeName="number";var yl=class extends Ls{constructor(e,t,n,s){super(e,t,n,s)}interpolate_(e,t,n,s){let r=this.resultBuffer,a=this.sampleValues,o=this.valueSize,l=(n-t)/(s-t),c=e*o;for(let u=c+o;c!==u;c+=4)Vi.slerpFlat(r,0,a,c-o,a,c,l);return r}},Ha=class extends ti{constructor(e,t,n,s){super(e,t,n,s)}InterpolantFactoryMethodLinear(e){return new yl(this.times,this.values,this.getValueSize(),e)}};Ha.prototype.ValueTypeName="quaternion";Ha.prototype.InterpolantFactoryMethodSmooth=void 0;var Ns=class extends ti{constructor(e,t,n){super(e,t,n)}};Ns.prototype.ValueTypeName="string";Ns.prototype.ValueBufferType=Array;Ns.prototype.DefaultInterpolation=Pa;Ns.prototype.InterpolantFactoryMethodLinear=void 0;Ns.prototype.InterpolantFactoryMethodSmooth=void 0;var bl=class extends ti{constructor(e,t,n,s){super(e,t,n,s)}};bl.prototype.ValueTypeName="vector";var Sl=class{constructor(e,t,n){let s=this,r=!1,a=0,o=0,l,c=[];this.onStart=void 0,this.onLoad=e,this.onProgress=t,this.onError=n,this._abortController=null,this.itemStart=function(u){o++,r===!1&&s.onStart!==void 0&&s.onStart(u,a,o),r=!0},this.itemEnd=function(u){a++,s.onProgress!==void 0&&s.onProgress(u,a,o),a===o&&(r=!1,s.onLoad!==void 0&&s.onLoad())},this.itemError=function(u){s.onError!==void 0&&s.onError(u)},this.resolveURL=function(u){return u=u.normalize("NFC"),l?l(u):u},this.setURLModifier=function(u){return l=u,this},this.addHandler=function(u,f){return c.push(u,f),this},this.removeHandler=function(u){let f=c.indexOf(u);return f!==-1&&c.splice(f,2),this},this.getHandler=function(u){for(let f=0,h=c.length;f<h;f+=2){let d=c[f],g=c[f+1];if(d.global&&(d.lastIndex=0),d.test(u))return g}return null},this.abort=function(){return this.abortController.abort(),this._abortController=null,this}}get abortController(){return this._abortController||(this._abortController=new AbortController),this._abortController}},ap=new Sl,Ml=class{constructor(e){this.manager=e!==void 0?e:ap,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={},this.priority="auto",this.cache="default",typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}load(){}loadAsync(e,t){let n=this;return new Promise(function(s,r){n.load(e,s,t,r)})}parse(){}setCrossOrigin(e){return this.crossOrigin=e,this}setWithCredentials(e){return this.withCredentials=e,this}setPath(e){return this.path=e,this}setResourcePath(e){return this.resourcePath=e,this}setRequestHeader(e){return this.requestHeader=e,this}setPriority(e){return this.priority=e,this}setCache(e){return this.cache=e,this}abort(){return this}};Ml.DEFAULT_MATERIAL_NAME="__DEFAULT";var Xo=new Y,qo=new Vi,zi=new Y,js=class extends fi{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new dt,this.projectionMatrix=new dt,this.projectionMatrixInverse=new dt,this.coordinateSystem=ui,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(e,t){return super.copy(e,t),this.matrixWorldInverse.copy(e.matrixWorldInverse),this.projectionMatrix.copy(e.projectionMatrix),this.projectionMatrixInverse.copy(e.projectionMatrixInverse),this.coordinateSystem=e.coordinateSystem,this}getWorldDirection(e){return super.getWorldDirection(e).negate()}updateMatrixWorld(e){super.updateMatrixWorld(e),this.matrixWorld.decompose(Xo,qo,zi),zi.x===1&&zi.y===1&&zi.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(Xo,qo,zi.set(1,1,1)).invert()}updateWorldMatrix(e,t,n=!1){super.updateWorldMatrix(e,t,n),this.matrixWorld.decompose(Xo,qo,zi),zi.x===1&&zi.y===1&&zi.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(Xo,qo,zi.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}},Rs=new Y,_d=new ct,xd=new ct,ei=class extends js{constructor(e=50,t=1,n=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=e,this.zoom=1,this.near=n,this.far=s,this.focus=10,this.aspect=t,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.fov=e.fov,this.zoom=e.zoom,this.near=e.near,this.far=e.far,this.focus=e.focus,this.aspect=e.aspect,this.view=e.view===null?null:Object.assign({},e.view),this.filmGauge=e.filmGauge,this.filmOffset=e.filmOffset,this}setFocalLength(e){let t=.5*this.getFilmHeight()/e;this.fov=rl*2*Math.atan(t),this.updateProjectionMatrix()}getFocalLength(){let e=Math.tan(du*.5*this.fov);return .5*this.getFilmHeight()/e}getEffectiveFOV(){return rl*2*Math.atan(Math.tan(du*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(e,t,n){Rs.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),t.set(Rs.x,Rs.y).multiplyScalar(-e/Rs.z),Rs.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),n.set(Rs.x,Rs.y).multiplyScalar(-e/Rs.z)}getViewSize(e,t){return this.getViewBounds(e,_d,xd),t.subVectors(xd,_d)}setViewOffset(e,t,n,s,r,a){this.aspect=e/t,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=n,this.view.offsetY=s,this.view.width=r,this.view.height=a,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=this.near,t=e*Math.tan(du*.5*this.fov)/this.zoom,n=2*t,s=this.aspect*n,r=-.5*s,a=this.view;if(this.view!==null&&this.view.enabled){let l=a.fullWidth,c=a.fullHeight;r+=a.offsetX*s/l,t-=a.offsetY*n/c,s*=a.width/l,n*=a.height/c}let o=this.filmOffset;o!==0&&(r+=e*o/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,t,t-n,e,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.fov=this.fov,t.object.zoom=this.zoom,t.object.near=this.near,t.object.far=this.far,t.object.focus=this.focus,t.object.aspect=this.aspect,this.view!==null&&(t.object.view=Object.assign({},this.view)),t.object.filmGauge=this.filmGauge,t.object.filmOffset=this.filmOffset,t}};var wl=class extends js{constructor(e=-1,t=1,n=1,s=-1,r=.1,a=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=e,this.right=t,this.top=n,this.bottom=s,this.near=r,this.far=a,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.left=e.left,this.right=e.right,this.top=e.top,this.bottom=e.bottom,this.near=e.near,this.far=e.far,this.zoom=e.zoom,this.view=e.view===null?null:Object.assign({},e.view),this}setViewOffset(e,t,n,s,r,a){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=n,this.view.offsetY=s,this.view.width=r,this.view.height=a,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=(this.right-this.left)/(2*this.zoom),t=(this.top-this.bottom)/(2*this.zoom),n=(this.right+this.left)/2,s=(this.top+this.bottom)/2,r=n-e,a=n+e,o=s+t,l=s-t;if(this.view!==null&&this.view.enabled){let c=(this.right-this.left)/this.view.fullWidth/this.zoom,u=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=c*this.view.offsetX,a=r+c*this.view.width,o-=u*this.view.offsetY,l=o-u*this.view.height}this.projectionMatrix.makeOrthographic(r,a,o,l,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.zoom=this.zoom,t.object.left=this.left,t.object.right=this.right,t.object.top=this.top,t.object.bottom=this.bottom,t.object.near=this.near,t.object.far=this.far,this.view!==null&&(t.object.view=Object.assign({},this.view)),t}};var Ur=-90,Or=1,qr=class extends fi{constructor(e,t,n){super(),this.type="CubeCamera",this.renderTarget=n,this.coordinateSystem=null,this.activeMipmapLevel=0;let s=new ei(Ur,Or,e,t);s.layers=this.layers,this.add(s);let r=new ei(Ur,Or,e,t);r.layers=this.layers,this.add(r);let a=new ei(Ur,Or,e,t);a.layers=this.layers,this.add(a);let o=new ei(Ur,Or,e,t);o.layers=this.layers,this.add(o);let l=new ei(Ur,Or,e,t);l.layers=this.layers,this.add(l);let c=new ei(Ur,Or,e,t);c.layers=this.layers,this.add(c)}updateCoordinateSystem(){let e=this.coordinateSystem,t=this.children.concat(),[n,s,r,a,o,l]=t;for(let c of t)this.remove(c);if(e===ui)n.up.set(0,1,0),n.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),a.up.set(0,0,1),a.lookAt(0,-1,0),o.up.set(0,1,0),o.lookAt(0,0,1),l.up.set(0,1,0),l.lookAt(0,0,-1);else if(e===Da)n.up.set(0,-1,0),n.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),a.up.set(0,0,-1),a.lookAt(0,-1,0),o.up.set(0,-1,0),o.lookAt(0,0,1),l.up.set(0,-1,0),l.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+e);for(let c of t)this.add(c),c.updateMatrixWorld()}update(e,t){this.parent===null&&this.updateMatrixWorld();let{renderTarget:n,activeMipmapLevel:s}=this;this.coordinateSystem!==e.coordinateSystem&&(this.coordinateSystem=e.coordinateSystem,this.updateCoordinateSystem());let[r,a,o,l,c,u]=this.children,f=e.getRenderTarget(),h=e.getActiveCubeFace(),d=e.getActiveMipmapLevel(),g=e.xr.enabled;e.xr.enabled=!1;let b=n.texture.mipmapsAutoUpdate;n.texture.mipmapsAutoUpdate=!1;let m=!1;e.isWebGLRenderer===!0?m=e.state.buffers.depth.getReversed():m=e.reversedDepthBuffer,e.setRenderTarget(n,0,s),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,r),e.setRenderTarget(n,1,s),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,a),e.setRenderTarget(n,2,s),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,o),e.setRenderTarget(n,3,s),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,l),e.setRenderTarget(n,4,s),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,c),n.texture.mipmapsAutoUpdate=b,e.setRenderTarget(n,5,s),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,u),e.setRenderTarget(f,h,d),e.xr.enabled=g,n.texture.needsPMREMUpdate=!0}},Tl=class extends ei{constructor(e=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=e,this.perCameraFrustumCulled=!1}};var mh="\\[\\]\\.:\\/",g_=new RegExp("["+mh+"]","g"),gh="[^"+mh+"]",__="[^"+mh.replace("\\.","")+"]",x_=/((?:WC+[\/:])*)/.source.replace("WC",gh),v_=/(WCOD+)?/.source.replace("WCOD",__),y_=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",gh),b_=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",gh),S_=new RegExp("^"+x_+v_+y_+b_+"$"),M_=["material","materials","bones","map"],Bu=class{constructor(e,t,n){let s=n||Gt.parseTrackName(t);this._targetGroup=e,this._bindings=e.subscribe_(t,s)}getValue(e,t){this.bind();let n=this._targetGroup.nCachedObjects_,s=this._bindings[n];s!==void 0&&s.getValue(e,t)}setValue(e,t){let n=this._bindings;for(let s=this._targetGroup.nCachedObjects_,r=n.length;s!==r;++s)n[s].setValue(e,t)}bind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,n=e.length;t!==n;++t)e[t].bind()}unbind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,n=e.length;t!==n;++t)e[t].unbind()}},Gt=class i{constructor(e,t,n){this.path=t,this.parsedPath=n||i.parseTrackName(t),this.node=i.findNode(e,this.parsedPath.nodeName),this.rootNode=e,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(e,t,n){return e&&e.isAnimationObjectGroup?new i.Composite(e,t,n):new i(e,t,n)}static sanitizeNodeName(e){return e.replace(/\s/g,"_").replace(g_,"")}static parseTrackName(e){let t=S_.exec(e);if(t===null)throw new Error("THREE.PropertyBinding: Cannot parse trackName: "+e);let n={nodeName:t[2],objectName:t[3],objectIndex:t[4],propertyName:t[5],propertyIndex:t[6]},s=n.nodeName&&n.nodeName.lastIndexOf(".");if(s!==void 0&&s!==-1){let r=n.nodeName.substring(s+1);M_.indexOf(r)!==-1&&(n.nodeName=n.nodeName.substring(0,s),n.objectName=r)}if(n.propertyName===null||n.propertyName.length===0)throw new Error("THREE.PropertyBinding: can not parse propertyName from trackName: "+e);return n}static findNode(e,t){if(t===void 0||t===""||t==="."||t===-1||t===e.name||t===e.uuid)return e;if(e.skeleton){let n=e.skeleton.getBoneByName(t);if(n!==void 0)return n}if(e.children){let n=function(r){for(let a=0;a<r.length;a++){let o=r[a];if(o.name===t||o.uuid===t)return o;let l=n(o.children);if(l)return l}return null},s=n(e.children);if(s)return s}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(e,t){e[t]=this.targetObject[this.propertyName]}_getValue_array(e,t){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)e[t++]=n[s]}_getValue_arrayElement(e,t){e[t]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(e,t){this.resolvedProperty.toArray(e,t)}_setValue_direct(e,t){this.targetObject[this.propertyName]=e[t]}_setValue_direct_setNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(e,t){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=e[t++]}_setValue_array_setNeedsUpdate(e,t){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=e[t++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(e,t){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=e[t++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(e,t){this.resolvedProperty[this.propertyIndex]=e[t]}_setValue_arrayElement_setNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(e,t){this.resolvedProperty.fromArray(e,t)}_setValue_fromArray_setNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(e,t){this.bind(),this.getValue(e,t)}_setValue_unbound(e,t){this.bind(),this.setValue(e,t)}bind(){let e=this.node,t=this.parsedPath,n=t.objectName,s=t.propertyName,r=t.propertyIndex;if(e||(e=i.findNode(this.rootNode,t.nodeName),this.node=e),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!e){$e("PropertyBinding: No target node found for track: "+this.path+".");return}if(n){let c=t.objectIndex;switch(n){case"materials":if(!e.material){Qe("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.materials){Qe("PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}e=e.material.materials;break;case"bones":if(!e.skeleton){Qe("PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}e=e.skeleton.bones;for(let u=0;u<e.length;u++)if(e[u].name===c){c=u;break}break;case"map":if("map"in e){e=e.map;break}if(!e.material){Qe("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.map){Qe("PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}e=e.material.map;break;default:if(e[n]===void 0){Qe("PropertyBinding: Can not bind to objectName of node undefined.",this);return}e=e[n]}if(c!==void 0){if(e[c]===void 0){Qe("PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,e);return}e=e[c]}}let a=e[s];if(a===void 0){let c=t.nodeName;Qe("PropertyBinding: Trying to update property for track: "+c+"."+s+" but it wasn't found.",e);return}let o=this.Versioning.None;this.targetObject=e,e.isMaterial===!0?o=this.Versioning.NeedsUpdate:e.isObject3D===!0&&(o=this.Versioning.MatrixWorldNeedsUpdate);let l=this.BindingType.Direct;if(r!==void 0){if(s==="morphTargetInfluences"){if(!e.geometry){Qe("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!e.geometry.morphAttributes){Qe("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}e.morphTargetDictionary[r]!==void 0&&(r=e.morphTargetDictionary[r])}l=this.BindingType.ArrayElement,this.resolvedProperty=a,this.propertyIndex=r}else a.fromArray!==void 0&&a.toArray!==void 0?(l=this.BindingType.HasFromToArray,this.resolvedProperty=a):Array.isArray(a)?(l=this.BindingType.EntireArray,this.resolvedProperty=a):this.propertyName=s;this.getValue=this.GetterByBindingType[l],this.setValue=this.SetterByBindingTypeAndVersioning[l][o]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};Gt.Composite=Bu;Gt.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};Gt.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};Gt.prototype.GetterByBindingType=[Gt.prototype._getValue_direct,Gt.prototype._getValue_array,Gt.prototype._getValue_arrayElement,Gt.prototype._getValue_toArray];Gt.prototype.SetterByBindingTypeAndVersioning=[[Gt.prototype._setValue_direct,Gt.prototype._setValue_direct_setNeedsUpdate,Gt.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[Gt.prototype._setValue_array,Gt.prototype._setValue_array_setNeedsUpdate,Gt.prototype._setValue_array_setMatrixWorldNeedsUpdate],[Gt.prototype._setValue_arrayElement,Gt.prototype._setValue_arrayElement_setNeedsUpdate,Gt.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[Gt.prototype._setValue_fromArray,Gt.prototype._setValue_fromArray_setNeedsUpdate,Gt.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var Lw=new Float32Array(1);var zu=class{static{this.prototype.isMatrix2=!0}constructor(e,t,n,s){this.elements=[1,0,0,1],e!==void 0&&this.set(e,t,n,s)}identity(){return this.set(1,0,0,1),this}fromArray(e,t=0){for(let n=0;n<4;n++)this.elements[n]=e[n+t];return this}set(e,t,n,s){let r=this.elements;return r[0]=e,r[2]=t,r[1]=n,r[3]=s,this}};function _h(i,e,t,n){let s=w_(n);switch(t){case rh:return i*e;case oh:return i*e/s.components*s.byteLength;case Ll:return i*e/s.components*s.byteLength;case Xi:return i*e*2/s.components*s.byteLength;case Dl:return i*e*2/s.components*s.byteLength;case ah:return i*e*3/s.components*s.byteLength;case cn:return i*e*4/s.components*s.byteLength;case Nl:return i*e*4/s.components*s.byteLength;case qa:case Ya:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*8;case $a:case Za:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*16;case Ul:case Bl:return Math.max(i,16)*Math.max(e,8)/4;case Fl:case Ol:return Math.max(i,8)*Math.max(e,8)/2;case zl:case kl:case Gl:case Hl:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*8;case Vl:case Ja:case Wl:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*16;case Xl:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*16;case ql:return Math.floor((i+4)/5)*Math.floor((e+3)/4)*16;case Yl:return Math.floor((i+4)/5)*Math.floor((e+4)/5)*16;case $l:return Math.floor((i+5)/6)*Math.floor((e+4)/5)*16;case Zl:return Math.floor((i+5)/6)*Math.floor((e+5)/6)*16;case Jl:return Math.floor((i+7)/8)*Math.floor((e+4)/5)*16;case Kl:return Math.floor((i+7)/8)*Math.floor((e+5)/6)*16;case Ql:return Math.floor((i+7)/8)*Math.floor((e+7)/8)*16;case jl:return Math.floor((i+9)/10)*Math.floor((e+4)/5)*16;case ec:return Math.floor((i+9)/10)*Math.floor((e+5)/6)*16;case tc:return Math.floor((i+9)/10)*Math.floor((e+7)/8)*16;case nc:return Math.floor((i+9)/10)*Math.floor((e+9)/10)*16;case ic:return Math.floor((i+11)/12)*Math.floor((e+9)/10)*16;case sc:return Math.floor((i+11)/12)*Math.floor((e+11)/12)*16;case rc:case ac:case oc:return Math.ceil(i/4)*Math.ceil(e/4)*16;case lc:case cc:return Math.ceil(i/4)*Math.ceil(e/4)*8;case Ka:case uc:return Math.ceil(i/4)*Math.ceil(e/4)*16}throw new Error(`Unable to determine texture byte length for ${t} format.`)}function w_(i){switch(i){case ni:case th:return{byteLength:1,components:1};case Jr:case nh:case Ln:return{byteLength:2,components:1};case Pl:case Il:return{byteLength:2,components:4};case Ai:case Cl:case Nt:return{byteLength:4,components:1};case ih:case sh:return{byteLength:4,components:3}}throw new Error(`THREE.TextureUtils: Unknown texture type ${i}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"187"}}));typeof window<"u"&&(window.__THREE__?$e("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="187");function Rp(){let i=null,e=!1,t=null,n=null;function s(r,a){n=i.requestAnimationFrame(s),t(r,a)}return{start:function(){e!==!0&&t!==null&&i!==null&&(n=i.requestAnimationFrame(s),e=!0)},stop:function(){i!==null&&i.cancelAnimationFrame(n),e=!1},setAnimationLoop:function(r){t=r},setContext:function(r){i=r}}}function A_(i){let e=new WeakMap;function t(o,l){let c=o.array,u=o.usage,f=c.byteLength,h=i.createBuffer();i.bindBuffer(l,h),i.bufferData(l,c,u),o.onUploadCallback();let d;if(c instanceof Float32Array)d=i.FLOAT;else if(typeof Float16Array<"u"&&c instanceof Float16Array)d=i.HALF_FLOAT;else if(c instanceof Uint16Array)o.isFloat16BufferAttribute?d=i.HALF_FLOAT:d=i.UNSIGNED_SHORT;else if(c instanceof Int16Array)d=i.SHORT;else if(c instanceof Uint32Array)d=i.UNSIGNED_INT;else if(c instanceof Int32Array)d=i.INT;else if(c instanceof Int8Array)d=i.BYTE;else if(c instanceof Uint8Array)d=i.UNSIGNED_BYTE;else if(c instanceof Uint8ClampedArray)d=i.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+c);return{buffer:h,type:d,bytesPerElement:c.BYTES_PER_ELEMENT,version:o.version,size:f}}function n(o,l,c){let u=l.array,f=l.updateRanges;if(i.bindBuffer(c,o),f.length===0)i.bufferSubData(c,0,u);else{f.sort((d,g)=>d.start-g.start);let h=0;for(let d=1;d<f.length;d++){let g=f[h],b=f[d];b.start<=g.start+g.count+1?g.count=Math.max(g.count,b.start+b.count-g.start):(++h,f[h]=b)}f.length=h+1;for(let d=0,g=f.length;d<g;d++){let b=f[d];i.bufferSubData(c,b.start*u.BYTES_PER_ELEMENT,u,b.start,b.count)}l.clearUpdateRanges()}l.onUploadCallback()}function s(o){return o.isInterleavedBufferAttribute&&(o=o.data),e.get(o)}function r(o){o.isInterleavedBufferAttribute&&(o=o.data);let l=e.get(o);l&&(i.deleteBuffer(l.buffer),e.delete(o))}function a(o,l){if(o.isInterleavedBufferAttribute&&(o=o.data),o.isGLBufferAttribute){let u=e.get(o);(!u||u.version<o.version)&&e.set(o,{buffer:o.buffer,type:o.type,bytesPerElement:o.elementSize,version:o.version});return}let c=e.get(o);if(c===void 0)e.set(o,t(o,l));else if(c.version<o.version){if(c.size!==o.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");n(c.buffer,o,l),c.version=o.version}}return{get:s,remove:r,update:a}}var E_=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,R_=`#ifdef USE_ALPHAHASH
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
#endif`,C_=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,P_=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,I_=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,L_=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,D_=`#ifdef USE_AOMAP
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
#endif`,N_=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,F_=`#ifdef USE_BATCHING
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
#endif`,U_=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,O_=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,B_=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,z_=`float G_BlinnPhong_Implicit( ) {
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
} // validated`,k_=`#ifdef USE_IRIDESCENCE
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
#endif`,V_=`#ifdef USE_BUMPMAP
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
#endif`,G_=`#if NUM_CLIPPING_PLANES > 0
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
#endif`,H_=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,W_=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,X_=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,q_=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#endif`,Y_=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#endif`,$_=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec4 vColor;
#endif`,Z_=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
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
#endif`,J_=`#define PI 3.141592653589793
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
} // validated`,K_=`vec3 transformedNormal = objectNormal;
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
#endif`,Q_=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,j_=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,ex=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,tx=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,nx="gl_FragColor = linearToOutputTexel( gl_FragColor );",ix=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,sx=`#ifdef USE_ENVMAP
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
#endif`,rx=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform mat3 envMapRotation;
	uniform samplerCube envMap;
	#ifdef ENVMAP_TYPE_PMREM
		float roughnessToMip( const in float roughness ) {
			float r = clamp( roughness, 0.0, 1.0 );
			return ENVMAP_MAX_LOD * r * ( 2.0 - r );
		}
	#endif
#endif`,ax=`#ifdef USE_ENVMAP
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
#endif`,ox=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,lx=`#ifdef USE_ENVMAP
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
#endif`,cx=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,ux=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,hx=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,fx=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,dx=`#ifdef USE_GRADIENTMAP
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
}`,px=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,mx=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,gx=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,_x=`uniform bool receiveShadow;
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
#include <lightprobes_pars_fragment>`,xx=`#ifdef USE_ENVMAP
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
#endif`,vx=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,yx=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,bx=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,Sx=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,Mx=`PhysicalMaterial material;
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
#endif`,wx=`uniform sampler2D dfgLUT;
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
}`,Tx=`
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
#endif`,Ax=`#if defined( RE_IndirectDiffuse )
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
#endif`,Ex=`#if defined( RE_IndirectDiffuse )
	#if defined( LAMBERT ) || defined( PHONG )
		irradiance += iblIrradiance;
	#endif
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,Rx=`#if NUM_LIGHT_PROBE_GRIDS > 0
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
#endif`,Cx=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,Px=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,Ix=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,Lx=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,Dx=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,Nx=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,Fx=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
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
#endif`,Ux=`#if defined( USE_POINTS_UV )
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
#endif`,Ox=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,Bx=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,zx=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,kx=`#if defined( USE_MORPHCOLORS )
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
#endif`,Vx=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,Gx=`#ifdef USE_MORPHTARGETS
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
#endif`,Hx=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,Wx=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
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
vec3 nonPerturbedNormal = normal;`,Xx=`#ifdef USE_NORMALMAP_OBJECTSPACE
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
#endif`,qx=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,Yx=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,$x=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
		#ifdef FLIP_SIDED
			vBitangent = - vBitangent;
		#endif
	#endif
#endif`,Zx=`#ifdef USE_NORMALMAP
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
#endif`,Jx=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,Kx=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,Qx=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,jx=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,ev=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,tv=`vec3 packNormalToRGB( const in vec3 normal ) {
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
}`,nv=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,iv=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,sv=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,rv=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,av=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,ov=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,lv=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,cv=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,uv=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_SUN_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
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
#endif`,hv=`float getShadowMask() {
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
}`,fv=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,dv=`#ifdef USE_SKINNING
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
#endif`,pv=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,mv=`#ifdef USE_SKINNING
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
#endif`,gv=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,_v=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,xv=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,vv=`#ifndef saturate
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
vec3 CustomToneMapping( vec3 color ) { return color; }`,yv=`#ifdef USE_TRANSMISSION
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
#endif`,bv=`#ifdef USE_TRANSMISSION
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
#endif`,Sv=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,Mv=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,wv=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,Tv=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,Av=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,Ev=`uniform sampler2D t2D;
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
}`,Rv=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,Cv=`uniform float backgroundBlurriness;
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
}`,Pv=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,Iv=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,Lv=`#include <common>
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
}`,Dv=`#if DEPTH_PACKING == 3200
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
}`,Nv=`#define DISTANCE
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
}`,Fv=`#define DISTANCE
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
}`,Uv=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,Ov=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,Bv=`uniform float scale;
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
}`,zv=`uniform vec3 diffuse;
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
}`,kv=`#include <common>
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
}`,Vv=`uniform vec3 diffuse;
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
}`,Gv=`#define LAMBERT
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
}`,Hv=`#define LAMBERT
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
}`,Wv=`#define MATCAP
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
}`,Xv=`#define MATCAP
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
}`,qv=`#define NORMAL
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
}`,Yv=`#define NORMAL
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
}`,$v=`#define PHONG
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
}`,Zv=`#define PHONG
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
}`,Jv=`#define STANDARD
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
}`,Kv=`#define STANDARD
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
}`,Qv=`#define TOON
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
}`,jv=`#define TOON
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
}`,e1=`uniform float size;
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
}`,t1=`uniform vec3 diffuse;
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
}`,n1=`#include <common>
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
}`,i1=`uniform vec3 color;
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
}`,s1=`uniform float rotation;
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
}`,r1=`uniform vec3 diffuse;
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
}`,ot={alphahash_fragment:E_,alphahash_pars_fragment:R_,alphamap_fragment:C_,alphamap_pars_fragment:P_,alphatest_fragment:I_,alphatest_pars_fragment:L_,aomap_fragment:D_,aomap_pars_fragment:N_,batching_pars_vertex:F_,batching_vertex:U_,begin_vertex:O_,beginnormal_vertex:B_,bsdfs:z_,iridescence_fragment:k_,bumpmap_pars_fragment:V_,clipping_planes_fragment:G_,clipping_planes_pars_fragment:H_,clipping_planes_pars_vertex:W_,clipping_planes_vertex:X_,color_fragment:q_,color_pars_fragment:Y_,color_pars_vertex:$_,color_vertex:Z_,common:J_,defaultnormal_vertex:K_,displacementmap_pars_vertex:Q_,displacementmap_vertex:j_,emissivemap_fragment:ex,emissivemap_pars_fragment:tx,colorspace_fragment:nx,colorspace_pars_fragment:ix,envmap_fragment:sx,envmap_common_pars_fragment:rx,envmap_pars_fragment:ax,envmap_pars_vertex:ox,envmap_physical_pars_fragment:xx,envmap_vertex:lx,fog_vertex:cx,fog_pars_vertex:ux,fog_fragment:hx,fog_pars_fragment:fx,gradientmap_pars_fragment:dx,lightmap_pars_fragment:px,lights_lambert_fragment:mx,lights_lambert_pars_fragment:gx,lights_pars_begin:_x,lights_toon_fragment:vx,lights_toon_pars_fragment:yx,lights_phong_fragment:bx,lights_phong_pars_fragment:Sx,lights_physical_fragment:Mx,lights_physical_pars_fragment:wx,lights_fragment_begin:Tx,lights_fragment_maps:Ax,lights_fragment_end:Ex,lightprobes_pars_fragment:Rx,logdepthbuf_fragment:Cx,logdepthbuf_pars_fragment:Px,logdepthbuf_pars_vertex:Ix,logdepthbuf_vertex:Lx,map_fragment:Dx,map_pars_fragment:Nx,map_particle_fragment:Fx,map_particle_pars_fragment:Ux,metalnessmap_fragment:Ox,metalnessmap_pars_fragment:Bx,morphinstance_vertex:zx,morphcolor_vertex:kx,morphnormal_vertex:Vx,morphtarget_pars_vertex:Gx,morphtarget_vertex:Hx,normal_fragment_begin:Wx,normal_fragment_maps:Xx,normal_pars_fragment:qx,normal_pars_vertex:Yx,normal_vertex:$x,normalmap_pars_fragment:Zx,clearcoat_normal_fragment_begin:Jx,clearcoat_normal_fragment_maps:Kx,clearcoat_pars_fragment:Qx,iridescence_pars_fragment:jx,opaque_fragment:ev,packing:tv,premultiplied_alpha_fragment:nv,project_vertex:iv,dithering_fragment:sv,dithering_pars_fragment:rv,roughnessmap_fragment:av,roughnessmap_pars_fragment:ov,shadowmap_pars_fragment:lv,shadowmap_pars_vertex:cv,shadowmap_vertex:uv,shadowmask_pars_fragment:hv,skinbase_vertex:fv,skinning_pars_vertex:dv,skinning_vertex:pv,skinnormal_vertex:mv,specularmap_fragment:gv,specularmap_pars_fragment:_v,tonemapping_fragment:xv,tonemapping_pars_fragment:vv,transmission_fragment:yv,transmission_pars_fragment:bv,uv_pars_fragment:Sv,uv_pars_vertex:Mv,uv_vertex:wv,worldpos_vertex:Tv,background_vert:Av,background_frag:Ev,backgroundCube_vert:Rv,backgroundCube_frag:Cv,cube_vert:Pv,cube_frag:Iv,depth_vert:Lv,depth_frag:Dv,distance_vert:Nv,distance_frag:Fv,equirect_vert:Uv,equirect_frag:Ov,linedashed_vert:Bv,linedashed_frag:zv,meshbasic_vert:kv,meshbasic_frag:Vv,meshlambert_vert:Gv,meshlambert_frag:Hv,meshmatcap_vert:Wv,meshmatcap_frag:Xv,meshnormal_vert:qv,meshnormal_frag:Yv,meshphong_vert:$v,meshphong_frag:Zv,meshphysical_vert:Jv,meshphysical_frag:Kv,meshtoon_vert:Qv,meshtoon_frag:jv,points_vert:e1,points_frag:t1,shadow_vert:n1,shadow_frag:i1,sprite_vert:s1,sprite_frag:r1},Le={common:{diffuse:{value:new vt(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new je},alphaMap:{value:null},alphaMapTransform:{value:new je},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new je}},envmap:{envMap:{value:null},envMapRotation:{value:new je},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new je}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new je}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new je},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new je},normalScale:{value:new ct(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new je},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new je}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new je}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new je}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new vt(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},sunLights:{value:[],properties:{direction:{},color:{}}},sunLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},sunShadowMatrix:{value:[]},sunShadowCascade:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:[]},probesMin:{value:[]},probesMax:{value:[]},probesResolution:{value:[]}},points:{diffuse:{value:new vt(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new je},alphaTest:{value:0},uvTransform:{value:new je}},sprite:{diffuse:{value:new vt(16777215)},opacity:{value:1},center:{value:new ct(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new je},alphaMap:{value:null},alphaMapTransform:{value:new je},alphaTest:{value:0}}},Yi={basic:{uniforms:Dn([Le.common,Le.specularmap,Le.envmap,Le.aomap,Le.lightmap,Le.fog]),vertexShader:ot.meshbasic_vert,fragmentShader:ot.meshbasic_frag},lambert:{uniforms:Dn([Le.common,Le.specularmap,Le.envmap,Le.aomap,Le.lightmap,Le.emissivemap,Le.bumpmap,Le.normalmap,Le.displacementmap,Le.fog,Le.lights,{emissive:{value:new vt(0)},envMapIntensity:{value:1}}]),vertexShader:ot.meshlambert_vert,fragmentShader:ot.meshlambert_frag},phong:{uniforms:Dn([Le.common,Le.specularmap,Le.envmap,Le.aomap,Le.lightmap,Le.emissivemap,Le.bumpmap,Le.normalmap,Le.displacementmap,Le.fog,Le.lights,{emissive:{value:new vt(0)},specular:{value:new vt(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:ot.meshphong_vert,fragmentShader:ot.meshphong_frag},standard:{uniforms:Dn([Le.common,Le.envmap,Le.aomap,Le.lightmap,Le.emissivemap,Le.bumpmap,Le.normalmap,Le.displacementmap,Le.roughnessmap,Le.metalnessmap,Le.fog,Le.lights,{emissive:{value:new vt(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:ot.meshphysical_vert,fragmentShader:ot.meshphysical_frag},toon:{uniforms:Dn([Le.common,Le.aomap,Le.lightmap,Le.emissivemap,Le.bumpmap,Le.normalmap,Le.displacementmap,Le.gradientmap,Le.fog,Le.lights,{emissive:{value:new vt(0)}}]),vertexShader:ot.meshtoon_vert,fragmentShader:ot.meshtoon_frag},matcap:{uniforms:Dn([Le.common,Le.bumpmap,Le.normalmap,Le.displacementmap,Le.fog,{matcap:{value:null}}]),vertexShader:ot.meshmatcap_vert,fragmentShader:ot.meshmatcap_frag},points:{uniforms:Dn([Le.points,Le.fog]),vertexShader:ot.points_vert,fragmentShader:ot.points_frag},dashed:{uniforms:Dn([Le.common,Le.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:ot.linedashed_vert,fragmentShader:ot.linedashed_frag},depth:{uniforms:Dn([Le.common,Le.displacementmap]),vertexShader:ot.depth_vert,fragmentShader:ot.depth_frag},normal:{uniforms:Dn([Le.common,Le.bumpmap,Le.normalmap,Le.displacementmap,{opacity:{value:1}}]),vertexShader:ot.meshnormal_vert,fragmentShader:ot.meshnormal_frag},sprite:{uniforms:Dn([Le.sprite,Le.fog]),vertexShader:ot.sprite_vert,fragmentShader:ot.sprite_frag},background:{uniforms:{uvTransform:{value:new je},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:ot.background_vert,fragmentShader:ot.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new je}},vertexShader:ot.backgroundCube_vert,fragmentShader:ot.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:ot.cube_vert,fragmentShader:ot.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:ot.equirect_vert,fragmentShader:ot.equirect_frag},distance:{uniforms:Dn([Le.common,Le.displacementmap,{referencePosition:{value:new Y},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:ot.distance_vert,fragmentShader:ot.distance_frag},shadow:{uniforms:Dn([Le.lights,Le.fog,{color:{value:new vt(0)},opacity:{value:1}}]),vertexShader:ot.shadow_vert,fragmentShader:ot.shadow_frag}};Yi.physical={uniforms:Dn([Yi.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new je},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new je},clearcoatNormalScale:{value:new ct(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new je},diffuseRoughness:{value:0},diffuseRoughnessMap:{value:null},diffuseRoughnessMapTransform:{value:new je},dispersion:{value:0},retroreflectivity:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new je},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new je},sheen:{value:0},sheenColor:{value:new vt(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new je},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new je},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new je},transmissionSamplerSize:{value:new ct},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new je},attenuationDistance:{value:0},attenuationColor:{value:new vt(0)},specularColor:{value:new vt(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new je},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new je},anisotropyVector:{value:new ct},anisotropyMap:{value:null},anisotropyMapTransform:{value:new je}}]),vertexShader:ot.meshphysical_vert,fragmentShader:ot.meshphysical_frag};var hc={r:0,b:0,g:0},a1=new dt,Cp=new je;Cp.set(-1,0,0,0,1,0,0,0,1);function o1(i,e,t,n,s,r){let a=new vt(0),o=s===!0?0:1,l,c,u=null,f=0,h=null;function d(v){let E=v.isScene===!0?v.background:null;if(E&&E.isTexture){let S=v.backgroundBlurriness>0;E=e.get(E,S)}return E}function g(v){let E=!1,S=d(v);S===null?m(a,o):S&&S.isColor&&(m(S,1),E=!0);let R=i.xr.getEnvironmentBlendMode();R==="additive"?t.buffers.color.setClear(0,0,0,1,r):R==="alpha-blend"&&t.buffers.color.setClear(0,0,0,0,r),(i.autoClear||E)&&(t.buffers.depth.setTest(!0),t.buffers.depth.setMask(!0),t.buffers.color.setMask(!0),i.clear(i.autoClearColor,i.autoClearDepth,i.autoClearStencil))}function b(v,E){let S=d(E);S&&S.isCubeTexture?(c===void 0&&(c=new pi(new Wr(1,1,1),new Gi({name:"BackgroundCubeMaterial",uniforms:sr(Yi.backgroundCube.uniforms),vertexShader:Yi.backgroundCube.vertexShader,fragmentShader:Yi.backgroundCube.fragmentShader,side:Vn,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),c.geometry.deleteAttribute("uv"),c.onBeforeRender=function(R,A,x){this.matrixWorld.copyPosition(x.matrixWorld)},Object.defineProperty(c.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),n.update(c)),c.material.uniforms.envMap.value=S,c.material.uniforms.backgroundBlurriness.value=E.backgroundBlurriness,c.material.uniforms.backgroundIntensity.value=E.backgroundIntensity,c.material.uniforms.backgroundRotation.value.setFromMatrix4(a1.makeRotationFromEuler(E.backgroundRotation)).transpose(),S.isRenderTargetTexture===!1&&c.material.uniforms.backgroundRotation.value.premultiply(Cp),c.material.toneMapped=mt.getTransfer(S.colorSpace)!==Tt,(u!==S||f!==S.version||h!==i.toneMapping)&&(c.material.needsUpdate=!0,u=S,f=S.version,h=i.toneMapping),c.layers.enableAll(),v.unshift(c,c.geometry,c.material,0,0,null)):S&&S.isTexture&&(l===void 0&&(l=new pi(new Ga(2,2),new Gi({name:"BackgroundMaterial",uniforms:sr(Yi.background.uniforms),vertexShader:Yi.background.vertexShader,fragmentShader:Yi.background.fragmentShader,side:Fs,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),l.geometry.deleteAttribute("normal"),Object.defineProperty(l.material,"map",{get:function(){return this.uniforms.t2D.value}}),n.update(l)),l.material.uniforms.t2D.value=S,l.material.uniforms.backgroundIntensity.value=E.backgroundIntensity,l.material.toneMapped=mt.getTransfer(S.colorSpace)!==Tt,S.matrixAutoUpdate===!0&&S.updateMatrix(),l.material.uniforms.uvTransform.value.copy(S.matrix),(u!==S||f!==S.version||h!==i.toneMapping)&&(l.material.needsUpdate=!0,u=S,f=S.version,h=i.toneMapping),l.layers.enableAll(),v.unshift(l,l.geometry,l.material,0,0,null))}function m(v,E){v.getRGB(hc,ph(i)),t.buffers.color.setClear(hc.r,hc.g,hc.b,E,r)}function p(){c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0),l!==void 0&&(l.geometry.dispose(),l.material.dispose(),l=void 0)}return{getClearColor:function(){return a},setClearColor:function(v,E=1){a.set(v),o=E,m(a,o)},getClearAlpha:function(){return o},setClearAlpha:function(v){o=v,m(a,o)},render:g,addToRenderList:b,dispose:p}}function l1(i,e){let t=i.getParameter(i.MAX_VERTEX_ATTRIBS),n={},s=h(null),r=s,a=!1;function o(L,G,H,D,V){let Z=!1,z=f(L,D,H,G);r!==z&&(r=z,c(r.object)),Z=d(L,D,H,V),Z&&g(L,D,H,V),V!==null&&e.update(V,i.ELEMENT_ARRAY_BUFFER),(Z||a)&&(a=!1,S(L,G,H,D),V!==null&&i.bindBuffer(i.ELEMENT_ARRAY_BUFFER,e.get(V).buffer))}function l(){return i.createVertexArray()}function c(L){return i.bindVertexArray(L)}function u(L){return i.deleteVertexArray(L)}function f(L,G,H,D){let V=D.wireframe===!0,Z=n[G.id];Z===void 0&&(Z={},n[G.id]=Z);let z=L.isInstancedMesh===!0?L.id:0,le=Z[z];le===void 0&&(le={},Z[z]=le);let J=le[H.id];J===void 0&&(J={},le[H.id]=J);let Q=J[V];return Q===void 0&&(Q=h(l()),J[V]=Q),Q}function h(L){let G=[],H=[],D=[];for(let V=0;V<t;V++)G[V]=0,H[V]=0,D[V]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:G,enabledAttributes:H,attributeDivisors:D,object:L,attributes:{},index:null}}function d(L,G,H,D){let V=r.attributes,Z=G.attributes,z=0,le=H.getAttributes();for(let J in le)if(le[J].location>=0){let ie=V[J],he=Z[J];if(he===void 0&&(J==="instanceMatrix"&&L.instanceMatrix&&(he=L.instanceMatrix),J==="instanceColor"&&L.instanceColor&&(he=L.instanceColor)),ie===void 0||ie.attribute!==he||he&&ie.data!==he.data)return!0;z++}return r.attributesNum!==z||r.index!==D}function g(L,G,H,D){let V={},Z=G.attributes,z=0,le=H.getAttributes();for(let J in le)if(le[J].location>=0){let ie=Z[J];ie===void 0&&(J==="instanceMatrix"&&L.instanceMatrix&&(ie=L.instanceMatrix),J==="instanceColor"&&L.instanceColor&&(ie=L.instanceColor));let he={};he.attribute=ie,ie&&ie.data&&(he.data=ie.data),V[J]=he,z++}r.attributes=V,r.attributesNum=z,r.index=D}function b(){let L=r.newAttributes;for(let G=0,H=L.length;G<H;G++)L[G]=0}function m(L){p(L,0)}function p(L,G){let H=r.newAttributes,D=r.enabledAttributes,V=r.attributeDivisors;H[L]=1,D[L]===0&&(i.enableVertexAttribArray(L),D[L]=1),V[L]!==G&&(i.vertexAttribDivisor(L,G),V[L]=G)}function v(){let L=r.newAttributes,G=r.enabledAttributes;for(let H=0,D=G.length;H<D;H++)G[H]!==L[H]&&(i.disableVertexAttribArray(H),G[H]=0)}function E(L,G,H,D,V,Z,z){z===!0?i.vertexAttribIPointer(L,G,H,V,Z):i.vertexAttribPointer(L,G,H,D,V,Z)}function S(L,G,H,D){b();let V=D.attributes,Z=H.getAttributes(),z=G.defaultAttributeValues;for(let le in Z){let J=Z[le];if(J.location>=0){let Q=V[le];if(Q===void 0&&(le==="instanceMatrix"&&L.instanceMatrix&&(Q=L.instanceMatrix),le==="instanceColor"&&L.instanceColor&&(Q=L.instanceColor)),Q!==void 0){let ie=Q.normalized,he=Q.itemSize,ue=e.get(Q);if(ue===void 0)continue;let j=ue.buffer,me=ue.type,xe=ue.bytesPerElement,Ee=me===i.INT||me===i.UNSIGNED_INT||Q.gpuType===Cl;if(Q.isInterleavedBufferAttribute){let Se=Q.data,He=Se.isInterleavedBuffer===!0?Se.stride:Se.itemSize,nt=Q.offset;if(Se.isInstancedInterleavedBuffer||Se.isInstancedBufferAttribute){for(let Ve=0;Ve<J.locationSize;Ve++)p(J.location+Ve,Se.meshPerAttribute);L.isInstancedMesh!==!0&&D._maxInstanceCount===void 0&&(D._maxInstanceCount=Se.meshPerAttribute*Se.count)}else for(let Ve=0;Ve<J.locationSize;Ve++)m(J.location+Ve);i.bindBuffer(i.ARRAY_BUFFER,j);for(let Ve=0;Ve<J.locationSize;Ve++)E(J.location+Ve,he/J.locationSize,me,ie,He*xe,(nt+he/J.locationSize*Ve)*xe,Ee)}else{if(Q.isInstancedBufferAttribute){for(let Se=0;Se<J.locationSize;Se++)p(J.location+Se,Q.meshPerAttribute);L.isInstancedMesh!==!0&&D._maxInstanceCount===void 0&&(D._maxInstanceCount=Q.meshPerAttribute*Q.count)}else for(let Se=0;Se<J.locationSize;Se++)m(J.location+Se);i.bindBuffer(i.ARRAY_BUFFER,j);for(let Se=0;Se<J.locationSize;Se++)E(J.location+Se,he/J.locationSize,me,ie,he*xe,he/J.locationSize*Se*xe,Ee)}}else if(z!==void 0){let ie=z[le];if(ie!==void 0)switch(ie.length){case 2:i.vertexAttrib2fv(J.location,ie);break;case 3:i.vertexAttrib3fv(J.location,ie);break;case 4:i.vertexAttrib4fv(J.location,ie);break;default:i.vertexAttrib1fv(J.location,ie)}}}}v()}function R(){k();for(let L in n){let G=n[L];for(let H in G){let D=G[H];for(let V in D){let Z=D[V];for(let z in Z)u(Z[z].object),delete Z[z];delete D[V]}}delete n[L]}}function A(L){if(n[L.id]===void 0)return;let G=n[L.id];for(let H in G){let D=G[H];for(let V in D){let Z=D[V];for(let z in Z)u(Z[z].object),delete Z[z];delete D[V]}}delete n[L.id]}function x(L){for(let G in n){let H=n[G];for(let D in H){let V=H[D];if(V[L.id]===void 0)continue;let Z=V[L.id];for(let z in Z)u(Z[z].object),delete Z[z];delete V[L.id]}}}function T(L){for(let G in n){let H=n[G],D=L.isInstancedMesh===!0?L.id:0,V=H[D];if(V!==void 0){for(let Z in V){let z=V[Z];for(let le in z)u(z[le].object),delete z[le];delete V[Z]}delete H[D],Object.keys(H).length===0&&delete n[G]}}}function k(){N(),a=!0,r!==s&&(r=s,c(r.object))}function N(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:o,reset:k,resetDefaultState:N,dispose:R,releaseStatesOfGeometry:A,releaseStatesOfObject:T,releaseStatesOfProgram:x,initAttributes:b,enableAttribute:m,disableUnusedAttributes:v}}function c1(i,e,t){let n;function s(l){n=l}function r(l,c){i.drawArrays(n,l,c),t.update(c,n,1)}function a(l,c,u){u!==0&&(i.drawArraysInstanced(n,l,c,u),t.update(c,n,u))}function o(l,c,u){if(u===0)return;e.get("WEBGL_multi_draw").multiDrawArraysWEBGL(n,l,0,c,0,u);let h=0;for(let d=0;d<u;d++)h+=c[d];t.update(h,n,1)}this.setMode=s,this.render=r,this.renderInstances=a,this.renderMultiDraw=o}function u1(i,e,t,n){let s;function r(){if(s!==void 0)return s;if(e.has("EXT_texture_filter_anisotropic")===!0){let x=e.get("EXT_texture_filter_anisotropic");s=i.getParameter(x.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function a(x){return!(x!==cn&&n.convert(x)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_FORMAT))}function o(x){let T=x===Ln&&(e.has("EXT_color_buffer_half_float")||e.has("EXT_color_buffer_float"));return!(x!==ni&&x!==Nt&&!T&&n.convert(x)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_TYPE))}function l(x){if(x==="highp"){if(i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.HIGH_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.HIGH_FLOAT).precision>0)return"highp";x="mediump"}return x==="mediump"&&i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.MEDIUM_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let c=t.precision!==void 0?t.precision:"highp",u=l(c);u!==c&&($e("WebGLRenderer:",c,"not supported, using",u,"instead."),c=u);let f=t.reversedDepthBuffer===!0&&e.has("EXT_clip_control"),h=t.logarithmicDepthBuffer===!0&&f===!1;t.reversedDepthBuffer===!0&&f===!1&&$e("WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer."),t.logarithmicDepthBuffer===!0&&f===!0&&$e("WebGLRenderer: Logarithmic depth buffer is ignored when reversed depth buffer is enabled.");let d=i.getParameter(i.MAX_TEXTURE_IMAGE_UNITS),g=i.getParameter(i.MAX_VERTEX_TEXTURE_IMAGE_UNITS),b=i.getParameter(i.MAX_TEXTURE_SIZE),m=i.getParameter(i.MAX_CUBE_MAP_TEXTURE_SIZE),p=i.getParameter(i.MAX_VERTEX_ATTRIBS),v=i.getParameter(i.MAX_VERTEX_UNIFORM_VECTORS),E=i.getParameter(i.MAX_VARYING_VECTORS),S=i.getParameter(i.MAX_FRAGMENT_UNIFORM_VECTORS),R=i.getParameter(i.MAX_SAMPLES),A=i.getParameter(i.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:l,textureFormatReadable:a,textureTypeReadable:o,precision:c,logarithmicDepthBuffer:h,reversedDepthBuffer:f,maxTextures:d,maxVertexTextures:g,maxTextureSize:b,maxCubemapSize:m,maxAttributes:p,maxVertexUniforms:v,maxVaryings:E,maxFragmentUniforms:S,maxSamples:R,samples:A}}function h1(i){let e=this,t=null,n=0,s=!1,r=!1,a=new wi,o=new je,l={value:null,needsUpdate:!1};this.uniform=l,this.numPlanes=0,this.numIntersection=0,this.init=function(f,h){let d=f.length!==0||h||n!==0||s;return s=h,n=f.length,d},this.beginShadows=function(){r=!0,u(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(f,h){t=u(f,h,0)},this.setState=function(f,h,d){let g=f.clippingPlanes,b=f.clipIntersection,m=f.clipShadows,p=i.get(f);if(!s||g===null||g.length===0||r&&!m)r?u(null):c();else{let v=r?0:n,E=v*4,S=p.clippingState||null;l.value=S,S=u(g,h,E,d);for(let R=0;R!==E;++R)S[R]=t[R];p.clippingState=S,this.numIntersection=b?this.numPlanes:0,this.numPlanes+=v}};function c(){l.value!==t&&(l.value=t,l.needsUpdate=n>0),e.numPlanes=n,e.numIntersection=0}function u(f,h,d,g){let b=f!==null?f.length:0,m=null;if(b!==0){if(m=l.value,g!==!0||m===null){let p=d+b*4,v=h.matrixWorldInverse;o.getNormalMatrix(v),(m===null||m.length<p)&&(m=new Float32Array(p));for(let E=0,S=d;E!==b;++E,S+=4)a.copy(f[E]).applyMatrix4(v,o),a.normal.toArray(m,S),m[S+3]=a.constant}l.value=m,l.needsUpdate=!0}return e.numPlanes=b,e.numIntersection=0,m}}var no=class extends wn{constructor(e=1,t={}){super(e,e,t),this.isWebGLCubeRenderTarget=!0;let n={width:e,height:e,depth:1},s=[n,n,n,n,n,n];this.texture=new za(s),this._setTextureOptions(t),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(e,t){this.texture.type=t.type,this.texture.colorSpace=t.colorSpace,this.texture.generateMipmaps=t.generateMipmaps,this.texture.minFilter=t.minFilter,this.texture.magFilter=t.magFilter;let n={uniforms:{tEquirect:{value:null}},vertexShader:`

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
			`},s=new Wr(5,5,5),r=new Gi({name:"CubemapFromEquirect",uniforms:sr(n.uniforms),vertexShader:n.vertexShader,fragmentShader:n.fragmentShader,side:Vn,blending:er});r.uniforms.tEquirect.value=t;let a=new pi(s,r),o=t.minFilter;return t.minFilter===hs&&(t.minFilter=An),new qr(1,10,this).update(e,a),t.minFilter=o,a.geometry.dispose(),a.material.dispose(),this}clear(e,t=!0,n=!0,s=!0){let r=e.getRenderTarget();for(let a=0;a<6;a++)e.setRenderTarget(this,a),e.clear(t,n,s);e.setRenderTarget(r)}},op=256,f1=3,d1=20,Pp=256,Ip=16,p1=3,m1=new Y,g1=new vt,dc=class i{constructor(e){this._renderer=e,this._cubeSize=0,this._sourceTarget=null,this._cubeCamera=new qr(1,10,null),this._boxMesh=new pi(new Wr(5,5,5),null),this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null,this._integrationMaterial=null}fromScene(e,t=0,n=.1,s=100,r={}){let{size:a=256,position:o=m1}=r,l=this._renderer;this._setSize(a);let c=this._allocateTarget(),u=this._getSourceTarget(!0);t>0&&(u.texture.mipmapsAutoUpdate=!1);let f=l.autoClear,h=l.autoClearColor,d=l.autoClearDepth,g=l.autoClearStencil,b=e.background;l.autoClear=!0,l.autoClearColor=!0,l.autoClearDepth=!0,l.autoClearStencil=!0,b===null&&(e.background=l.getClearColor(g1));let m=new qr(n,s,u);return m.position.copy(o),m.update(l,e),l.autoClear=f,l.autoClearColor=h,l.autoClearDepth=d,l.autoClearStencil=g,e.background=b,t>0&&(u.texture.mipmapsAutoUpdate=!0,this._blur(c,t)),this._applyPMREM(c),c}fromEquirectangular(e,t=null){return this._fromTexture(e,t)}fromCubemap(e,t=null){return this._fromTexture(e,t)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=up(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=cp(),this._compileMaterial(this._equirectMaterial))}dispose(){this._sourceTarget!==null&&this._sourceTarget.dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._integrationMaterial!==null&&this._integrationMaterial.dispose(),this._boxMesh.geometry.dispose()}static lodToRoughness(e,t){return t>0?1-Math.sqrt(1-e/t):0}_setSize(e){this._cubeSize=Math.max(op,np(e))}_fromTexture(e,t){e.mapping===nr||e.mapping===Zr?this._setSize(e.image.length===0?op:e.image[0].width||e.image[0].image.width):this._setSize(e.image.width/4);let n=t||this._allocateTarget();return this._textureToCubemap(e),this._applyPMREM(n),n}_allocateTarget(){let e=this._cubeSize,t=lp(e,!1,!1),n=Math.log2(e)-f1;for(let s=0;s<=n;s++)t.texture.mipmaps.push({width:e>>s,height:e>>s});return t.texture.name="PMREM",t.texture.isPMREMTexture=!0,t}_getSourceTarget(e=!1){let t=this._cubeSize,n=this._sourceTarget;return(n===null||n.width!==t||e&&n.depthBuffer===!1)&&(n!==null&&n.dispose(),this._sourceTarget=lp(t,!0,e)),this._sourceTarget}_compileMaterial(e){this._boxMesh.material=e,this._renderer.compile(this._boxMesh,this._cubeCamera.children[0])}_renderCube(e,t,n){let s=this._boxMesh,r=this._cubeCamera;s.material=n,r.renderTarget=e,r.activeMipmapLevel=t;let a=e.width>>t;e.viewport.set(0,0,a,a),r.update(this._renderer,s),e.viewport.set(0,0,e.width,e.height)}_textureToCubemap(e){let t;e.mapping===nr||e.mapping===Zr?(this._cubemapMaterial===null&&(this._cubemapMaterial=up()),t=this._cubemapMaterial,t.uniforms.flipEnvMap.value=e.isRenderTargetTexture===!1?-1:1):(this._equirectMaterial===null&&(this._equirectMaterial=cp()),t=this._equirectMaterial),t.uniforms.envMap.value=e,this._renderCube(this._getSourceTarget(),0,t)}_applyPMREM(e){this._ggxMaterial===null&&(this._ggxMaterial=_1(),this._integrationMaterial=x1());let t=this._cubeSize,n=e.texture.mipmaps.length-1,s=this._ggxMaterial.uniforms;s.envMap.value=this._sourceTarget.texture;let r=this._integrationMaterial.uniforms;r.envMap.value=this._sourceTarget.texture,r.sourceLod.value=Math.log2(t/Ip);for(let a=0;a<=n;a++){let o=i.lodToRoughness(a,n);if(a>n-p1)r.roughness.value=o,this._renderCube(e,a,this._integrationMaterial);else{let l=o>0?Math.log2(t)+.5*Math.log2(6/(Pp*Math.pow(o,4)))+.5:0;s.roughness.value=o,s.lodBias.value=l,this._renderCube(e,a,this._ggxMaterial)}}}_blur(e,t){this._blurMaterial===null&&(this._blurMaterial=v1());let n=this._blurMaterial,s=n.uniforms,r=this._sourceTarget;s.sigma.value=Math.min(t,Math.PI)/Math.SQRT2,s.envMap.value=r.texture,this._renderCube(e,0,n),s.envMap.value=e.texture,this._renderCube(r,0,n)}};function lp(i,e,t){return new no(i,{minFilter:hs,generateMipmaps:e,type:Ln,colorSpace:Ia,depthBuffer:t})}function io(i,e,t){return new Gi({name:i,uniforms:e,vertexShader:ot.cube_vert,fragmentShader:t,side:Vn,blending:er,depthTest:!1,depthWrite:!1})}function _1(){return io("PMREMGGXConvolution",{envMap:{value:null},roughness:{value:0},lodBias:{value:0}},`

		#define GGX_SAMPLES ${Pp}u

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
	`)}function x1(){return io("PMREMGGXIntegration",{envMap:{value:null},roughness:{value:0},sourceLod:{value:0},sourceSize:{value:Ip}},`

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
	`)}function v1(){return io("PMREMSphericalGaussianBlur",{envMap:{value:null},sigma:{value:0}},`

		#define SAMPLES ${d1}
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
	`)}function cp(){return io("PMREMEquirectangularToCubemap",{envMap:{value:null}},`

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
	`)}function up(){return io("PMREMCubemapToCubemap",{envMap:{value:null},flipEnvMap:{value:-1}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float flipEnvMap;

		void main() {

			gl_FragColor = vec4( textureCube( envMap, vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) ).rgb, 1.0 );

		}
	`)}function y1(i){let e=new WeakMap,t=new WeakMap,n=null;function s(h,d=!1){return h==null?null:d?a(h):r(h)}function r(h){if(h&&h.isTexture){let d=h.mapping;if(d===Al||d===El)if(e.has(h)){let g=e.get(h).texture;return o(g,h.mapping)}else{let g=h.image;if(g&&g.height>0){let b=new no(g.height);return b.fromEquirectangularTexture(i,h),e.set(h,b),h.addEventListener("dispose",c),o(b.texture,h.mapping)}else return null}}return h}function a(h){if(h&&h.isTexture&&h.isPMREMTexture!==!0){let d=h.mapping,g=d===Al||d===El,b=d===nr||d===Zr;if(g||b){let m=t.get(h),p=m!==void 0?m.texture.pmremVersion:0;if(h.isRenderTargetTexture&&h.pmremVersion!==p)return n===null&&(n=new dc(i)),m=g?n.fromEquirectangular(h,m):n.fromCubemap(h,m),m.texture.pmremVersion=h.pmremVersion,t.set(h,m),m.texture;if(m!==void 0)return m.texture;{let v=h.image;return g&&v&&v.height>0||b&&v&&l(v)?(n===null&&(n=new dc(i)),m=g?n.fromEquirectangular(h):n.fromCubemap(h),m.texture.pmremVersion=h.pmremVersion,t.set(h,m),h.addEventListener("dispose",u),m.texture):null}}}return h}function o(h,d){return d===Al?h.mapping=nr:d===El&&(h.mapping=Zr),h}function l(h){let d=0,g=6;for(let b=0;b<g;b++)h[b]!==void 0&&d++;return d===g}function c(h){let d=h.target;d.removeEventListener("dispose",c);let g=e.get(d);g!==void 0&&(e.delete(d),g.dispose())}function u(h){let d=h.target;d.removeEventListener("dispose",u);let g=t.get(d);g!==void 0&&(t.delete(d),g.dispose())}function f(){e=new WeakMap,t=new WeakMap,n!==null&&(n.dispose(),n=null)}return{get:s,dispose:f}}function b1(i){let e={};function t(n){if(e[n]!==void 0)return e[n];let s=i.getExtension(n);return e[n]=s,s}return{has:function(n){return t(n)!==null},init:function(){t("EXT_color_buffer_float"),t("WEBGL_clip_cull_distance"),t("OES_texture_float_linear"),t("EXT_color_buffer_half_float"),t("WEBGL_multisampled_render_to_texture"),t("WEBGL_render_shared_exponent")},get:function(n){let s=t(n);return s===null&&Ca("WebGLRenderer: "+n+" extension not supported."),s}}}function S1(i,e,t,n){let s={},r=new WeakMap,a=new FinalizationRegistry(g=>delete s[g]);function o(g){l(g.target)}function l(g){g.index!==null&&e.remove(g.index);for(let m in g.attributes)e.remove(g.attributes[m]);g.removeEventListener("dispose",o),delete s[g.id],a.unregister(g);let b=r.get(g);b&&(e.remove(b),r.delete(g)),n.releaseStatesOfGeometry(g),g.isInstancedBufferGeometry===!0&&delete g._maxInstanceCount,t.memory.geometries--}function c(g,b){return s[b.id]!==void 0||(b.addEventListener("dispose",o),s[b.id]=new WeakRef(b),a.register(b,b.id,b),t.memory.geometries++),b}function u(g){let b=g.attributes;for(let m in b)e.update(b[m],i.ARRAY_BUFFER)}function f(g){let b=g.index,m=g.attributes.position,p=0;if(m===void 0)return;let v=b!==null?b.array.length:m.array.length/3-1,E=m.count>=65535?Ba:Oa,S=new E(Math.ceil(v/3)*6,1),R=S.array;if(b!==null){let x=b.array;p=b.version;for(let T=0,k=0;T<v;T+=3){let N=x[T+0],L=x[T+1],G=x[T+2];R[k++]=N,R[k++]=L,R[k++]=L,R[k++]=G,R[k++]=G,R[k++]=N}}else{p=m.version;for(let x=0,T=0;x<v;x+=3){let k=x+0,N=x+1,L=x+2;R[T++]=k,R[T++]=N,R[T++]=N,R[T++]=L,R[T++]=L,R[T++]=k}}S.version=p;let A=r.get(g);A&&e.remove(A),r.set(g,S)}function h(g){let b=r.get(g);if(b){let m=g.index;m!==null&&b.version<m.version&&f(g)}else f(g);return r.get(g)}function d(){for(let g in s){let b=s[g].deref();b!==void 0&&l(b)}}return{get:c,update:u,getWireframeAttribute:h,dispose:d}}function M1(i,e,t){let n;function s(f){n=f}let r,a;function o(f){r=f.type,a=f.bytesPerElement}function l(f,h){i.drawElements(n,h,r,f*a),t.update(h,n,1)}function c(f,h,d){d!==0&&(i.drawElementsInstanced(n,h,r,f*a,d),t.update(h,n,d))}function u(f,h,d){if(d===0)return;e.get("WEBGL_multi_draw").multiDrawElementsWEBGL(n,h,0,r,f,0,d);let b=0;for(let m=0;m<d;m++)b+=h[m];t.update(b,n,1)}this.setMode=s,this.setIndex=o,this.render=l,this.renderInstances=c,this.renderMultiDraw=u}function w1(i){let e={geometries:0,textures:0},t={frame:0,calls:0,triangles:0,points:0,lines:0};function n(r,a,o){switch(t.calls++,a){case i.TRIANGLES:t.triangles+=o*(r/3);break;case i.LINES:t.lines+=o*(r/2);break;case i.LINE_STRIP:t.lines+=o*(r-1);break;case i.LINE_LOOP:t.lines+=o*r;break;case i.POINTS:t.points+=o*r;break;default:Qe("WebGLInfo: Unknown draw mode:",a);break}}function s(){t.calls=0,t.triangles=0,t.points=0,t.lines=0}return{memory:e,render:t,programs:null,autoReset:!0,reset:s,update:n}}function T1(i,e,t){let n=new WeakMap,s=new Lt;function r(a,o,l){let c=a.morphTargetInfluences,u=o.morphAttributes.position||o.morphAttributes.normal||o.morphAttributes.color,f=u!==void 0?u.length:0,h=n.get(o);if(h===void 0||h.count!==f){let k=function(){x.dispose(),n.delete(o),o.removeEventListener("dispose",k)};h!==void 0&&h.texture.dispose();let d=o.morphAttributes.position!==void 0,g=o.morphAttributes.normal!==void 0,b=o.morphAttributes.color!==void 0,m=o.morphAttributes.position||[],p=o.morphAttributes.normal||[],v=o.morphAttributes.color||[],E=0;d===!0&&(E=1),g===!0&&(E=2),b===!0&&(E=3);let S=o.attributes.position.count*E,R=1;S>e.maxTextureSize&&(R=Math.ceil(S/e.maxTextureSize),S=e.maxTextureSize);let A=new Float32Array(S*R*4*f),x=new Js(A,S,R,f);x.type=Nt,x.needsUpdate=!0;let T=E*4;for(let N=0;N<f;N++){let L=m[N],G=p[N],H=v[N],D=S*R*4*N;for(let V=0;V<L.count;V++){let Z=V*T;d===!0&&(s.fromBufferAttribute(L,V),A[D+Z+0]=s.x,A[D+Z+1]=s.y,A[D+Z+2]=s.z,A[D+Z+3]=0),g===!0&&(s.fromBufferAttribute(G,V),A[D+Z+4]=s.x,A[D+Z+5]=s.y,A[D+Z+6]=s.z,A[D+Z+7]=0),b===!0&&(s.fromBufferAttribute(H,V),A[D+Z+8]=s.x,A[D+Z+9]=s.y,A[D+Z+10]=s.z,A[D+Z+11]=H.itemSize===4?s.w:1)}}h={count:f,texture:x,size:new ct(S,R)},n.set(o,h),o.addEventListener("dispose",k)}if(a.isInstancedMesh===!0&&a.morphTexture!==null)l.getUniforms().setValue(i,"morphTexture",a.morphTexture,t);else{let d=0;for(let b=0;b<c.length;b++)d+=c[b];let g=o.morphTargetsRelative?1:1-d;l.getUniforms().setValue(i,"morphTargetBaseInfluence",g),l.getUniforms().setValue(i,"morphTargetInfluences",c)}l.getUniforms().setValue(i,"morphTargetsTexture",h.texture,t),l.getUniforms().setValue(i,"morphTargetsTextureSize",h.size)}return{update:r}}function A1(i,e,t,n,s){let r=new WeakMap;function a(c){let u=s.render.frame,f=c.geometry,h=e.get(c,f);if(r.get(h)!==u&&(e.update(h),r.set(h,u)),c.isInstancedMesh&&(c.hasEventListener("dispose",l)===!1&&c.addEventListener("dispose",l),r.get(c)!==u&&(t.update(c.instanceMatrix,i.ARRAY_BUFFER),c.instanceColor!==null&&t.update(c.instanceColor,i.ARRAY_BUFFER),r.set(c,u))),c.isSkinnedMesh){let d=c.skeleton;r.get(d)!==u&&(d.update(),r.set(d,u))}return h}function o(){r=new WeakMap}function l(c){let u=c.target;u.removeEventListener("dispose",l),n.releaseStatesOfObject(u),t.remove(u.instanceMatrix),u.instanceColor!==null&&t.remove(u.instanceColor)}return{update:a,dispose:o}}var E1={[Yu]:"LINEAR_TONE_MAPPING",[$u]:"REINHARD_TONE_MAPPING",[Zu]:"CINEON_TONE_MAPPING",[Ju]:"ACES_FILMIC_TONE_MAPPING",[Qu]:"AGX_TONE_MAPPING",[ju]:"NEUTRAL_TONE_MAPPING",[Ku]:"CUSTOM_TONE_MAPPING"};function R1(i,e,t,n,s,r){let a=new wn(e,t,{type:i,depthBuffer:s,stencilBuffer:r,samples:n?4:0,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,resolveDepthBuffer:!1,resolveStencilBuffer:!1}),o=null,l=null,c=null,u=new di;u.setAttribute("position",new hi([-1,3,0,-1,-1,0,3,-1,0],3)),u.setAttribute("uv",new hi([0,2,0,0,2,0],2));let f=new Xr({uniforms:{tDiffuse:{value:null}},vertexShader:`
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
			}`,depthTest:!1,depthWrite:!1}),h=new pi(u,f),d=new wl(-1,1,1,-1,0,1),g=null,b=null,m=!1,p,v=null,E=[],S=!1;this.setSize=function(R,A){a.setSize(R,A),o!==null&&o.setSize(R,A),l!==null&&l.setSize(R,A);for(let x=0;x<E.length;x++){let T=E[x];T.setSize&&T.setSize(R,A)}},this.setEffects=function(R){E=R,S=E.length>0&&E[0].isRenderPass===!0;let A=a.width,x=a.height;E.length>0&&o===null&&(o=new wn(A,x,{type:Ln,depthBuffer:!1,stencilBuffer:!1}),l=new wn(A,x,{type:Ln,depthBuffer:!1,stencilBuffer:!1}));let T=s===!0&&E.some(k=>k.needsDepthTexture===!0);T!==(a.depthTexture!==null)&&(T===!0&&c===null&&(c=new Ti(A,x),r===!0&&(c.format=fs,c.type=ir)),a.dispose(),a.depthTexture=T?c:null,a.resolveDepthBuffer=T,a.storeMultisampledDepthBuffer=T);for(let k=0;k<E.length;k++){let N=E[k];N.setSize&&N.setSize(A,x),T&&N.needsDepthTexture===!0&&N.setDepthTexture&&N.setDepthTexture(c)}},this.begin=function(R,A){if(m||R.toneMapping===Wi&&E.length===0)return!1;if(v=A,A!==null){let x=A.width,T=A.height;(a.width!==x||a.height!==T)&&this.setSize(x,T)}return S===!1&&R.setRenderTarget(a),p=R.toneMapping,R.toneMapping=Wi,!0},this.hasRenderPass=function(){return S},this.end=function(R,A){R.toneMapping=p,m=!0;let x=a,T=o;for(let k=0;k<E.length;k++){let N=E[k];N.enabled!==!1&&(N.render(R,T,x,A),N.needsSwap!==!1&&(x=T,T=T===o?l:o))}if(g!==R.outputColorSpace||b!==R.toneMapping){g=R.outputColorSpace,b=R.toneMapping,f.defines={},mt.getTransfer(g)===Tt&&(f.defines.SRGB_TRANSFER="");let k=E1[b];k&&(f.defines[k]=""),f.needsUpdate=!0}f.uniforms.tDiffuse.value=x.texture,R.setRenderTarget(v),R.render(h,d),v=null,m=!1},this.isCompositing=function(){return m},this.dispose=function(){a.dispose(),o!==null&&o.dispose(),l!==null&&l.dispose(),u.dispose(),f.dispose()}}var Lp=new Hn,Dp=new Ti(1,1),Np=new ka(1),Fp=new Js,Up=new ll,Op=new za,hp=[],fp=[],dp=new Float32Array(16),pp=new Float32Array(9),mp=new Float32Array(4);function Qr(i,e,t){let n=i[0];if(n<=0||n>0)return i;let s=e*t,r=hp[s];if(r===void 0&&(r=new Float32Array(s),hp[s]=r),e!==0){n.toArray(r,0);for(let a=1,o=0;a!==e;++a)o+=t,i[a].toArray(r,o)}return r}function pn(i,e){if(i.length!==e.length)return!1;for(let t=0,n=i.length;t<n;t++)if(i[t]!==e[t])return!1;return!0}function mn(i,e){for(let t=0,n=e.length;t<n;t++)i[t]=e[t]}function mc(i,e){let t=fp[e];t===void 0&&(t=new Int32Array(e),fp[e]=t);for(let n=0;n!==e;++n)t[n]=i.allocateTextureUnit();return t}function C1(i,e){let t=this.cache;t[0]!==e&&(i.uniform1f(this.addr,e),t[0]=e)}function P1(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(i.uniform2f(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(pn(t,e))return;i.uniform2fv(this.addr,e),mn(t,e)}}function I1(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(i.uniform3f(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else if(e.r!==void 0)(t[0]!==e.r||t[1]!==e.g||t[2]!==e.b)&&(i.uniform3f(this.addr,e.r,e.g,e.b),t[0]=e.r,t[1]=e.g,t[2]=e.b);else{if(pn(t,e))return;i.uniform3fv(this.addr,e),mn(t,e)}}function L1(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(i.uniform4f(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(pn(t,e))return;i.uniform4fv(this.addr,e),mn(t,e)}}function D1(i,e){let t=this.cache,n=e.elements;if(n===void 0){if(pn(t,e))return;i.uniformMatrix2fv(this.addr,!1,e),mn(t,e)}else{if(pn(t,n))return;mp.set(n),i.uniformMatrix2fv(this.addr,!1,mp),mn(t,n)}}function N1(i,e){let t=this.cache,n=e.elements;if(n===void 0){if(pn(t,e))return;i.uniformMatrix3fv(this.addr,!1,e),mn(t,e)}else{if(pn(t,n))return;pp.set(n),i.uniformMatrix3fv(this.addr,!1,pp),mn(t,n)}}function F1(i,e){let t=this.cache,n=e.elements;if(n===void 0){if(pn(t,e))return;i.uniformMatrix4fv(this.addr,!1,e),mn(t,e)}else{if(pn(t,n))return;dp.set(n),i.uniformMatrix4fv(this.addr,!1,dp),mn(t,n)}}function U1(i,e){let t=this.cache;t[0]!==e&&(i.uniform1i(this.addr,e),t[0]=e)}function O1(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(i.uniform2i(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(pn(t,e))return;i.uniform2iv(this.addr,e),mn(t,e)}}function B1(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(i.uniform3i(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(pn(t,e))return;i.uniform3iv(this.addr,e),mn(t,e)}}function z1(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(i.uniform4i(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(pn(t,e))return;i.uniform4iv(this.addr,e),mn(t,e)}}function k1(i,e){let t=this.cache;t[0]!==e&&(i.uniform1ui(this.addr,e),t[0]=e)}function V1(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(i.uniform2ui(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(pn(t,e))return;i.uniform2uiv(this.addr,e),mn(t,e)}}function G1(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(i.uniform3ui(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(pn(t,e))return;i.uniform3uiv(this.addr,e),mn(t,e)}}function H1(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(i.uniform4ui(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(pn(t,e))return;i.uniform4uiv(this.addr,e),mn(t,e)}}function gc(i){return i.version===0&&(i.compareFunction=hh,i.needsUpdate=!0),i}function W1(i,e,t){let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s);let r;this.type===i.SAMPLER_2D_SHADOW?r=gc(Dp):r=Lp,t.setTexture2D(e||r,s)}function X1(i,e,t){let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),t.setTexture3D(e||Up,s)}function q1(i,e,t){let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s);let r;this.type===i.SAMPLER_CUBE_SHADOW?r=gc(Np):r=Op,t.setTextureCube(e||r,s)}function Y1(i,e,t){let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),t.setTexture2DArray(e||Fp,s)}function $1(i){switch(i){case 5126:return C1;case 35664:return P1;case 35665:return I1;case 35666:return L1;case 35674:return D1;case 35675:return N1;case 35676:return F1;case 5124:case 35670:return U1;case 35667:case 35671:return O1;case 35668:case 35672:return B1;case 35669:case 35673:return z1;case 5125:return k1;case 36294:return V1;case 36295:return G1;case 36296:return H1;case 35678:case 36198:case 36298:case 36306:case 35682:return W1;case 35679:case 36299:case 36307:return X1;case 35680:case 36300:case 36308:case 36293:return q1;case 36289:case 36303:case 36311:case 36292:return Y1}}function Z1(i,e){i.uniform1fv(this.addr,e)}function J1(i,e){let t=Qr(e,this.size,2);i.uniform2fv(this.addr,t)}function K1(i,e){let t=Qr(e,this.size,3);i.uniform3fv(this.addr,t)}function Q1(i,e){let t=Qr(e,this.size,4);i.uniform4fv(this.addr,t)}function j1(i,e){let t=Qr(e,this.size,4);i.uniformMatrix2fv(this.addr,!1,t)}function ey(i,e){let t=Qr(e,this.size,9);i.uniformMatrix3fv(this.addr,!1,t)}function ty(i,e){let t=Qr(e,this.size,16);i.uniformMatrix4fv(this.addr,!1,t)}function ny(i,e){i.uniform1iv(this.addr,e)}function iy(i,e){i.uniform2iv(this.addr,e)}function sy(i,e){i.uniform3iv(this.addr,e)}function ry(i,e){i.uniform4iv(this.addr,e)}function ay(i,e){i.uniform1uiv(this.addr,e)}function oy(i,e){i.uniform2uiv(this.addr,e)}function ly(i,e){i.uniform3uiv(this.addr,e)}function cy(i,e){i.uniform4uiv(this.addr,e)}function uy(i,e,t){let n=this.cache,s=e.length,r=mc(t,s);pn(n,r)||(i.uniform1iv(this.addr,r),mn(n,r));let a;this.type===i.SAMPLER_2D_SHADOW?a=gc(Dp):a=Lp;for(let o=0;o!==s;++o)t.setTexture2D(e[o]||a,r[o])}function hy(i,e,t){let n=this.cache,s=e.length,r=mc(t,s);pn(n,r)||(i.uniform1iv(this.addr,r),mn(n,r));for(let a=0;a!==s;++a)t.setTexture3D(e[a]||Up,r[a])}function fy(i,e,t){let n=this.cache,s=e.length,r=mc(t,s);pn(n,r)||(i.uniform1iv(this.addr,r),mn(n,r));let a;this.type===i.SAMPLER_CUBE_SHADOW?a=gc(Np):a=Op;for(let o=0;o!==s;++o)t.setTextureCube(e[o]||a,r[o])}function dy(i,e,t){let n=this.cache,s=e.length,r=mc(t,s);pn(n,r)||(i.uniform1iv(this.addr,r),mn(n,r));for(let a=0;a!==s;++a)t.setTexture2DArray(e[a]||Fp,r[a])}function py(i){switch(i){case 5126:return Z1;case 35664:return J1;case 35665:return K1;case 35666:return Q1;case 35674:return j1;case 35675:return ey;case 35676:return ty;case 5124:case 35670:return ny;case 35667:case 35671:return iy;case 35668:case 35672:return sy;case 35669:case 35673:return ry;case 5125:return ay;case 36294:return oy;case 36295:return ly;case 36296:return cy;case 35678:case 36198:case 36298:case 36306:case 35682:return uy;case 35679:case 36299:case 36307:return hy;case 35680:case 36300:case 36308:case 36293:return fy;case 36289:case 36303:case 36311:case 36292:return dy}}var yh=class{constructor(e,t,n){this.id=e,this.addr=n,this.cache=[],this.type=t.type,this.setValue=$1(t.type)}},bh=class{constructor(e,t,n){this.id=e,this.addr=n,this.cache=[],this.type=t.type,this.size=t.size,this.setValue=py(t.type)}},Sh=class{constructor(e){this.id=e,this.seq=[],this.map={}}setValue(e,t,n){let s=this.seq;for(let r=0,a=s.length;r!==a;++r){let o=s[r];o.setValue(e,t[o.id],n)}}},xh=/(\w+)(\])?(\[|\.)?/g;function gp(i,e){i.seq.push(e),i.map[e.id]=e}function my(i,e,t){let n=i.name,s=n.length;for(xh.lastIndex=0;;){let r=xh.exec(n),a=xh.lastIndex,o=r[1],l=r[2]==="]",c=r[3];if(l&&(o=o|0),c===void 0||c==="["&&a+2===s){gp(t,c===void 0?new yh(o,i,e):new bh(o,i,e));break}else{let f=t.map[o];f===void 0&&(f=new Sh(o),gp(t,f)),t=f}}}var Kr=class{constructor(e,t){this.seq=[],this.map={};let n=e.getProgramParameter(t,e.ACTIVE_UNIFORMS);for(let a=0;a<n;++a){let o=e.getActiveUniform(t,a),l=e.getUniformLocation(t,o.name);my(o,l,this)}let s=[],r=[];for(let a of this.seq)a.type===e.SAMPLER_2D_SHADOW||a.type===e.SAMPLER_CUBE_SHADOW||a.type===e.SAMPLER_2D_ARRAY_SHADOW?s.push(a):r.push(a);s.length>0&&(this.seq=s.concat(r))}setValue(e,t,n,s){let r=this.map[t];r!==void 0&&r.setValue(e,n,s)}setOptional(e,t,n){let s=t[n];s!==void 0&&this.setValue(e,n,s)}static upload(e,t,n,s){for(let r=0,a=t.length;r!==a;++r){let o=t[r],l=n[o.id];l.needsUpdate!==!1&&o.setValue(e,l.value,s)}}static seqWithValue(e,t){let n=[];for(let s=0,r=e.length;s!==r;++s){let a=e[s];a.id in t&&n.push(a)}return n}};function _p(i,e,t){let n=i.createShader(e);return i.shaderSource(n,t),i.compileShader(n),n}var gy=37297,_y=0;function xy(i,e){let t=i.split(`
`),n=[],s=Math.max(e-6,0),r=Math.min(e+6,t.length);for(let a=s;a<r;a++){let o=a+1;n.push(`${o===e?">":" "} ${o}: ${t[a]}`)}return n.join(`
`)}var xp=new je;function vy(i){mt._getMatrix(xp,mt.workingColorSpace,i);let e=`mat3( ${xp.elements.map(t=>t.toFixed(4))} )`;switch(mt.getTransfer(i)){case La:return[e,"LinearTransferOETF"];case Tt:return[e,"sRGBTransferOETF"];default:return $e("WebGLProgram: Unsupported color space: ",i),[e,"LinearTransferOETF"]}}function vp(i,e,t){let n=i.getShaderParameter(e,i.COMPILE_STATUS),r=(i.getShaderInfoLog(e)||"").trim();if(n&&r==="")return"";let a=/ERROR: 0:(\d+)/.exec(r);if(a){let o=parseInt(a[1]);return t.toUpperCase()+`

`+r+`

`+xy(i.getShaderSource(e),o)}else return r}function yy(i,e){let t=vy(e);return[`vec4 ${i}( vec4 value ) {`,`	return ${t[1]}( vec4( ${t[0]} * value.rgb, value.a ) );`,"}"].join(`
`)}var by={[Yu]:"Linear",[$u]:"Reinhard",[Zu]:"Cineon",[Ju]:"ACESFilmic",[Qu]:"AgX",[ju]:"Neutral",[Ku]:"Custom"};function Sy(i,e){let t=by[e];return t===void 0?($e("WebGLProgram: Unsupported toneMapping:",e),"vec3 "+i+"( vec3 color ) { return LinearToneMapping( color ); }"):"vec3 "+i+"( vec3 color ) { return "+t+"ToneMapping( color ); }"}var fc=new Y;function My(){mt.getLuminanceCoefficients(fc);let i=fc.x.toFixed(4),e=fc.y.toFixed(4),t=fc.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${i}, ${e}, ${t} );`,"	return dot( weights, rgb );","}"].join(`
`)}function wy(i){return[i.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",i.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(to).join(`
`)}function Ty(i){let e=[];for(let t in i){let n=i[t];n!==!1&&e.push("#define "+t+" "+n)}return e.join(`
`)}function Ay(i,e){let t={},n=i.getProgramParameter(e,i.ACTIVE_ATTRIBUTES);for(let s=0;s<n;s++){let r=i.getActiveAttrib(e,s),a=r.name,o=1;r.type===i.FLOAT_MAT2&&(o=2),r.type===i.FLOAT_MAT3&&(o=3),r.type===i.FLOAT_MAT4&&(o=4),t[a]={type:r.type,location:i.getAttribLocation(e,a),locationSize:o}}return t}function to(i){return i!==""}function yp(i,e){let t=e.numSpotLightShadows+e.numSpotLightMaps-e.numSpotLightShadowsWithMaps;return i.replace(/NUM_SUN_LIGHTS/g,e.numSunLights).replace(/NUM_DIR_LIGHTS/g,e.numDirLights).replace(/NUM_SPOT_LIGHTS/g,e.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,e.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,t).replace(/NUM_RECT_AREA_LIGHTS/g,e.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,e.numPointLights).replace(/NUM_HEMI_LIGHTS/g,e.numHemiLights).replace(/NUM_SUN_LIGHT_SHADOWS/g,e.numSunLightShadows).replace(/NUM_DIR_LIGHT_SHADOWS/g,e.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,e.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,e.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,e.numPointLightShadows).replace(/NUM_LIGHT_PROBE_GRIDS/g,e.numLightProbeGrids)}function bp(i,e){return i.replace(/NUM_CLIPPING_PLANES/g,e.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,e.numClippingPlanes-e.numClipIntersection)}var Ey=/^[ \t]*#include +<([\w\d./]+)>/gm;function Mh(i){return i.replace(Ey,Ry)}function Ry(i,e){let t=ot[e];if(t===void 0)throw new Error("THREE.WebGLProgram: Can not resolve #include <"+e+">");return Mh(t)}var Cy=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function Sp(i){return i.replace(Cy,Py)}function Py(i,e,t,n){let s="";for(let r=parseInt(e);r<parseInt(t);r++)s+=n.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return s}function Mp(i){let e=`precision ${i.precision} float;
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
#define LOW_PRECISION`),e}var Iy={[Wa]:"SHADOWMAP_TYPE_PCF",[Yr]:"SHADOWMAP_TYPE_VSM"};function Ly(i){return Iy[i.shadowMapType]||"SHADOWMAP_TYPE_BASIC"}var Dy={[Zr]:"ENVMAP_MODE_REFRACTION"};function Ny(i){return i.envMap===!1?"ENVMAP_MODE_REFLECTION":Dy[i.envMapMode]||"ENVMAP_MODE_REFLECTION"}var Fy={[qu]:"ENVMAP_BLENDING_MULTIPLY",[kd]:"ENVMAP_BLENDING_MIX",[Vd]:"ENVMAP_BLENDING_ADD"};function Uy(i){return i.envMap===!1?"ENVMAP_BLENDING_NONE":Fy[i.combine]||"ENVMAP_BLENDING_NONE"}function Oy(i,e,t,n){let s=i.getContext(),r=t.defines,a=t.vertexShader,o=t.fragmentShader,l=Ly(t),c=t.envMapPMREM===!0?"ENVMAP_TYPE_PMREM":"ENVMAP_TYPE_CUBE",u=Ny(t),f=Uy(t),h=wy(t),d=Ty(r),g=s.createProgram(),b,m,p=t.glslVersion?"#version "+t.glslVersion+`
`:"";t.isRawShaderMaterial?(b=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,d].filter(to).join(`
`),b.length>0&&(b+=`
`),m=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,d].filter(to).join(`
`),m.length>0&&(m+=`
`)):(b=[Mp(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,d,t.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",t.batching?"#define USE_BATCHING":"",t.batchingColor?"#define USE_BATCHING_COLOR":"",t.instancing?"#define USE_INSTANCING":"",t.instancingColor?"#define USE_INSTANCING_COLOR":"",t.instancingMorph?"#define USE_INSTANCING_MORPH":"",t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.map?"#define USE_MAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+u:"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.displacementMap?"#define USE_DISPLACEMENTMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.mapUv?"#define MAP_UV "+t.mapUv:"",t.alphaMapUv?"#define ALPHAMAP_UV "+t.alphaMapUv:"",t.lightMapUv?"#define LIGHTMAP_UV "+t.lightMapUv:"",t.aoMapUv?"#define AOMAP_UV "+t.aoMapUv:"",t.emissiveMapUv?"#define EMISSIVEMAP_UV "+t.emissiveMapUv:"",t.bumpMapUv?"#define BUMPMAP_UV "+t.bumpMapUv:"",t.normalMapUv?"#define NORMALMAP_UV "+t.normalMapUv:"",t.displacementMapUv?"#define DISPLACEMENTMAP_UV "+t.displacementMapUv:"",t.metalnessMapUv?"#define METALNESSMAP_UV "+t.metalnessMapUv:"",t.roughnessMapUv?"#define ROUGHNESSMAP_UV "+t.roughnessMapUv:"",t.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+t.anisotropyMapUv:"",t.clearcoatMapUv?"#define CLEARCOATMAP_UV "+t.clearcoatMapUv:"",t.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+t.clearcoatNormalMapUv:"",t.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+t.clearcoatRoughnessMapUv:"",t.diffuseRoughnessMapUv?"#define DIFFUSE_ROUGHNESSMAP_UV "+t.diffuseRoughnessMapUv:"",t.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+t.iridescenceMapUv:"",t.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+t.iridescenceThicknessMapUv:"",t.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+t.sheenColorMapUv:"",t.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+t.sheenRoughnessMapUv:"",t.specularMapUv?"#define SPECULARMAP_UV "+t.specularMapUv:"",t.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+t.specularColorMapUv:"",t.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+t.specularIntensityMapUv:"",t.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+t.transmissionMapUv:"",t.thicknessMapUv?"#define THICKNESSMAP_UV "+t.thicknessMapUv:"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexNormals?"#define HAS_NORMAL":"",t.vertexColors?"#define USE_COLOR":"",t.vertexAlphas?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.flatShading?"#define FLAT_SHADED":"",t.skinning?"#define USE_SKINNING":"",t.morphTargets?"#define USE_MORPHTARGETS":"",t.morphNormals&&t.flatShading===!1?"#define USE_MORPHNORMALS":"",t.morphColors?"#define USE_MORPHCOLORS":"",t.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+t.morphTextureStride:"",t.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+t.morphTargetsCount:"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.sizeAttenuation?"#define USE_SIZEATTENUATION":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(to).join(`
`),m=[Mp(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,d,t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",t.map?"#define USE_MAP":"",t.matcap?"#define USE_MATCAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+c:"",t.envMap?"#define "+u:"",t.envMap?"#define "+f:"",t.envMapPMREM?"#define ENVMAP_MAX_LOD "+t.envMapMaxLod+".0":"",t.envMapPMREM?"#define ENVMAP_SIZE "+t.envMapSize+".0":"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.packedNormalMap?"#define USE_PACKED_NORMALMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoat?"#define USE_CLEARCOAT":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughness?"#define USE_DIFFUSE_ROUGHNESS":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.dispersion?"#define USE_DISPERSION":"",t.retroreflection?"#define USE_RETROREFLECTION":"",t.iridescence?"#define USE_IRIDESCENCE":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaTest?"#define USE_ALPHATEST":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.sheen?"#define USE_SHEEN":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexColors||t.instancingColor?"#define USE_COLOR":"",t.vertexAlphas||t.batchingColor?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.gradientMap?"#define USE_GRADIENTMAP":"",t.flatShading?"#define FLAT_SHADED":"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",t.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",t.toneMapping!==Wi?"#define TONE_MAPPING":"",t.toneMapping!==Wi?ot.tonemapping_pars_fragment:"",t.toneMapping!==Wi?Sy("toneMapping",t.toneMapping):"",t.dithering?"#define DITHERING":"",t.opaque?"#define OPAQUE":"",ot.colorspace_pars_fragment,yy("linearToOutputTexel",t.outputColorSpace),My(),t.useDepthPacking?"#define DEPTH_PACKING "+t.depthPacking:"",`
`].filter(to).join(`
`)),a=Mh(a),a=yp(a,t),a=bp(a,t),o=Mh(o),o=yp(o,t),o=bp(o,t),a=Sp(a),o=Sp(o),t.isRawShaderMaterial!==!0&&(p=`#version 300 es
`,b=[h,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+b,m=["#define varying in",t.glslVersion===Qa?"":"layout(location = 0) out highp vec4 pc_fragColor;",t.glslVersion===Qa?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+m);let v=p+b+a,E=p+m+o,S=_p(s,s.VERTEX_SHADER,v),R=_p(s,s.FRAGMENT_SHADER,E);s.attachShader(g,S),s.attachShader(g,R),t.index0AttributeName!==void 0?s.bindAttribLocation(g,0,t.index0AttributeName):t.hasPositionAttribute===!0&&s.bindAttribLocation(g,0,"position"),s.linkProgram(g);function A(N){if(i.debug.checkShaderErrors){let L=s.getProgramInfoLog(g)||"",G=s.getShaderInfoLog(S)||"",H=s.getShaderInfoLog(R)||"",D=L.trim(),V=G.trim(),Z=H.trim(),z=!0,le=!0;if(s.getProgramParameter(g,s.LINK_STATUS)===!1)if(z=!1,typeof i.debug.onShaderError=="function")i.debug.onShaderError(s,g,S,R);else{let J=vp(s,S,"vertex"),Q=vp(s,R,"fragment");Qe("WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(g,s.VALIDATE_STATUS)+`

Material Name: `+N.name+`
Material Type: `+N.type+`

Program Info Log: `+D+`
`+J+`
`+Q)}else D!==""?$e("WebGLProgram: Program Info Log:",D):(V===""||Z==="")&&(le=!1);le&&(N.diagnostics={runnable:z,programLog:D,vertexShader:{log:V,prefix:b},fragmentShader:{log:Z,prefix:m}})}s.deleteShader(S),s.deleteShader(R),x=new Kr(s,g),T=Ay(s,g)}let x;this.getUniforms=function(){return x===void 0&&A(this),x};let T;this.getAttributes=function(){return T===void 0&&A(this),T};let k=t.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return k===!1&&(k=s.getProgramParameter(g,gy)),k},this.destroy=function(){n.releaseStatesOfProgram(this),s.deleteProgram(g),this.program=void 0},this.type=t.shaderType,this.name=t.shaderName,this.id=_y++,this.cacheKey=e,this.usedTimes=1,this.program=g,this.vertexShader=S,this.fragmentShader=R,this}var By=0,wh=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(e,t,n){let s=this._getShaderCacheForMaterial(e);return s.has(t)===!1&&(s.add(t),t.usedTimes++),s.has(n)===!1&&(s.add(n),n.usedTimes++),this}remove(e){let t=this.materialCache.get(e);for(let n of t)n.usedTimes--,n.usedTimes===0&&this.shaderCache.delete(n.code);return this.materialCache.delete(e),this}getVertexShaderStage(e){return this._getShaderStage(e.vertexShader)}getFragmentShaderStage(e){return this._getShaderStage(e.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(e){let t=this.materialCache,n=t.get(e);return n===void 0&&(n=new Set,t.set(e,n)),n}_getShaderStage(e){let t=this.shaderCache,n=t.get(e);return n===void 0&&(n=new Th(e),t.set(e,n)),n}},Th=class{constructor(e){this.id=By++,this.code=e,this.usedTimes=0}};function zy(i){return i===Xi||i===Ja||i===Ka}function ky(i,e,t,n,s,r){let a=new Fa,o=new wh,l=new Set,c=[],u=new Map,f=n.logarithmicDepthBuffer,h={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distance",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function d(x){return l.add(x),x===0?"uv":`uv${x}`}function g(x,T,k,N,L,G){let H=N.fog,D=L.geometry,V=x.isMeshStandardMaterial||x.isMeshLambertMaterial||x.isMeshPhongMaterial?N.environment:null,Z=x.isMeshStandardMaterial||x.isMeshLambertMaterial&&!x.envMap||x.isMeshPhongMaterial&&!x.envMap,z=e.get(x.envMap||V,Z),le=h[x.type],J=n.precision;x.precision!==null&&(J=n.getMaxPrecision(x.precision),J!==x.precision&&$e("WebGLProgram.getParameters:",x.precision,"not supported, using",J,"instead."));let Q=D.morphAttributes.position||D.morphAttributes.normal||D.morphAttributes.color,ie=Q!==void 0?Q.length:0,he=0;D.morphAttributes.position!==void 0&&(he=1),D.morphAttributes.normal!==void 0&&(he=2),D.morphAttributes.color!==void 0&&(he=3);let ue,j,me,xe;if(le){let Re=Yi[le];ue=Re.vertexShader,j=Re.fragmentShader}else{ue=x.vertexShader,j=x.fragmentShader;let Re=o.getVertexShaderStage(x),st=o.getFragmentShaderStage(x);o.update(x,Re,st),me=Re.id,xe=st.id}let Ee=i.getRenderTarget(),Se=i.state.buffers.depth.getReversed(),He=L.isInstancedMesh===!0,nt=L.isBatchedMesh===!0,Ve=!!x.map,lt=!!x.matcap,rt=!!z,et=rt&&z.isPMREMTexture===!0,Wt=!!x.aoMap,Ot=!!x.lightMap,tn=!!x.bumpMap&&x.wireframe===!1,Pt=!!x.normalMap,xn=!!x.displacementMap,xt=!!x.emissiveMap,fn=!!x.metalnessMap,$t=!!x.roughnessMap,nn=x.anisotropy>0,U=x.clearcoat>0,Ce=x.diffuseRoughness>0,qe=x.dispersion>0,it=x.retroreflectivity>0,Me=x.iridescence>0,Dt=x.sheen>0,ke=x.transmission>0,Xe=nn&&!!x.anisotropyMap,C=U&&!!x.clearcoatMap,y=U&&!!x.clearcoatNormalMap,W=U&&!!x.clearcoatRoughnessMap,ce=Ce&&!!x.diffuseRoughnessMap,re=Me&&!!x.iridescenceMap,_e=Me&&!!x.iridescenceThicknessMap,ve=Dt&&!!x.sheenColorMap,ee=Dt&&!!x.sheenRoughnessMap,ne=!!x.specularMap,de=!!x.specularColorMap,F=!!x.specularIntensityMap,se=ke&&!!x.transmissionMap,te=ke&&!!x.thicknessMap,we=!!x.gradientMap,ge=!!x.alphaMap,be=x.alphaTest>0,Ge=!!x.alphaHash,Ze=!!x.extensions,oe=Wi;x.toneMapped&&(Ee===null||Ee.isXRRenderTarget===!0)&&(oe=i.toneMapping);let Oe=et?z.isCompressedCubeTexture?z.image[0].mipmaps:z.mipmaps:null,Je={shaderID:le,shaderType:x.type,shaderName:x.name,vertexShader:ue,fragmentShader:j,defines:x.defines,customVertexShaderID:me,customFragmentShaderID:xe,isRawShaderMaterial:x.isRawShaderMaterial===!0,glslVersion:x.glslVersion,precision:J,batching:nt,batchingColor:nt&&L._colorsTexture!==null,instancing:He,instancingColor:He&&L.instanceColor!==null,instancingMorph:He&&L.morphTexture!==null,outputColorSpace:Ee===null?i.outputColorSpace:Ee.isXRRenderTarget===!0?Ee.texture.colorSpace:mt.workingColorSpace,alphaToCoverage:!!x.alphaToCoverage,map:Ve,matcap:lt,envMap:rt,envMapMode:rt&&z.mapping,envMapPMREM:et,envMapMaxLod:et?Oe.length-1:null,envMapSize:et?Oe[0].width:null,aoMap:Wt,lightMap:Ot,bumpMap:tn,normalMap:Pt,displacementMap:xn,emissiveMap:xt,normalMapObjectSpace:Pt&&x.normalMapType===Wd,normalMapTangentSpace:Pt&&x.normalMapType===lh,packedNormalMap:Pt&&x.normalMapType===lh&&zy(x.normalMap.format),metalnessMap:fn,roughnessMap:$t,anisotropy:nn,anisotropyMap:Xe,clearcoat:U,clearcoatMap:C,clearcoatNormalMap:y,clearcoatRoughnessMap:W,diffuseRoughness:Ce,diffuseRoughnessMap:ce,dispersion:qe,retroreflection:it,iridescence:Me,iridescenceMap:re,iridescenceThicknessMap:_e,sheen:Dt,sheenColorMap:ve,sheenRoughnessMap:ee,specularMap:ne,specularColorMap:de,specularIntensityMap:F,transmission:ke,transmissionMap:se,thicknessMap:te,gradientMap:we,opaque:x.transparent===!1&&x.blending===$r&&x.alphaToCoverage===!1,alphaMap:ge,alphaTest:be,alphaHash:Ge,combine:x.combine,mapUv:Ve&&d(x.map.channel),aoMapUv:Wt&&d(x.aoMap.channel),lightMapUv:Ot&&d(x.lightMap.channel),bumpMapUv:tn&&d(x.bumpMap.channel),normalMapUv:Pt&&d(x.normalMap.channel),displacementMapUv:xn&&d(x.displacementMap.channel),emissiveMapUv:xt&&d(x.emissiveMap.channel),metalnessMapUv:fn&&d(x.metalnessMap.channel),roughnessMapUv:$t&&d(x.roughnessMap.channel),anisotropyMapUv:Xe&&d(x.anisotropyMap.channel),clearcoatMapUv:C&&d(x.clearcoatMap.channel),clearcoatNormalMapUv:y&&d(x.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:W&&d(x.clearcoatRoughnessMap.channel),diffuseRoughnessMapUv:ce&&d(x.diffuseRoughnessMap.channel),iridescenceMapUv:re&&d(x.iridescenceMap.channel),iridescenceThicknessMapUv:_e&&d(x.iridescenceThicknessMap.channel),sheenColorMapUv:ve&&d(x.sheenColorMap.channel),sheenRoughnessMapUv:ee&&d(x.sheenRoughnessMap.channel),specularMapUv:ne&&d(x.specularMap.channel),specularColorMapUv:de&&d(x.specularColorMap.channel),specularIntensityMapUv:F&&d(x.specularIntensityMap.channel),transmissionMapUv:se&&d(x.transmissionMap.channel),thicknessMapUv:te&&d(x.thicknessMap.channel),alphaMapUv:ge&&d(x.alphaMap.channel),vertexTangents:!!D.attributes.tangent&&(Pt||nn),vertexNormals:!!D.attributes.normal,vertexColors:x.vertexColors,vertexAlphas:x.vertexColors===!0&&!!D.attributes.color&&D.attributes.color.itemSize===4,pointsUvs:L.isPoints===!0&&!!D.attributes.uv&&(Ve||ge),fog:!!H,useFog:x.fog===!0,fogExp2:!!H&&H.isFogExp2,flatShading:x.wireframe===!1&&(x.flatShading===!0||D.attributes.normal===void 0&&Pt===!1&&(x.isMeshLambertMaterial||x.isMeshPhongMaterial||x.isMeshStandardMaterial||x.isMeshPhysicalMaterial)),sizeAttenuation:x.sizeAttenuation===!0,logarithmicDepthBuffer:f,reversedDepthBuffer:Se,skinning:L.isSkinnedMesh===!0,hasPositionAttribute:D.attributes.position!==void 0,morphTargets:D.morphAttributes.position!==void 0,morphNormals:D.morphAttributes.normal!==void 0,morphColors:D.morphAttributes.color!==void 0,morphTargetsCount:ie,morphTextureStride:he,numSunLights:T.sun.length,numDirLights:T.directional.length,numPointLights:T.point.length,numSpotLights:T.spot.length,numSpotLightMaps:T.spotLightMap.length,numRectAreaLights:T.rectArea.length,numHemiLights:T.hemi.length,numSunLightShadows:T.sunShadowMap.length,numDirLightShadows:T.directionalShadowMap.length,numPointLightShadows:T.pointShadowMap.length,numSpotLightShadows:T.spotShadowMap.length,numSpotLightShadowsWithMaps:T.numSpotLightShadowsWithMaps,numLightProbes:T.numLightProbes,numLightProbeGrids:G.filter(Re=>Re.texture!==null).length,numClippingPlanes:r.numPlanes,numClipIntersection:r.numIntersection,dithering:x.dithering,shadowMapEnabled:i.shadowMap.enabled&&k.length>0,shadowMapType:i.shadowMap.type,toneMapping:oe,decodeVideoTexture:Ve&&x.map.isVideoTexture===!0&&mt.getTransfer(x.map.colorSpace)===Tt,decodeVideoTextureEmissive:xt&&x.emissiveMap.isVideoTexture===!0&&mt.getTransfer(x.emissiveMap.colorSpace)===Tt,premultipliedAlpha:x.premultipliedAlpha,doubleSided:x.side===Hi,flipSided:x.side===Vn,useDepthPacking:x.depthPacking>=0,depthPacking:x.depthPacking||0,index0AttributeName:x.index0AttributeName,extensionClipCullDistance:Ze&&x.extensions.clipCullDistance===!0&&t.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(Ze&&x.extensions.multiDraw===!0||nt)&&t.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:t.has("KHR_parallel_shader_compile"),customProgramCacheKey:x.customProgramCacheKey()};return Je.vertexUv1s=l.has(1),Je.vertexUv2s=l.has(2),Je.vertexUv3s=l.has(3),l.clear(),Je}function b(x){let T=[];if(x.shaderID?T.push(x.shaderID):(T.push(x.customVertexShaderID),T.push(x.customFragmentShaderID)),x.defines!==void 0)for(let k in x.defines)T.push(k),T.push(x.defines[k]);return x.isRawShaderMaterial===!1&&(m(T,x),p(T,x),T.push(i.outputColorSpace)),T.push(x.customProgramCacheKey),T.join()}function m(x,T){x.push(T.precision),x.push(T.outputColorSpace),x.push(T.envMapMode),x.push(T.envMapPMREM),x.push(T.envMapMaxLod),x.push(T.envMapSize),x.push(T.mapUv),x.push(T.alphaMapUv),x.push(T.lightMapUv),x.push(T.aoMapUv),x.push(T.bumpMapUv),x.push(T.normalMapUv),x.push(T.displacementMapUv),x.push(T.emissiveMapUv),x.push(T.metalnessMapUv),x.push(T.roughnessMapUv),x.push(T.anisotropyMapUv),x.push(T.clearcoatMapUv),x.push(T.clearcoatNormalMapUv),x.push(T.clearcoatRoughnessMapUv),x.push(T.diffuseRoughnessMapUv),x.push(T.iridescenceMapUv),x.push(T.iridescenceThicknessMapUv),x.push(T.sheenColorMapUv),x.push(T.sheenRoughnessMapUv),x.push(T.specularMapUv),x.push(T.specularColorMapUv),x.push(T.specularIntensityMapUv),x.push(T.transmissionMapUv),x.push(T.thicknessMapUv),x.push(T.combine),x.push(T.fogExp2),x.push(T.sizeAttenuation),x.push(T.morphTargetsCount),x.push(T.numSunLights),x.push(T.numDirLights),x.push(T.numPointLights),x.push(T.numSpotLights),x.push(T.numSpotLightMaps),x.push(T.numHemiLights),x.push(T.numRectAreaLights),x.push(T.numSunLightShadows),x.push(T.numDirLightShadows),x.push(T.numPointLightShadows),x.push(T.numSpotLightShadows),x.push(T.numSpotLightShadowsWithMaps),x.push(T.numLightProbes),x.push(T.numLightProbeGrids),x.push(T.shadowMapType),x.push(T.toneMapping),x.push(T.numClippingPlanes),x.push(T.numClipIntersection),x.push(T.depthPacking)}function p(x,T){a.disableAll(),T.instancing&&a.enable(0),T.instancingColor&&a.enable(1),T.instancingMorph&&a.enable(2),T.matcap&&a.enable(3),T.envMap&&a.enable(4),T.normalMapObjectSpace&&a.enable(5),T.normalMapTangentSpace&&a.enable(6),T.clearcoat&&a.enable(7),T.iridescence&&a.enable(8),T.alphaTest&&a.enable(9),T.vertexColors&&a.enable(10),T.vertexAlphas&&a.enable(11),T.vertexUv1s&&a.enable(12),T.vertexUv2s&&a.enable(13),T.vertexUv3s&&a.enable(14),T.vertexTangents&&a.enable(15),T.anisotropy&&a.enable(16),T.alphaHash&&a.enable(17),T.batching&&a.enable(18),T.dispersion&&a.enable(19),T.retroreflection&&a.enable(24),T.diffuseRoughness&&a.enable(25),T.batchingColor&&a.enable(20),T.gradientMap&&a.enable(21),T.packedNormalMap&&a.enable(22),T.vertexNormals&&a.enable(23),x.push(a.mask),a.disableAll(),T.fog&&a.enable(0),T.useFog&&a.enable(1),T.flatShading&&a.enable(2),T.logarithmicDepthBuffer&&a.enable(3),T.reversedDepthBuffer&&a.enable(4),T.skinning&&a.enable(5),T.morphTargets&&a.enable(6),T.morphNormals&&a.enable(7),T.morphColors&&a.enable(8),T.premultipliedAlpha&&a.enable(9),T.shadowMapEnabled&&a.enable(10),T.doubleSided&&a.enable(11),T.flipSided&&a.enable(12),T.useDepthPacking&&a.enable(13),T.dithering&&a.enable(14),T.transmission&&a.enable(15),T.sheen&&a.enable(16),T.opaque&&a.enable(17),T.pointsUvs&&a.enable(18),T.decodeVideoTexture&&a.enable(19),T.decodeVideoTextureEmissive&&a.enable(20),T.alphaToCoverage&&a.enable(21),T.numLightProbeGrids>0&&a.enable(22),T.hasPositionAttribute&&a.enable(23),x.push(a.mask)}function v(x){let T=h[x.type],k;if(T){let N=Yi[T];k=sp.clone(N.uniforms)}else k=x.uniforms;return k}function E(x,T){let k=u.get(T);return k!==void 0?++k.usedTimes:(k=new Oy(i,T,x,s),c.push(k),u.set(T,k)),k}function S(x){if(--x.usedTimes===0){let T=c.indexOf(x);c[T]=c[c.length-1],c.pop(),u.delete(x.cacheKey),x.destroy()}}function R(x){o.remove(x)}function A(){o.dispose()}return{getParameters:g,getProgramCacheKey:b,getUniforms:v,acquireProgram:E,releaseProgram:S,releaseShaderCache:R,programs:c,dispose:A}}function Vy(){let i=new WeakMap;function e(a){return i.has(a)}function t(a){let o=i.get(a);return o===void 0&&(o={},i.set(a,o)),o}function n(a){i.delete(a)}function s(a,o,l){i.get(a)[o]=l}function r(){i=new WeakMap}return{has:e,get:t,remove:n,update:s,dispose:r}}function Gy(i,e){return i.groupOrder!==e.groupOrder?i.groupOrder-e.groupOrder:i.renderOrder!==e.renderOrder?i.renderOrder-e.renderOrder:i.material.id!==e.material.id?i.material.id-e.material.id:i.materialVariant!==e.materialVariant?i.materialVariant-e.materialVariant:i.z!==e.z?i.z-e.z:i.id-e.id}function wp(i,e){return i.groupOrder!==e.groupOrder?i.groupOrder-e.groupOrder:i.renderOrder!==e.renderOrder?i.renderOrder-e.renderOrder:i.z!==e.z?e.z-i.z:i.id-e.id}function Tp(){let i=[],e=0,t=[],n=[],s=[];function r(){e=0,t.length=0,n.length=0,s.length=0}function a(h){let d=0;return h.isInstancedMesh&&(d+=2),h.isSkinnedMesh&&(d+=1),d}function o(h,d,g,b,m,p){let v=i[e];return v===void 0?(v={id:h.id,object:h,geometry:d,material:g,materialVariant:a(h),groupOrder:b,renderOrder:h.renderOrder,z:m,group:p},i[e]=v):(v.id=h.id,v.object=h,v.geometry=d,v.material=g,v.materialVariant=a(h),v.groupOrder=b,v.renderOrder=h.renderOrder,v.z=m,v.group=p),e++,v}function l(h,d,g,b,m,p,v){v.reversedDepth===!0&&(m=-m);let E=o(h,d,g,b,m,p);g.transmission>0?n.push(E):g.transparent===!0?s.push(E):t.push(E)}function c(h,d,g,b,m,p){let v=o(h,d,g,b,m,p);g.transmission>0?n.unshift(v):g.transparent===!0?s.unshift(v):t.unshift(v)}function u(h,d){t.length>1&&t.sort(h||Gy),n.length>1&&n.sort(d||wp),s.length>1&&s.sort(d||wp)}function f(){for(let h=e,d=i.length;h<d;h++){let g=i[h];if(g.id===null)break;g.id=null,g.object=null,g.geometry=null,g.material=null,g.group=null}}return{opaque:t,transmissive:n,transparent:s,init:r,push:l,unshift:c,finish:f,sort:u}}function Hy(){let i=new WeakMap;function e(n,s){let r=i.get(n),a;return r===void 0?(a=new Tp,i.set(n,[a])):s>=r.length?(a=new Tp,r.push(a)):a=r[s],a}function t(){i=new WeakMap}return{get:e,dispose:t}}function Wy(){let i={};return{get:function(e){if(i[e.id]!==void 0)return i[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={direction:new Y,color:new vt};break;case"SpotLight":t={position:new Y,direction:new Y,color:new vt,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":t={position:new Y,color:new vt,distance:0,decay:0};break;case"HemisphereLight":t={direction:new Y,skyColor:new vt,groundColor:new vt};break;case"RectAreaLight":t={color:new vt,position:new Y,halfWidth:new Y,halfHeight:new Y};break}return i[e.id]=t,t}}}function Xy(){let i={};return{get:function(e){if(i[e.id]!==void 0)return i[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new ct};break;case"SpotLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new ct};break;case"PointLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new ct,shadowCameraNear:1,shadowCameraFar:1e3};break}return i[e.id]=t,t}}}var qy=0;function Yy(i,e){return(e.castShadow?2:0)-(i.castShadow?2:0)+(e.map?1:0)-(i.map?1:0)}function $y(i){let e=new Wy,t=Xy(),n={version:0,hash:{sunLength:-1,directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numSunShadows:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],sun:[],sunShadow:[],sunShadowMap:[],sunShadowMatrix:[],sunShadowCascade:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let c=0;c<9;c++)n.probe.push(new Y);let s=new Y,r=new dt,a=new dt;function o(c){let u=0,f=0,h=0;for(let G=0;G<9;G++)n.probe[G].set(0,0,0);let d=0,g=0,b=0,m=0,p=0,v=0,E=0,S=0,R=0,A=0,x=0,T=0,k=0,N=0;c.sort(Yy);for(let G=0,H=c.length;G<H;G++){let D=c[G],V=D.color,Z=D.intensity,z=D.distance,le=null;if(D.shadow&&D.shadow.map&&(D.shadow.map.texture.format===Xi?le=D.shadow.map.texture:le=D.shadow.map.depthTexture||D.shadow.map.texture),D.isAmbientLight)u+=V.r*Z,f+=V.g*Z,h+=V.b*Z;else if(D.isLightProbe){for(let J=0;J<9;J++)n.probe[J].addScaledVector(D.sh.coefficients[J],Z);N++}else if(D.isSunLight){let J=e.get(D);if(J.color.copy(D.color).multiplyScalar(D.intensity),D.castShadow){let Q=D.shadow,ie=t.get(D);ie.shadowIntensity=Q.intensity,ie.shadowBias=Q.bias,ie.shadowNormalBias=Q.normalBias,ie.shadowRadius=Q.radius,ie.shadowMapSize.copy(Q.mapSize).multiply(Q.getFrameExtents()),n.sunShadow[g]=ie,n.sunShadowMap[g]=le;let he=Q.getViewportCount();for(let ue=0;ue<he;ue++)n.sunShadowMatrix[b+ue]=Q.getMatrix(ue),n.sunShadowCascade[b+ue]=Q._cascadeData[ue];b+=he,g++}n.sun[d]=J,d++}else if(D.isDirectionalLight){let J=e.get(D);if(J.color.copy(D.color).multiplyScalar(D.intensity),D.castShadow){let Q=D.shadow,ie=t.get(D);ie.shadowIntensity=Q.intensity,ie.shadowBias=Q.bias,ie.shadowNormalBias=Q.normalBias,ie.shadowRadius=Q.radius,ie.shadowMapSize=Q.mapSize,n.directionalShadow[m]=ie,n.directionalShadowMap[m]=le,n.directionalShadowMatrix[m]=D.shadow.matrix,R++}n.directional[m]=J,m++}else if(D.isSpotLight){let J=e.get(D);J.position.setFromMatrixPosition(D.matrixWorld),J.color.copy(V).multiplyScalar(Z),J.distance=z,J.coneCos=Math.cos(D.angle),J.penumbraCos=Math.cos(D.angle*(1-D.penumbra)),J.decay=D.decay,n.spot[v]=J;let Q=D.shadow;if(D.map&&(n.spotLightMap[T]=D.map,T++,Q.updateMatrices(D),D.castShadow&&k++),n.spotLightMatrix[v]=Q.matrix,D.castShadow){let ie=t.get(D);ie.shadowIntensity=Q.intensity,ie.shadowBias=Q.bias,ie.shadowNormalBias=Q.normalBias,ie.shadowRadius=Q.radius,ie.shadowMapSize=Q.mapSize,n.spotShadow[v]=ie,n.spotShadowMap[v]=le,x++}v++}else if(D.isRectAreaLight){let J=e.get(D);J.color.copy(V).multiplyScalar(Z),J.halfWidth.set(D.width*.5,0,0),J.halfHeight.set(0,D.height*.5,0),n.rectArea[E]=J,E++}else if(D.isPointLight){let J=e.get(D);if(J.color.copy(D.color).multiplyScalar(D.intensity),J.distance=D.distance,J.decay=D.decay,D.castShadow){let Q=D.shadow,ie=t.get(D);ie.shadowIntensity=Q.intensity,ie.shadowBias=Q.bias,ie.shadowNormalBias=Q.normalBias,ie.shadowRadius=Q.radius,ie.shadowMapSize=Q.mapSize,ie.shadowCameraNear=Q.camera.near,ie.shadowCameraFar=Q.camera.far,n.pointShadow[p]=ie,n.pointShadowMap[p]=le,n.pointShadowMatrix[p]=D.shadow.matrix,A++}n.point[p]=J,p++}else if(D.isHemisphereLight){let J=e.get(D);J.skyColor.copy(D.color).multiplyScalar(Z),J.groundColor.copy(D.groundColor).multiplyScalar(Z),n.hemi[S]=J,S++}}E>0&&(i.has("OES_texture_float_linear")===!0?(n.rectAreaLTC1=Le.LTC_FLOAT_1,n.rectAreaLTC2=Le.LTC_FLOAT_2):(n.rectAreaLTC1=Le.LTC_HALF_1,n.rectAreaLTC2=Le.LTC_HALF_2)),n.ambient[0]=u,n.ambient[1]=f,n.ambient[2]=h;let L=n.hash;(L.sunLength!==d||L.directionalLength!==m||L.pointLength!==p||L.spotLength!==v||L.rectAreaLength!==E||L.hemiLength!==S||L.numSunShadows!==g||L.numDirectionalShadows!==R||L.numPointShadows!==A||L.numSpotShadows!==x||L.numSpotMaps!==T||L.numLightProbes!==N)&&(n.sun.length=d,n.directional.length=m,n.spot.length=v,n.rectArea.length=E,n.point.length=p,n.hemi.length=S,n.sunShadow.length=g,n.sunShadowMap.length=g,n.sunShadowMatrix.length=b,n.sunShadowCascade.length=b,n.directionalShadow.length=R,n.directionalShadowMap.length=R,n.directionalShadowMatrix.length=R,n.pointShadow.length=A,n.pointShadowMap.length=A,n.pointShadowMatrix.length=A,n.spotShadow.length=x,n.spotShadowMap.length=x,n.spotLightMatrix.length=x+T-k,n.spotLightMap.length=T,n.numSpotLightShadowsWithMaps=k,n.numLightProbes=N,L.sunLength=d,L.directionalLength=m,L.pointLength=p,L.spotLength=v,L.rectAreaLength=E,L.hemiLength=S,L.numSunShadows=g,L.numDirectionalShadows=R,L.numPointShadows=A,L.numSpotShadows=x,L.numSpotMaps=T,L.numLightProbes=N,n.version=qy++)}function l(c,u){let f=0,h=0,d=0,g=0,b=0,m=0,p=u.matrixWorldInverse;for(let v=0,E=c.length;v<E;v++){let S=c[v];if(S.isSunLight){let R=n.sun[f];R.direction.setFromMatrixPosition(S.matrixWorld),R.direction.transformDirection(p),f++}else if(S.isDirectionalLight){let R=n.directional[h];R.direction.setFromMatrixPosition(S.matrixWorld),s.setFromMatrixPosition(S.target.matrixWorld),R.direction.sub(s),R.direction.transformDirection(p),h++}else if(S.isSpotLight){let R=n.spot[g];R.position.setFromMatrixPosition(S.matrixWorld),R.position.applyMatrix4(p),R.direction.setFromMatrixPosition(S.matrixWorld),s.setFromMatrixPosition(S.target.matrixWorld),R.direction.sub(s),R.direction.transformDirection(p),g++}else if(S.isRectAreaLight){let R=n.rectArea[b];R.position.setFromMatrixPosition(S.matrixWorld),R.position.applyMatrix4(p),a.identity(),r.copy(S.matrixWorld),r.premultiply(p),a.extractRotation(r),R.halfWidth.set(S.width*.5,0,0),R.halfHeight.set(0,S.height*.5,0),R.halfWidth.applyMatrix4(a),R.halfHeight.applyMatrix4(a),b++}else if(S.isPointLight){let R=n.point[d];R.position.setFromMatrixPosition(S.matrixWorld),R.position.applyMatrix4(p),d++}else if(S.isHemisphereLight){let R=n.hemi[m];R.direction.setFromMatrixPosition(S.matrixWorld),R.direction.transformDirection(p),m++}}}return{setup:o,setupView:l,state:n}}function Ap(i){let e=new $y(i),t=[],n=[],s=[];function r(f){u.camera=f,t.length=0,n.length=0,s.length=0}function a(f){f.isLightProbeGrid?s.push(f):t.push(f)}function o(f){n.push(f)}function l(){e.setup(t),s.sort((f,h)=>f.priority-h.priority||f.id-h.id)}function c(f){e.setupView(t,f)}let u={lightsArray:t,shadowsArray:n,lightProbeGridArray:s,camera:null,lights:e,transmissionRenderTarget:{},textureUnits:0};return{init:r,state:u,setupLights:l,setupLightsView:c,pushLight:a,pushShadow:o}}function Zy(i){let e=new WeakMap;function t(s,r=0){let a=e.get(s),o;return a===void 0?(o=new Ap(i),e.set(s,[o])):r>=a.length?(o=new Ap(i),a.push(o)):o=a[r],o}function n(){e=new WeakMap}return{get:t,dispose:n}}var Jy=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,Ky=`uniform sampler2D shadow_pass;
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
}`,Qy=[new Y(1,0,0),new Y(-1,0,0),new Y(0,1,0),new Y(0,-1,0),new Y(0,0,1),new Y(0,0,-1)],jy=[new Y(0,-1,0),new Y(0,-1,0),new Y(0,0,1),new Y(0,0,-1),new Y(0,-1,0),new Y(0,-1,0)],Ep=new dt,eo=new Y,vh=new Y;function eb(i,e,t){let n=new Qs,s=new ct,r=new ct,a=new Lt,o=new fl,l=new dl,c={},u=t.maxTextureSize,f={[Fs]:Vn,[Vn]:Fs,[Hi]:Hi},h=new Gi({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new ct},radius:{value:4}},vertexShader:Jy,fragmentShader:Ky}),d=h.clone();d.defines.HORIZONTAL_PASS=1;let g=new di;g.setAttribute("position",new kn(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let b=new pi(g,h),m=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=Wa;let p=this.type;this.render=function(A,x,T){if(m.enabled===!1||m.autoUpdate===!1&&m.needsUpdate===!1||A.length===0)return;this.type===bd&&($e("WebGLShadowMap: PCFSoftShadowMap has been removed. Using PCFShadowMap instead."),this.type=Wa);let k=i.getRenderTarget(),N=i.getActiveCubeFace(),L=i.getActiveMipmapLevel(),G=i.state;G.setBlending(er),G.buffers.depth.getReversed()===!0?G.buffers.color.setClear(0,0,0,0):G.buffers.color.setClear(1,1,1,1),G.buffers.depth.setTest(!0),G.setScissorTest(!1);let H=p!==this.type;H&&x.traverse(function(D){D.material&&(Array.isArray(D.material)?D.material.forEach(V=>V.needsUpdate=!0):D.material.needsUpdate=!0)});for(let D=0,V=A.length;D<V;D++){let Z=A[D],z=Z.shadow;if(z===void 0){$e("WebGLShadowMap:",Z,"has no shadow.");continue}if(z.autoUpdate===!1&&z.needsUpdate===!1)continue;s.copy(z.mapSize);let le=z.getFrameExtents();s.multiply(le),r.copy(z.mapSize),(s.x>u||s.y>u)&&(s.x>u&&(r.x=Math.floor(u/le.x),s.x=r.x*le.x,z.mapSize.x=r.x),s.y>u&&(r.y=Math.floor(u/le.y),s.y=r.y*le.y,z.mapSize.y=r.y));let J=i.state.buffers.depth.getReversed();if(z.camera._reversedDepth=J,z.map===null||H===!0){if(z.map!==null&&(z.map.depthTexture!==null&&(z.map.depthTexture.dispose(),z.map.depthTexture=null),z.map.dispose()),this.type===Yr){if(Z.isPointLight){$e("WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.");continue}z.map=new wn(s.x,s.y,{format:Xi,type:Ln,minFilter:An,magFilter:An,generateMipmaps:!1}),z.map.texture.name=Z.name+".shadowMap",z.map.depthTexture=new Ti(s.x,s.y,Nt),z.map.depthTexture.name=Z.name+".shadowMapDepth",z.map.depthTexture.format=us,z.map.depthTexture.compareFunction=null,z.map.depthTexture.minFilter=Mt,z.map.depthTexture.magFilter=Mt}else Z.isPointLight?(z.map=new no(s.x),z.map.depthTexture=new ka(s.x,Ai)):(z.map=new wn(s.x,s.y),z.map.depthTexture=new Ti(s.x,s.y,Ai)),z.map.depthTexture.name=Z.name+".shadowMap",z.map.depthTexture.format=us,this.type===Wa?(z.map.depthTexture.compareFunction=J?uh:ch,z.map.depthTexture.minFilter=An,z.map.depthTexture.magFilter=An):(z.map.depthTexture.compareFunction=null,z.map.depthTexture.minFilter=Mt,z.map.depthTexture.magFilter=Mt);z.camera.updateProjectionMatrix()}z.map.isWebGLCubeRenderTarget!==!0&&(z.map.width!==s.x||z.map.height!==s.y)&&z.map.setSize(s.x,s.y);let Q=z.map.isWebGLCubeRenderTarget?6:z.getViewportCount();Z.isPointLight!==!0&&z.updateMatrices(Z,T);let ie=(z.camera.layers.mask&4294967294)!==0?z.camera.layers:T.layers;for(let he=0;he<Q;he++){let ue=z.getCamera(he);if(Z.isPointLight){let j=z.camera,me=z.matrix,xe=Z.distance||j.far;xe!==j.far&&(j.far=xe,j.updateProjectionMatrix()),eo.setFromMatrixPosition(Z.matrixWorld),j.position.copy(eo),vh.copy(j.position),vh.add(Qy[he]),j.up.copy(jy[he]),j.lookAt(vh),j.updateMatrixWorld(),me.makeTranslation(-eo.x,-eo.y,-eo.z),Ep.multiplyMatrices(j.projectionMatrix,j.matrixWorldInverse),z._frustum.setFromProjectionMatrix(Ep,j.coordinateSystem,j.reversedDepth)}if(z.map.isWebGLCubeRenderTarget)i.setRenderTarget(z.map,he),i.clear();else{he===0&&(i.setRenderTarget(z.map),i.clear());let j=z.getViewport(he);a.set(r.x*j.x,r.y*j.y,r.x*j.z,r.y*j.w),G.viewport(a)}n=z.getFrustum(he),S(x,T,ue,Z,ie,this.type)}z.isPointLightShadow!==!0&&this.type===Yr&&v(z,T),z.needsUpdate=!1}p=this.type,m.needsUpdate=!1,i.setRenderTarget(k,N,L)};function v(A,x){let T=e.update(b);h.defines.VSM_SAMPLES!==A.blurSamples&&(h.defines.VSM_SAMPLES=A.blurSamples,d.defines.VSM_SAMPLES=A.blurSamples,h.needsUpdate=!0,d.needsUpdate=!0),A.mapPass===null?A.mapPass=new wn(s.x,s.y,{format:Xi,type:Ln}):(A.mapPass.width!==A.map.width||A.mapPass.height!==A.map.height)&&A.mapPass.setSize(A.map.width,A.map.height),h.uniforms.shadow_pass.value=A.map.depthTexture,h.uniforms.resolution.value.set(A.map.width,A.map.height),h.uniforms.radius.value=A.radius,i.setRenderTarget(A.mapPass),i.clear(),i.renderBufferDirect(x,null,T,h,b,null),d.uniforms.shadow_pass.value=A.mapPass.texture,d.uniforms.resolution.value.set(A.map.width,A.map.height),d.uniforms.radius.value=A.radius,i.setRenderTarget(A.map),i.clear(),i.renderBufferDirect(x,null,T,d,b,null)}function E(A,x,T,k){let N=null,L=T.isPointLight===!0?A.customDistanceMaterial:A.customDepthMaterial;if(L!==void 0)N=L;else if(N=T.isPointLight===!0?l:o,i.localClippingEnabled&&x.clipShadows===!0&&Array.isArray(x.clippingPlanes)&&x.clippingPlanes.length!==0||x.displacementMap&&x.displacementScale!==0||x.alphaMap&&x.alphaTest>0||x.map&&x.alphaTest>0||x.alphaToCoverage===!0){let G=N.uuid,H=x.uuid,D=c[G];D===void 0&&(D={},c[G]=D);let V=D[H];V===void 0&&(V=N.clone(),D[H]=V,x.addEventListener("dispose",R)),N=V}if(N.visible=x.visible,N.wireframe=x.wireframe,k===Yr?N.side=x.shadowSide!==null?x.shadowSide:x.side:N.side=x.shadowSide!==null?x.shadowSide:f[x.side],N.alphaMap=x.alphaMap,N.alphaTest=x.alphaToCoverage===!0?.5:x.alphaTest,N.map=x.map,N.clipShadows=x.clipShadows,N.clippingPlanes=x.clippingPlanes,N.clipIntersection=x.clipIntersection,N.displacementMap=x.displacementMap,N.displacementScale=x.displacementScale,N.displacementBias=x.displacementBias,N.wireframeLinewidth=x.wireframeLinewidth,N.linewidth=x.linewidth,T.isPointLight===!0&&N.isMeshDistanceMaterial===!0){let G=i.properties.get(N);G.light=T}return N}function S(A,x,T,k,N,L){if(A.visible===!1)return;if(A.layers.test(N)&&(A.isMesh||A.isLine||A.isPoints)&&(A.castShadow||A.receiveShadow&&L===Yr)&&(!A.frustumCulled||A.intersectsFrustum(n))){A.modelViewMatrix.multiplyMatrices(T.matrixWorldInverse,A.matrixWorld);let D=e.update(A),V=A.material;if(Array.isArray(V)){let Z=D.groups;for(let z=0,le=Z.length;z<le;z++){let J=Z[z],Q=V[J.materialIndex];if(Q&&Q.visible){let ie=E(A,Q,k,L);A.onBeforeShadow(i,A,x,T,D,ie,J),i.renderBufferDirect(T,null,D,ie,A,J),A.onAfterShadow(i,A,x,T,D,ie,J)}}}else if(V.visible){let Z=E(A,V,k,L);A.onBeforeShadow(i,A,x,T,D,Z,null),i.renderBufferDirect(T,null,D,Z,A,null),A.onAfterShadow(i,A,x,T,D,Z,null)}}let H=A.children;for(let D=0,V=H.length;D<V;D++)S(H[D],x,T,k,N,L)}function R(A){A.target.removeEventListener("dispose",R);for(let T in c){let k=c[T],N=A.target.uuid;N in k&&(k[N].dispose(),delete k[N])}}}function tb(i,e){function t(){let F=!1,se=new Lt,te=null,we=new Lt(0,0,0,0);return{setMask:function(ge){te!==ge&&!F&&(i.colorMask(ge,ge,ge,ge),te=ge)},setLocked:function(ge){F=ge},setClear:function(ge,be,Ge,Ze,oe){oe===!0&&(ge*=Ze,be*=Ze,Ge*=Ze),se.set(ge,be,Ge,Ze),we.equals(se)===!1&&(i.clearColor(ge,be,Ge,Ze),we.copy(se))},reset:function(){F=!1,te=null,we.set(-1,0,0,0)}}}function n(){let F=!1,se=!1,te=null,we=null,ge=null;return{setReversed:function(be){if(se!==be){let Ge=e.get("EXT_clip_control");be?Ge.clipControlEXT(Ge.LOWER_LEFT_EXT,Ge.ZERO_TO_ONE_EXT):Ge.clipControlEXT(Ge.LOWER_LEFT_EXT,Ge.NEGATIVE_ONE_TO_ONE_EXT),se=be;let Ze=ge;ge=null,this.setClear(Ze)}},getReversed:function(){return se},setTest:function(be){be?Se(i.DEPTH_TEST):He(i.DEPTH_TEST)},setMask:function(be){te!==be&&!F&&(i.depthMask(be),te=be)},setFunc:function(be){if(se&&(be=tp[be]),we!==be){switch(be){case Zo:i.depthFunc(i.NEVER);break;case Jo:i.depthFunc(i.ALWAYS);break;case Ko:i.depthFunc(i.LESS);break;case zr:i.depthFunc(i.LEQUAL);break;case Qo:i.depthFunc(i.EQUAL);break;case jo:i.depthFunc(i.GEQUAL);break;case el:i.depthFunc(i.GREATER);break;case tl:i.depthFunc(i.NOTEQUAL);break;default:i.depthFunc(i.LEQUAL)}we=be}},setLocked:function(be){F=be},setClear:function(be){ge!==be&&(ge=be,se&&(be=1-be),i.clearDepth(be))},reset:function(){F=!1,te=null,we=null,ge=null,se=!1}}}function s(){let F=!1,se=null,te=null,we=null,ge=null,be=null,Ge=null,Ze=null,oe=null;return{setTest:function(Oe){F||(Oe?Se(i.STENCIL_TEST):He(i.STENCIL_TEST))},setMask:function(Oe){se!==Oe&&!F&&(i.stencilMask(Oe),se=Oe)},setFunc:function(Oe,Je,Re){(te!==Oe||we!==Je||ge!==Re)&&(i.stencilFunc(Oe,Je,Re),te=Oe,we=Je,ge=Re)},setOp:function(Oe,Je,Re){(be!==Oe||Ge!==Je||Ze!==Re)&&(i.stencilOp(Oe,Je,Re),be=Oe,Ge=Je,Ze=Re)},setLocked:function(Oe){F=Oe},setClear:function(Oe){oe!==Oe&&(i.clearStencil(Oe),oe=Oe)},reset:function(){F=!1,se=null,te=null,we=null,ge=null,be=null,Ge=null,Ze=null,oe=null}}}let r=new t,a=new n,o=new s,l={},c=new WeakMap,u={},f={},h={},d=new WeakMap,g=[],b=null,m=!1,p=null,v=null,E=null,S=null,R=null,A=null,x=null,T=new vt(0,0,0),k=0,N=!1,L=null,G=null,H=null,D=null,V=null,Z=i.getParameter(i.MAX_COMBINED_TEXTURE_IMAGE_UNITS),z=!1,le=0,J=i.getParameter(i.VERSION);J.indexOf("WebGL")!==-1?(le=parseFloat(/^WebGL (\d)/.exec(J)[1]),z=le>=1):J.indexOf("OpenGL ES")!==-1&&(le=parseFloat(/^OpenGL ES (\d)/.exec(J)[1]),z=le>=2);let Q=null,ie={},he=i.getParameter(i.SCISSOR_BOX),ue=i.getParameter(i.VIEWPORT),j=new Lt().fromArray(he),me=new Lt().fromArray(ue);function xe(F,se,te,we){let ge=new Uint8Array(4),be=i.createTexture();i.bindTexture(F,be),i.texParameteri(F,i.TEXTURE_MIN_FILTER,i.NEAREST),i.texParameteri(F,i.TEXTURE_MAG_FILTER,i.NEAREST);for(let Ge=0;Ge<te;Ge++)F===i.TEXTURE_3D||F===i.TEXTURE_2D_ARRAY?i.texImage3D(se,0,i.RGBA,1,1,we,0,i.RGBA,i.UNSIGNED_BYTE,ge):i.texImage2D(se+Ge,0,i.RGBA,1,1,0,i.RGBA,i.UNSIGNED_BYTE,ge);return be}let Ee={};Ee[i.TEXTURE_2D]=xe(i.TEXTURE_2D,i.TEXTURE_2D,1),Ee[i.TEXTURE_CUBE_MAP]=xe(i.TEXTURE_CUBE_MAP,i.TEXTURE_CUBE_MAP_POSITIVE_X,6),Ee[i.TEXTURE_2D_ARRAY]=xe(i.TEXTURE_2D_ARRAY,i.TEXTURE_2D_ARRAY,1,1),Ee[i.TEXTURE_3D]=xe(i.TEXTURE_3D,i.TEXTURE_3D,1,1),r.setClear(0,0,0,1),a.setClear(1),o.setClear(0),Se(i.DEPTH_TEST),a.setFunc(zr),tn(!1),Pt(ku),Se(i.CULL_FACE),Wt(er);function Se(F){u[F]!==!0&&(i.enable(F),u[F]=!0)}function He(F){u[F]!==!1&&(i.disable(F),u[F]=!1)}function nt(F,se){return h[F]!==se?(i.bindFramebuffer(F,se),h[F]=se,F===i.DRAW_FRAMEBUFFER&&(h[i.FRAMEBUFFER]=se),F===i.FRAMEBUFFER&&(h[i.DRAW_FRAMEBUFFER]=se),!0):!1}function Ve(F,se){let te=g,we=!1;if(F){te=d.get(se),te===void 0&&(te=[],d.set(se,te));let ge=F.textures;if(te.length!==ge.length||te[0]!==i.COLOR_ATTACHMENT0){for(let be=0,Ge=ge.length;be<Ge;be++)te[be]=i.COLOR_ATTACHMENT0+be;te.length=ge.length,we=!0}}else te[0]!==i.BACK&&(te[0]=i.BACK,we=!0);we&&i.drawBuffers(te)}function lt(F){return b!==F?(i.useProgram(F),b=F,!0):!1}let rt={[tr]:i.FUNC_ADD,[Md]:i.FUNC_SUBTRACT,[wd]:i.FUNC_REVERSE_SUBTRACT};rt[Td]=i.MIN,rt[Ad]=i.MAX;let et={[Ed]:i.ZERO,[Rd]:i.ONE,[Cd]:i.SRC_COLOR,[Wu]:i.SRC_ALPHA,[Fd]:i.SRC_ALPHA_SATURATE,[Dd]:i.DST_COLOR,[Id]:i.DST_ALPHA,[Pd]:i.ONE_MINUS_SRC_COLOR,[Xu]:i.ONE_MINUS_SRC_ALPHA,[Nd]:i.ONE_MINUS_DST_COLOR,[Ld]:i.ONE_MINUS_DST_ALPHA,[Ud]:i.CONSTANT_COLOR,[Od]:i.ONE_MINUS_CONSTANT_COLOR,[Bd]:i.CONSTANT_ALPHA,[zd]:i.ONE_MINUS_CONSTANT_ALPHA};function Wt(F,se,te,we,ge,be,Ge,Ze,oe,Oe){if(F===er){m===!0&&(He(i.BLEND),m=!1);return}if(m===!1&&(Se(i.BLEND),m=!0),F!==Sd){if(F!==p||Oe!==N){if((v!==tr||R!==tr)&&(i.blendEquation(i.FUNC_ADD),v=tr,R=tr),Oe)switch(F){case $r:i.blendFuncSeparate(i.ONE,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case Vu:i.blendFunc(i.ONE,i.ONE);break;case Gu:i.blendFuncSeparate(i.ZERO,i.ONE_MINUS_SRC_COLOR,i.ZERO,i.ONE);break;case Hu:i.blendFuncSeparate(i.DST_COLOR,i.ONE_MINUS_SRC_ALPHA,i.ZERO,i.ONE);break;default:Qe("WebGLState: Invalid blending: ",F);break}else switch(F){case $r:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case Vu:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE,i.ONE,i.ONE);break;case Gu:Qe("WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case Hu:Qe("WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:Qe("WebGLState: Invalid blending: ",F);break}E=null,S=null,A=null,x=null,T.set(0,0,0),k=0,p=F,N=Oe}return}ge=ge||se,be=be||te,Ge=Ge||we,(se!==v||ge!==R)&&(i.blendEquationSeparate(rt[se],rt[ge]),v=se,R=ge),(te!==E||we!==S||be!==A||Ge!==x)&&(i.blendFuncSeparate(et[te],et[we],et[be],et[Ge]),E=te,S=we,A=be,x=Ge),(Ze.equals(T)===!1||oe!==k)&&(i.blendColor(Ze.r,Ze.g,Ze.b,oe),T.copy(Ze),k=oe),p=F,N=!1}function Ot(F,se){F.side===Hi?He(i.CULL_FACE):Se(i.CULL_FACE);let te=F.side===Vn;se&&(te=!te),tn(te),F.blending===$r&&F.transparent===!1?Wt(er):Wt(F.blending,F.blendEquation,F.blendSrc,F.blendDst,F.blendEquationAlpha,F.blendSrcAlpha,F.blendDstAlpha,F.blendColor,F.blendAlpha,F.premultipliedAlpha),a.setFunc(F.depthFunc),a.setTest(F.depthTest),a.setMask(F.depthWrite),r.setMask(F.colorWrite);let we=F.stencilWrite;o.setTest(we),we&&(o.setMask(F.stencilWriteMask),o.setFunc(F.stencilFunc,F.stencilRef,F.stencilFuncMask),o.setOp(F.stencilFail,F.stencilZFail,F.stencilZPass)),xt(F.polygonOffset,F.polygonOffsetFactor,F.polygonOffsetUnits),F.alphaToCoverage===!0?Se(i.SAMPLE_ALPHA_TO_COVERAGE):He(i.SAMPLE_ALPHA_TO_COVERAGE)}function tn(F){L!==F&&(F?i.frontFace(i.CW):i.frontFace(i.CCW),L=F)}function Pt(F){F!==vd?(Se(i.CULL_FACE),F!==G&&(F===ku?i.cullFace(i.BACK):F===yd?i.cullFace(i.FRONT):i.cullFace(i.FRONT_AND_BACK))):He(i.CULL_FACE),G=F}function xn(F){F!==H&&(z&&i.lineWidth(F),H=F)}function xt(F,se,te){F?(Se(i.POLYGON_OFFSET_FILL),(D!==se||V!==te)&&(D=se,V=te,a.getReversed()&&(se=-se,te=-te),i.polygonOffset(se,te))):He(i.POLYGON_OFFSET_FILL)}function fn(F){F?Se(i.SCISSOR_TEST):He(i.SCISSOR_TEST)}function $t(F){F===void 0&&(F=i.TEXTURE0+Z-1),Q!==F&&(i.activeTexture(F),Q=F)}function nn(F,se,te){te===void 0&&(Q===null?te=i.TEXTURE0+Z-1:te=Q);let we=ie[te];we===void 0&&(we={type:void 0,texture:void 0},ie[te]=we),(we.type!==F||we.texture!==se)&&(Q!==te&&(i.activeTexture(te),Q=te),i.bindTexture(F,se||Ee[F]),we.type=F,we.texture=se)}function U(){let F=ie[Q];F!==void 0&&F.type!==void 0&&(i.bindTexture(F.type,null),F.type=void 0,F.texture=void 0)}function Ce(){try{i.compressedTexImage2D(...arguments)}catch(F){Qe("WebGLState:",F)}}function qe(){try{i.compressedTexImage3D(...arguments)}catch(F){Qe("WebGLState:",F)}}function it(){try{i.texSubImage2D(...arguments)}catch(F){Qe("WebGLState:",F)}}function Me(){try{i.texSubImage3D(...arguments)}catch(F){Qe("WebGLState:",F)}}function Dt(){try{i.compressedTexSubImage2D(...arguments)}catch(F){Qe("WebGLState:",F)}}function ke(){try{i.compressedTexSubImage3D(...arguments)}catch(F){Qe("WebGLState:",F)}}function Xe(){try{i.texStorage2D(...arguments)}catch(F){Qe("WebGLState:",F)}}function C(){try{i.texStorage3D(...arguments)}catch(F){Qe("WebGLState:",F)}}function y(){try{i.texImage2D(...arguments)}catch(F){Qe("WebGLState:",F)}}function W(){try{i.texImage3D(...arguments)}catch(F){Qe("WebGLState:",F)}}function ce(F){return f[F]!==void 0?f[F]:i.getParameter(F)}function re(F,se){f[F]!==se&&(i.pixelStorei(F,se),f[F]=se)}function _e(F){j.equals(F)===!1&&(i.scissor(F.x,F.y,F.z,F.w),j.copy(F))}function ve(F){me.equals(F)===!1&&(i.viewport(F.x,F.y,F.z,F.w),me.copy(F))}function ee(F,se){let te=c.get(se);te===void 0&&(te=new WeakMap,c.set(se,te));let we=te.get(F);we===void 0&&(we=i.getUniformBlockIndex(se,F.name),i.uniformBlockBinding(se,we,we),te.set(F,we))}function ne(F,se,te){let ge=c.get(se).get(F);l[ge]!==te&&(i.bindBufferBase(i.UNIFORM_BUFFER,ge,te),l[ge]=te)}function de(){i.disable(i.BLEND),i.disable(i.CULL_FACE),i.disable(i.DEPTH_TEST),i.disable(i.POLYGON_OFFSET_FILL),i.disable(i.SCISSOR_TEST),i.disable(i.STENCIL_TEST),i.disable(i.SAMPLE_ALPHA_TO_COVERAGE),i.blendEquation(i.FUNC_ADD),i.blendFunc(i.ONE,i.ZERO),i.blendFuncSeparate(i.ONE,i.ZERO,i.ONE,i.ZERO),i.blendColor(0,0,0,0),i.colorMask(!0,!0,!0,!0),i.clearColor(0,0,0,0),i.depthMask(!0),i.depthFunc(i.LESS),a.setReversed(!1),i.clearDepth(1),i.stencilMask(4294967295),i.stencilFunc(i.ALWAYS,0,4294967295),i.stencilOp(i.KEEP,i.KEEP,i.KEEP),i.clearStencil(0),i.cullFace(i.BACK),i.frontFace(i.CCW),i.polygonOffset(0,0),i.activeTexture(i.TEXTURE0),i.bindFramebuffer(i.FRAMEBUFFER,null),i.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),i.bindFramebuffer(i.READ_FRAMEBUFFER,null),i.useProgram(null),i.lineWidth(1),i.scissor(0,0,i.canvas.width,i.canvas.height),i.viewport(0,0,i.canvas.width,i.canvas.height),i.pixelStorei(i.PACK_ALIGNMENT,4),i.pixelStorei(i.UNPACK_ALIGNMENT,4),i.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,!1),i.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),i.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,i.BROWSER_DEFAULT_WEBGL),i.pixelStorei(i.PACK_ROW_LENGTH,0),i.pixelStorei(i.PACK_SKIP_PIXELS,0),i.pixelStorei(i.PACK_SKIP_ROWS,0),i.pixelStorei(i.UNPACK_ROW_LENGTH,0),i.pixelStorei(i.UNPACK_IMAGE_HEIGHT,0),i.pixelStorei(i.UNPACK_SKIP_PIXELS,0),i.pixelStorei(i.UNPACK_SKIP_ROWS,0),i.pixelStorei(i.UNPACK_SKIP_IMAGES,0),u={},f={},Q=null,ie={},h={},l={},d=new WeakMap,g=[],b=null,m=!1,p=null,v=null,E=null,S=null,R=null,A=null,x=null,T=new vt(0,0,0),k=0,N=!1,L=null,G=null,H=null,D=null,V=null,j.set(0,0,i.canvas.width,i.canvas.height),me.set(0,0,i.canvas.width,i.canvas.height),r.reset(),a.reset(),o.reset()}return{buffers:{color:r,depth:a,stencil:o},enable:Se,disable:He,bindFramebuffer:nt,drawBuffers:Ve,useProgram:lt,setBlending:Wt,setMaterial:Ot,setFlipSided:tn,setCullFace:Pt,setLineWidth:xn,setPolygonOffset:xt,setScissorTest:fn,activeTexture:$t,bindTexture:nn,unbindTexture:U,compressedTexImage2D:Ce,compressedTexImage3D:qe,texImage2D:y,texImage3D:W,pixelStorei:re,getParameter:ce,updateUBOMapping:ee,uniformBlockBinding:ne,texStorage2D:Xe,texStorage3D:C,texSubImage2D:it,texSubImage3D:Me,compressedTexSubImage2D:Dt,compressedTexSubImage3D:ke,scissor:_e,viewport:ve,reset:de}}function nb(i,e,t,n,s,r,a){let o=e.has("WEBGL_multisampled_render_to_texture")?e.get("WEBGL_multisampled_render_to_texture"):null,l=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),c=new ct,u=new WeakMap,f=new Set,h,d=new WeakMap,g=new Set,b=new FinalizationRegistry(C=>g.delete(C)),m=!1;try{m=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function p(C,y){return m?new OffscreenCanvas(C,y):Na("canvas")}function v(C,y,W){let ce=1,re=Xe(C);if((re.width>W||re.height>W)&&(ce=W/Math.max(re.width,re.height)),ce<1)if(typeof HTMLImageElement<"u"&&C instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&C instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&C instanceof ImageBitmap||typeof VideoFrame<"u"&&C instanceof VideoFrame){let _e=Math.floor(ce*re.width),ve=Math.floor(ce*re.height);h===void 0&&(h=p(_e,ve));let ee=y?p(_e,ve):h;return ee.width=_e,ee.height=ve,ee.getContext("2d").drawImage(C,0,0,_e,ve),$e("WebGLRenderer: Texture has been resized from ("+re.width+"x"+re.height+") to ("+_e+"x"+ve+")."),ee}else return"data"in C&&$e("WebGLRenderer: Image in DataTexture is too big ("+re.width+"x"+re.height+")."),C;return C}function E(C){return C.generateMipmaps}function S(C){i.generateMipmap(C)}function R(C){return C.isWebGLCubeRenderTarget?i.TEXTURE_CUBE_MAP:C.isWebGL3DRenderTarget?i.TEXTURE_3D:C.isWebGLArrayRenderTarget||C.isCompressedArrayTexture?i.TEXTURE_2D_ARRAY:i.TEXTURE_2D}function A(C,y,W,ce,re,_e=!1){if(C!==null){if(i[C]!==void 0)return i[C];$e("WebGLRenderer: Attempt to use non-existing WebGL internal format '"+C+"'")}let ve;ce&&(ve=e.get("EXT_texture_norm16"),ve||$e("WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension"));let ee=y;if(y===i.RED&&(W===i.FLOAT&&(ee=i.R32F),W===i.HALF_FLOAT&&(ee=i.R16F),W===i.UNSIGNED_BYTE&&(ee=i.R8),W===i.UNSIGNED_SHORT&&ve&&(ee=ve.R16_EXT),W===i.SHORT&&ve&&(ee=ve.R16_SNORM_EXT)),y===i.RED_INTEGER&&(W===i.UNSIGNED_BYTE&&(ee=i.R8UI),W===i.UNSIGNED_SHORT&&(ee=i.R16UI),W===i.UNSIGNED_INT&&(ee=i.R32UI),W===i.BYTE&&(ee=i.R8I),W===i.SHORT&&(ee=i.R16I),W===i.INT&&(ee=i.R32I)),y===i.RG&&(W===i.FLOAT&&(ee=i.RG32F),W===i.HALF_FLOAT&&(ee=i.RG16F),W===i.UNSIGNED_BYTE&&(ee=i.RG8),W===i.UNSIGNED_SHORT&&ve&&(ee=ve.RG16_EXT),W===i.SHORT&&ve&&(ee=ve.RG16_SNORM_EXT)),y===i.RG_INTEGER&&(W===i.UNSIGNED_BYTE&&(ee=i.RG8UI),W===i.UNSIGNED_SHORT&&(ee=i.RG16UI),W===i.UNSIGNED_INT&&(ee=i.RG32UI),W===i.BYTE&&(ee=i.RG8I),W===i.SHORT&&(ee=i.RG16I),W===i.INT&&(ee=i.RG32I)),y===i.RGB_INTEGER&&(W===i.UNSIGNED_BYTE&&(ee=i.RGB8UI),W===i.UNSIGNED_SHORT&&(ee=i.RGB16UI),W===i.UNSIGNED_INT&&(ee=i.RGB32UI),W===i.BYTE&&(ee=i.RGB8I),W===i.SHORT&&(ee=i.RGB16I),W===i.INT&&(ee=i.RGB32I)),y===i.RGBA_INTEGER&&(W===i.UNSIGNED_BYTE&&(ee=i.RGBA8UI),W===i.UNSIGNED_SHORT&&(ee=i.RGBA16UI),W===i.UNSIGNED_INT&&(ee=i.RGBA32UI),W===i.BYTE&&(ee=i.RGBA8I),W===i.SHORT&&(ee=i.RGBA16I),W===i.INT&&(ee=i.RGBA32I)),y===i.RGB&&(W===i.UNSIGNED_SHORT&&ve&&(ee=ve.RGB16_EXT),W===i.SHORT&&ve&&(ee=ve.RGB16_SNORM_EXT),W===i.UNSIGNED_INT_5_9_9_9_REV&&(ee=i.RGB9_E5),W===i.UNSIGNED_INT_10F_11F_11F_REV&&(ee=i.R11F_G11F_B10F)),y===i.RGBA){let ne=_e?La:mt.getTransfer(re);W===i.FLOAT&&(ee=i.RGBA32F),W===i.HALF_FLOAT&&(ee=i.RGBA16F),W===i.UNSIGNED_BYTE&&(ee=ne===Tt?i.SRGB8_ALPHA8:i.RGBA8),W===i.UNSIGNED_SHORT&&ve&&(ee=ve.RGBA16_EXT),W===i.SHORT&&ve&&(ee=ve.RGBA16_SNORM_EXT),W===i.UNSIGNED_SHORT_4_4_4_4&&(ee=i.RGBA4),W===i.UNSIGNED_SHORT_5_5_5_1&&(ee=i.RGB5_A1)}return(ee===i.R16F||ee===i.R32F||ee===i.RG16F||ee===i.RG32F||ee===i.RGBA16F||ee===i.RGBA32F)&&e.get("EXT_color_buffer_float"),ee}function x(C,y){let W;return C?y===null||y===Ai||y===ir?W=i.DEPTH24_STENCIL8:y===Nt?W=i.DEPTH32F_STENCIL8:y===Jr&&(W=i.DEPTH24_STENCIL8,$e("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):y===null||y===Ai||y===ir?W=i.DEPTH_COMPONENT24:y===Nt?W=i.DEPTH_COMPONENT32F:y===Jr&&(W=i.DEPTH_COMPONENT16),W}function T(C,y){return E(C)===!0||C.isFramebufferTexture&&C.minFilter!==Mt&&C.minFilter!==An?Math.log2(Math.max(y.width,y.height))+1:C.mipmaps.length>0?C.mipmaps.length:C.isCompressedTexture&&Array.isArray(C.image)?y.mipmaps.length:1}function k(C){let y=new WeakRef(C);n.get(C).__ref=y,g.add(y),b.register(C,y,y)}function N(C){let y=n.get(C).__ref;y!==void 0&&(g.delete(y),b.unregister(y))}function L(C){H(C.target)}function G(C){D(C.target)}function H(C){C.removeEventListener("dispose",L),N(C),Z(C),C.isVideoTexture&&u.delete(C),C.isHTMLTexture&&f.delete(C)}function D(C){C.removeEventListener("dispose",G),N(C),le(C)}function V(){for(let C of g){let y=C.deref();y!==void 0&&(y.isRenderTarget===!0?D(y):H(y))}g.clear(),f.clear()}function Z(C){let y=n.get(C);if(y.__webglInit===void 0)return;let W=C.source,ce=d.get(W);if(ce){let re=ce[y.__cacheKey];re.usedTimes--,re.usedTimes===0&&z(C),Object.keys(ce).length===0&&d.delete(W)}n.remove(C)}function z(C){let y=n.get(C);i.deleteTexture(y.__webglTexture);let W=C.source,ce=d.get(W);delete ce[y.__cacheKey],a.memory.textures--}function le(C){let y=n.get(C);y.__depthDisposeCallback&&y.__depthDisposeCallback();let W=C.depthTexture;if(W&&W.renderTarget===C&&H(W),C.isWebGLCubeRenderTarget)for(let re=0;re<6;re++){if(Array.isArray(y.__webglFramebuffer[re]))for(let _e=0;_e<y.__webglFramebuffer[re].length;_e++)i.deleteFramebuffer(y.__webglFramebuffer[re][_e]);else i.deleteFramebuffer(y.__webglFramebuffer[re]);y.__webglDepthbuffer&&i.deleteRenderbuffer(y.__webglDepthbuffer[re])}else{if(Array.isArray(y.__webglFramebuffer))for(let re=0;re<y.__webglFramebuffer.length;re++)i.deleteFramebuffer(y.__webglFramebuffer[re]);else i.deleteFramebuffer(y.__webglFramebuffer);if(y.__webglDepthbuffer&&i.deleteRenderbuffer(y.__webglDepthbuffer),y.__webglMultisampledFramebuffer&&i.deleteFramebuffer(y.__webglMultisampledFramebuffer),y.__webglColorRenderbuffer)for(let re=0;re<y.__webglColorRenderbuffer.length;re++)y.__webglColorRenderbuffer[re]&&i.deleteRenderbuffer(y.__webglColorRenderbuffer[re]);y.__webglDepthRenderbuffer&&i.deleteRenderbuffer(y.__webglDepthRenderbuffer)}let ce=C.textures;for(let re=0,_e=ce.length;re<_e;re++){let ve=n.get(ce[re]);ve.__webglTexture&&(i.deleteTexture(ve.__webglTexture),a.memory.textures--),n.remove(ce[re])}n.remove(C)}let J=0;function Q(){J=0}function ie(){return J}function he(C){J=C}function ue(){let C=J;return C>=s.maxTextures&&$e("WebGLTextures: Trying to use "+(C+1)+" texture units while this GPU supports only "+s.maxTextures),J+=1,C}function j(C){let y=[];return y.push(C.wrapS),y.push(C.wrapT),y.push(C.wrapR||0),y.push(C.magFilter),y.push(C.minFilter),y.push(C.anisotropy),y.push(C.internalFormat),y.push(C.format),y.push(C.type),y.push(C.generateMipmaps),y.push(C.mipmapsAutoUpdate),y.push(C.premultiplyAlpha),y.push(C.flipY),y.push(C.unpackAlignment),y.push(C.colorSpace),y.join()}function me(C,y){let W=n.get(C);if(C.isVideoTexture&&Dt(C),C.isRenderTargetTexture===!1&&C.isExternalTexture!==!0&&C.version>0&&W.__version!==C.version){let ce=C.image;if(ce===null)$e("WebGLRenderer: Texture marked for update but no image data found.");else if(ce.complete===!1)$e("WebGLRenderer: Texture marked for update but image is incomplete");else{Ot(W,C,y);return}}else C.isExternalTexture&&(W.__webglTexture=C.sourceTexture?C.sourceTexture:null);t.bindTexture(i.TEXTURE_2D,W.__webglTexture,i.TEXTURE0+y)}function xe(C,y){let W=n.get(C);if(C.isRenderTargetTexture===!1&&C.version>0&&W.__version!==C.version){Ot(W,C,y);return}else C.isExternalTexture&&(W.__webglTexture=C.sourceTexture?C.sourceTexture:null);t.bindTexture(i.TEXTURE_2D_ARRAY,W.__webglTexture,i.TEXTURE0+y)}function Ee(C,y){let W=n.get(C);if(C.isRenderTargetTexture===!1&&C.version>0&&W.__version!==C.version){Ot(W,C,y);return}t.bindTexture(i.TEXTURE_3D,W.__webglTexture,i.TEXTURE0+y)}function Se(C,y){let W=n.get(C);if(C.version>0&&W.__version!==C.version){tn(W,C,y);return}t.bindTexture(i.TEXTURE_CUBE_MAP,W.__webglTexture,i.TEXTURE0+y)}let He={[nl]:i.REPEAT,[ci]:i.CLAMP_TO_EDGE,[il]:i.MIRRORED_REPEAT},nt={[Mt]:i.NEAREST,[Gd]:i.NEAREST_MIPMAP_NEAREST,[Xa]:i.NEAREST_MIPMAP_LINEAR,[An]:i.LINEAR,[Rl]:i.LINEAR_MIPMAP_NEAREST,[hs]:i.LINEAR_MIPMAP_LINEAR},Ve={[qd]:i.NEVER,[hh]:i.ALWAYS,[Yd]:i.LESS,[ch]:i.LEQUAL,[$d]:i.EQUAL,[uh]:i.GEQUAL,[Zd]:i.GREATER,[Jd]:i.NOTEQUAL};function lt(C,y){if(y.type===Nt&&e.has("OES_texture_float_linear")===!1&&(y.magFilter===An||y.magFilter===Rl||y.magFilter===Xa||y.magFilter===hs||y.minFilter===An||y.minFilter===Rl||y.minFilter===Xa||y.minFilter===hs)&&$e("WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),i.texParameteri(C,i.TEXTURE_WRAP_S,He[y.wrapS]),i.texParameteri(C,i.TEXTURE_WRAP_T,He[y.wrapT]),(C===i.TEXTURE_3D||C===i.TEXTURE_2D_ARRAY)&&i.texParameteri(C,i.TEXTURE_WRAP_R,He[y.wrapR]),i.texParameteri(C,i.TEXTURE_MAG_FILTER,nt[y.magFilter]),i.texParameteri(C,i.TEXTURE_MIN_FILTER,nt[y.minFilter]),y.compareFunction&&(i.texParameteri(C,i.TEXTURE_COMPARE_MODE,i.COMPARE_REF_TO_TEXTURE),i.texParameteri(C,i.TEXTURE_COMPARE_FUNC,Ve[y.compareFunction])),e.has("EXT_texture_filter_anisotropic")===!0){if(y.magFilter===Mt||y.minFilter!==Xa&&y.minFilter!==hs||y.type===Nt&&e.has("OES_texture_float_linear")===!1)return;if(y.anisotropy>1||n.get(y).__currentAnisotropy){let W=e.get("EXT_texture_filter_anisotropic");i.texParameterf(C,W.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(y.anisotropy,s.getMaxAnisotropy())),n.get(y).__currentAnisotropy=y.anisotropy}}}function rt(C,y){let W=!1;C.__webglInit===void 0&&(C.__webglInit=!0,y.addEventListener("dispose",L),k(y));let ce=y.source,re=d.get(ce);re===void 0&&(re={},d.set(ce,re));let _e=j(y);if(_e!==C.__cacheKey){re[_e]===void 0&&(re[_e]={texture:i.createTexture(),usedTimes:0},a.memory.textures++,W=!0),re[_e].usedTimes++;let ve=re[C.__cacheKey];ve!==void 0&&(re[C.__cacheKey].usedTimes--,ve.usedTimes===0&&z(y)),C.__cacheKey=_e,C.__webglTexture=re[_e].texture}return W}function et(C,y,W){return Math.floor(Math.floor(C/W)/y)}function Wt(C,y,W,ce){let _e=C.updateRanges;if(_e.length===0)t.texSubImage2D(i.TEXTURE_2D,0,0,0,y.width,y.height,W,ce,y.data);else{_e.sort((F,se)=>F.start-se.start);let ve=0;for(let F=1;F<_e.length;F++){let se=_e[ve],te=_e[F],we=se.start+se.count,ge=et(te.start,y.width,4),be=et(se.start,y.width,4);te.start<=we+1&&ge===be&&et(te.start+te.count-1,y.width,4)===ge?se.count=Math.max(se.count,te.start+te.count-se.start):(++ve,_e[ve]=te)}_e.length=ve+1;let ee=t.getParameter(i.UNPACK_ROW_LENGTH),ne=t.getParameter(i.UNPACK_SKIP_PIXELS),de=t.getParameter(i.UNPACK_SKIP_ROWS);t.pixelStorei(i.UNPACK_ROW_LENGTH,y.width);for(let F=0,se=_e.length;F<se;F++){let te=_e[F],we=Math.floor(te.start/4),ge=Math.ceil(te.count/4),be=we%y.width,Ge=Math.floor(we/y.width),Ze=ge,oe=1;t.pixelStorei(i.UNPACK_SKIP_PIXELS,be),t.pixelStorei(i.UNPACK_SKIP_ROWS,Ge),t.texSubImage2D(i.TEXTURE_2D,0,be,Ge,Ze,oe,W,ce,y.data)}C.clearUpdateRanges(),t.pixelStorei(i.UNPACK_ROW_LENGTH,ee),t.pixelStorei(i.UNPACK_SKIP_PIXELS,ne),t.pixelStorei(i.UNPACK_SKIP_ROWS,de)}}function Ot(C,y,W){let ce=i.TEXTURE_2D;(y.isDataArrayTexture||y.isCompressedArrayTexture)&&(ce=i.TEXTURE_2D_ARRAY),y.isData3DTexture&&(ce=i.TEXTURE_3D);let re=rt(C,y),_e=y.source;t.bindTexture(ce,C.__webglTexture,i.TEXTURE0+W);let ve=n.get(_e);if(_e.version!==ve.__version||re===!0){if(t.activeTexture(i.TEXTURE0+W),(typeof ImageBitmap<"u"&&y.image instanceof ImageBitmap)===!1){let oe=mt.getPrimaries(mt.workingColorSpace),Oe=y.colorSpace===ds?null:mt.getPrimaries(y.colorSpace),Je=y.colorSpace===ds||oe===Oe?i.NONE:i.BROWSER_DEFAULT_WEBGL;t.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,y.flipY),t.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,y.premultiplyAlpha),t.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,Je)}t.pixelStorei(i.UNPACK_ALIGNMENT,y.unpackAlignment);let ne=v(y.image,!1,s.maxTextureSize);ne=ke(y,ne);let de=r.convert(y.format,y.colorSpace),F=r.convert(y.type),se=A(y.internalFormat,de,F,y.normalized,y.colorSpace,y.isVideoTexture);lt(ce,y);let te,we=y.mipmaps,ge=y.isVideoTexture!==!0,be=ve.__version===void 0||re===!0,Ge=_e.dataReady,Ze=T(y,ne);if(y.isDepthTexture)se=x(y.format===fs,y.type),be&&(ge?t.texStorage2D(i.TEXTURE_2D,1,se,ne.width,ne.height):t.texImage2D(i.TEXTURE_2D,0,se,ne.width,ne.height,0,de,F,null));else if(y.isDataTexture)if(we.length>0){ge&&be&&t.texStorage2D(i.TEXTURE_2D,Ze,se,we[0].width,we[0].height);for(let oe=0,Oe=we.length;oe<Oe;oe++)te=we[oe],ge?Ge&&t.texSubImage2D(i.TEXTURE_2D,oe,0,0,te.width,te.height,de,F,te.data):t.texImage2D(i.TEXTURE_2D,oe,se,te.width,te.height,0,de,F,te.data);y.generateMipmaps=!1}else ge?(be&&t.texStorage2D(i.TEXTURE_2D,Ze,se,ne.width,ne.height),Ge&&Wt(y,ne,de,F)):t.texImage2D(i.TEXTURE_2D,0,se,ne.width,ne.height,0,de,F,ne.data);else if(y.isCompressedTexture)if(y.isCompressedArrayTexture){ge&&be&&t.texStorage3D(i.TEXTURE_2D_ARRAY,Ze,se,we[0].width,we[0].height,ne.depth);for(let oe=0,Oe=we.length;oe<Oe;oe++)if(te=we[oe],y.format!==cn)if(de!==null)if(ge){if(Ge)if(y.layerUpdates.size>0){let Je=_h(te.width,te.height,y.format,y.type);for(let Re of y.layerUpdates){let st=te.data.subarray(Re*Je/te.data.BYTES_PER_ELEMENT,(Re+1)*Je/te.data.BYTES_PER_ELEMENT);t.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,oe,0,0,Re,te.width,te.height,1,de,st)}}else t.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,oe,0,0,0,te.width,te.height,ne.depth,de,te.data)}else t.compressedTexImage3D(i.TEXTURE_2D_ARRAY,oe,se,te.width,te.height,ne.depth,0,te.data,0,0);else $e("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else ge?Ge&&t.texSubImage3D(i.TEXTURE_2D_ARRAY,oe,0,0,0,te.width,te.height,ne.depth,de,F,te.data):t.texImage3D(i.TEXTURE_2D_ARRAY,oe,se,te.width,te.height,ne.depth,0,de,F,te.data);y.layerUpdates.size>0&&y.clearLayerUpdates()}else{ge&&be&&t.texStorage2D(i.TEXTURE_2D,Ze,se,we[0].width,we[0].height);for(let oe=0,Oe=we.length;oe<Oe;oe++)te=we[oe],y.format!==cn?de!==null?ge?Ge&&t.compressedTexSubImage2D(i.TEXTURE_2D,oe,0,0,te.width,te.height,de,te.data):t.compressedTexImage2D(i.TEXTURE_2D,oe,se,te.width,te.height,0,te.data):$e("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):ge?Ge&&t.texSubImage2D(i.TEXTURE_2D,oe,0,0,te.width,te.height,de,F,te.data):t.texImage2D(i.TEXTURE_2D,oe,se,te.width,te.height,0,de,F,te.data)}else if(y.isDataArrayTexture)if(ge){if(be&&t.texStorage3D(i.TEXTURE_2D_ARRAY,Ze,se,ne.width,ne.height,ne.depth),Ge)if(y.layerUpdates.size>0){let oe=_h(ne.width,ne.height,y.format,y.type);for(let Oe of y.layerUpdates){let Je=ne.data.subarray(Oe*oe/ne.data.BYTES_PER_ELEMENT,(Oe+1)*oe/ne.data.BYTES_PER_ELEMENT);t.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,Oe,ne.width,ne.height,1,de,F,Je)}y.clearLayerUpdates()}else t.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,0,ne.width,ne.height,ne.depth,de,F,ne.data)}else t.texImage3D(i.TEXTURE_2D_ARRAY,0,se,ne.width,ne.height,ne.depth,0,de,F,ne.data);else if(y.isData3DTexture)ge?(be&&t.texStorage3D(i.TEXTURE_3D,Ze,se,ne.width,ne.height,ne.depth),Ge&&t.texSubImage3D(i.TEXTURE_3D,0,0,0,0,ne.width,ne.height,ne.depth,de,F,ne.data)):t.texImage3D(i.TEXTURE_3D,0,se,ne.width,ne.height,ne.depth,0,de,F,ne.data);else if(y.isFramebufferTexture){if(be)if(ge)t.texStorage2D(i.TEXTURE_2D,Ze,se,ne.width,ne.height);else{let oe=ne.width,Oe=ne.height;for(let Je=0;Je<Ze;Je++)t.texImage2D(i.TEXTURE_2D,Je,se,oe,Oe,0,de,F,null),oe>>=1,Oe>>=1}}else if(y.isHTMLTexture){if("texElementImage2D"in i){let oe=i.canvas;if(oe.hasAttribute("layoutsubtree")||oe.setAttribute("layoutsubtree","true"),ne.parentNode!==oe){oe.appendChild(ne),f.add(y),oe.onpaint=Oe=>{let Je=Oe.changedElements;for(let Re of f)Je.includes(Re.image)&&(Re.needsUpdate=!0)},oe.requestPaint();return}if(i.texElementImage2D.length===3)i.texElementImage2D(i.TEXTURE_2D,i.RGBA8,ne);else{let Je=i.RGBA,Re=i.RGBA,st=i.UNSIGNED_BYTE;i.texElementImage2D(i.TEXTURE_2D,0,Je,Re,st,ne)}i.texParameteri(i.TEXTURE_2D,i.TEXTURE_MIN_FILTER,i.LINEAR),i.texParameteri(i.TEXTURE_2D,i.TEXTURE_WRAP_S,i.CLAMP_TO_EDGE),i.texParameteri(i.TEXTURE_2D,i.TEXTURE_WRAP_T,i.CLAMP_TO_EDGE)}}else if(we.length>0){if(ge&&be){let oe=Xe(we[0]);t.texStorage2D(i.TEXTURE_2D,Ze,se,oe.width,oe.height)}for(let oe=0,Oe=we.length;oe<Oe;oe++)te=we[oe],ge?Ge&&t.texSubImage2D(i.TEXTURE_2D,oe,0,0,de,F,te):t.texImage2D(i.TEXTURE_2D,oe,se,de,F,te);y.generateMipmaps=!1}else if(ge){if(be){let oe=Xe(ne);t.texStorage2D(i.TEXTURE_2D,Ze,se,oe.width,oe.height)}Ge&&t.texSubImage2D(i.TEXTURE_2D,0,0,0,de,F,ne)}else t.texImage2D(i.TEXTURE_2D,0,se,de,F,ne);E(y)&&y.mipmapsAutoUpdate===!0&&S(ce),ve.__version=_e.version,y.onUpdate&&y.onUpdate(y)}C.__version=y.version}function tn(C,y,W){if(y.image.length!==6)return;let ce=rt(C,y),re=y.source;t.bindTexture(i.TEXTURE_CUBE_MAP,C.__webglTexture,i.TEXTURE0+W);let _e=n.get(re);if(re.version!==_e.__version||ce===!0){t.activeTexture(i.TEXTURE0+W);let ve=mt.getPrimaries(mt.workingColorSpace),ee=y.colorSpace===ds?null:mt.getPrimaries(y.colorSpace),ne=y.colorSpace===ds||ve===ee?i.NONE:i.BROWSER_DEFAULT_WEBGL;t.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,y.flipY),t.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,y.premultiplyAlpha),t.pixelStorei(i.UNPACK_ALIGNMENT,y.unpackAlignment),t.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,ne);let de=y.isCompressedTexture||y.image[0].isCompressedTexture,F=y.image[0]&&y.image[0].isDataTexture,se=[];for(let Re=0;Re<6;Re++)!de&&!F?se[Re]=v(y.image[Re],!0,s.maxCubemapSize):se[Re]=F?y.image[Re].image:y.image[Re],se[Re]=ke(y,se[Re]);let te=se[0],we=r.convert(y.format,y.colorSpace),ge=r.convert(y.type),be=A(y.internalFormat,we,ge,y.normalized,y.colorSpace),Ge=y.isVideoTexture!==!0,Ze=_e.__version===void 0||ce===!0,oe=re.dataReady,Oe=T(y,te);lt(i.TEXTURE_CUBE_MAP,y);let Je;if(y.isDepthTexture){if(be=x(y.format===fs,y.type),Ze)if(Ge)t.texStorage2D(i.TEXTURE_CUBE_MAP,1,be,te.width,te.height);else for(let Re=0;Re<6;Re++)t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Re,0,be,te.width,te.height,0,we,ge,null)}else if(de){Ge&&Ze&&t.texStorage2D(i.TEXTURE_CUBE_MAP,Oe,be,te.width,te.height);for(let Re=0;Re<6;Re++){Je=se[Re].mipmaps;for(let st=0;st<Je.length;st++){let Bt=Je[st];y.format!==cn?we!==null?Ge?oe&&t.compressedTexSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Re,st,0,0,Bt.width,Bt.height,we,Bt.data):t.compressedTexImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Re,st,be,Bt.width,Bt.height,0,Bt.data):$e("WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):Ge?oe&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Re,st,0,0,Bt.width,Bt.height,we,ge,Bt.data):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Re,st,be,Bt.width,Bt.height,0,we,ge,Bt.data)}}}else{if(Je=y.mipmaps,Ge&&Ze){Je.length>0&&Oe++;let Re=Xe(se[0]);t.texStorage2D(i.TEXTURE_CUBE_MAP,Oe,be,Re.width,Re.height)}for(let Re=0;Re<6;Re++)if(F){Ge?oe&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Re,0,0,0,se[Re].width,se[Re].height,we,ge,se[Re].data):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Re,0,be,se[Re].width,se[Re].height,0,we,ge,se[Re].data);for(let st=0;st<Je.length;st++){let Fn=Je[st].image[Re].image;Ge?oe&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Re,st+1,0,0,Fn.width,Fn.height,we,ge,Fn.data):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Re,st+1,be,Fn.width,Fn.height,0,we,ge,Fn.data)}}else{Ge?oe&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Re,0,0,0,we,ge,se[Re]):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Re,0,be,we,ge,se[Re]);for(let st=0;st<Je.length;st++){let Bt=Je[st];Ge?oe&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Re,st+1,0,0,we,ge,Bt.image[Re]):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Re,st+1,be,we,ge,Bt.image[Re])}}}E(y)&&y.mipmapsAutoUpdate===!0&&S(i.TEXTURE_CUBE_MAP),_e.__version=re.version,y.onUpdate&&y.onUpdate(y)}C.__version=y.version}function Pt(C,y,W,ce,re,_e){let ve=r.convert(W.format,W.colorSpace),ee=r.convert(W.type),ne=A(W.internalFormat,ve,ee,W.normalized,W.colorSpace),de=n.get(y),F=n.get(W);if(F.__renderTarget=y,!de.__hasExternalTextures){let se=Math.max(1,y.width>>_e),te=Math.max(1,y.height>>_e);re===i.TEXTURE_3D||re===i.TEXTURE_2D_ARRAY?t.texImage3D(re,_e,ne,se,te,y.depth,0,ve,ee,null):t.texImage2D(re,_e,ne,se,te,0,ve,ee,null)}t.bindFramebuffer(i.FRAMEBUFFER,C),Me(y)?o.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,ce,re,F.__webglTexture,0,it(y)):(re===i.TEXTURE_2D||re>=i.TEXTURE_CUBE_MAP_POSITIVE_X&&re<=i.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&i.framebufferTexture2D(i.FRAMEBUFFER,ce,re,F.__webglTexture,_e),t.bindFramebuffer(i.FRAMEBUFFER,null)}function xn(C,y,W){if(i.bindRenderbuffer(i.RENDERBUFFER,C),y.depthBuffer){let ce=y.depthTexture,re=ce&&ce.isDepthTexture?ce.type:null,_e=x(y.stencilBuffer,re),ve=y.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;Me(y)?o.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,it(y),_e,y.width,y.height):W?i.renderbufferStorageMultisample(i.RENDERBUFFER,it(y),_e,y.width,y.height):i.renderbufferStorage(i.RENDERBUFFER,_e,y.width,y.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,ve,i.RENDERBUFFER,C)}else{let ce=y.textures;for(let re=0;re<ce.length;re++){let _e=ce[re],ve=r.convert(_e.format,_e.colorSpace),ee=r.convert(_e.type),ne=A(_e.internalFormat,ve,ee,_e.normalized,_e.colorSpace);Me(y)?o.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,it(y),ne,y.width,y.height):W?i.renderbufferStorageMultisample(i.RENDERBUFFER,it(y),ne,y.width,y.height):i.renderbufferStorage(i.RENDERBUFFER,ne,y.width,y.height)}}i.bindRenderbuffer(i.RENDERBUFFER,null)}function xt(C,y,W){let ce=y.isWebGLCubeRenderTarget===!0;if(t.bindFramebuffer(i.FRAMEBUFFER,C),!(y.depthTexture&&y.depthTexture.isDepthTexture))throw new Error("THREE.WebGLTextures: renderTarget.depthTexture must be an instance of THREE.DepthTexture.");let re=n.get(y.depthTexture);re.__renderTarget=y;let _e=ce?y.depthTexture.image[0]:y.depthTexture.image;(!re.__webglTexture||_e.width!==y.width||_e.height!==y.height)&&(_e.width=y.width,_e.height=y.height,y.depthTexture.needsUpdate=!0),ce?Se(y.depthTexture,0):me(y.depthTexture,0);let ve=re.__webglTexture,ee=it(y),ne=ce?i.TEXTURE_CUBE_MAP_POSITIVE_X+W:i.TEXTURE_2D,de=y.depthTexture.format===fs?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;if(y.depthTexture.format===us)Me(y)?o.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,de,ne,ve,0,ee):i.framebufferTexture2D(i.FRAMEBUFFER,de,ne,ve,0);else if(y.depthTexture.format===fs)Me(y)?o.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,de,ne,ve,0,ee):i.framebufferTexture2D(i.FRAMEBUFFER,de,ne,ve,0);else throw new Error("THREE.WebGLTextures: Unknown depthTexture format.")}function fn(C){let y=n.get(C),W=C.isWebGLCubeRenderTarget===!0;if(y.__boundDepthTexture!==C.depthTexture){let ce=C.depthTexture;if(y.__depthDisposeCallback&&y.__depthDisposeCallback(),ce){let re=()=>{delete y.__boundDepthTexture,delete y.__depthDisposeCallback,ce.removeEventListener("dispose",re)};ce.addEventListener("dispose",re),y.__depthDisposeCallback=re}y.__boundDepthTexture=ce}if(C.depthTexture&&!y.__autoAllocateDepthBuffer)if(W)for(let ce=0;ce<6;ce++)xt(y.__webglFramebuffer[ce],C,ce);else C.texture.mipmaps.length>0?xt(y.__webglFramebuffer[0],C,0):xt(y.__webglFramebuffer,C,0);else if(W){y.__webglDepthbuffer=[];for(let ce=0;ce<6;ce++)if(t.bindFramebuffer(i.FRAMEBUFFER,y.__webglFramebuffer[ce]),y.__webglDepthbuffer[ce]===void 0)y.__webglDepthbuffer[ce]=i.createRenderbuffer(),xn(y.__webglDepthbuffer[ce],C,!1);else{let re=C.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,_e=y.__webglDepthbuffer[ce];i.bindRenderbuffer(i.RENDERBUFFER,_e),i.framebufferRenderbuffer(i.FRAMEBUFFER,re,i.RENDERBUFFER,_e)}}else if(C.texture.mipmaps.length>0?t.bindFramebuffer(i.FRAMEBUFFER,y.__webglFramebuffer[0]):t.bindFramebuffer(i.FRAMEBUFFER,y.__webglFramebuffer),y.__webglDepthbuffer===void 0)y.__webglDepthbuffer=i.createRenderbuffer(),xn(y.__webglDepthbuffer,C,!1);else{let re=C.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,_e=y.__webglDepthbuffer;i.bindRenderbuffer(i.RENDERBUFFER,_e),i.framebufferRenderbuffer(i.FRAMEBUFFER,re,i.RENDERBUFFER,_e)}t.bindFramebuffer(i.FRAMEBUFFER,null)}function $t(C,y,W){let ce=n.get(C);y!==void 0&&Pt(ce.__webglFramebuffer,C,C.texture,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,0),W!==void 0&&fn(C)}function nn(C){let y=C.texture,W=n.get(C),ce=n.get(y);C.addEventListener("dispose",G),k(C);let re=C.textures,_e=C.isWebGLCubeRenderTarget===!0,ve=re.length>1;if(ve||(ce.__webglTexture===void 0&&(ce.__webglTexture=i.createTexture()),ce.__version=y.version,a.memory.textures++),_e){W.__webglFramebuffer=[];for(let ee=0;ee<6;ee++)if(y.mipmaps.length>0){W.__webglFramebuffer[ee]=[];for(let ne=0;ne<y.mipmaps.length;ne++)W.__webglFramebuffer[ee][ne]=i.createFramebuffer()}else W.__webglFramebuffer[ee]=i.createFramebuffer()}else{if(y.mipmaps.length>0){W.__webglFramebuffer=[];for(let ee=0;ee<y.mipmaps.length;ee++)W.__webglFramebuffer[ee]=i.createFramebuffer()}else W.__webglFramebuffer=i.createFramebuffer();if(ve)for(let ee=0,ne=re.length;ee<ne;ee++){let de=n.get(re[ee]);de.__webglTexture===void 0&&(de.__webglTexture=i.createTexture(),a.memory.textures++)}if(C.samples>0&&Me(C)===!1){W.__webglMultisampledFramebuffer=i.createFramebuffer(),W.__webglColorRenderbuffer=[],t.bindFramebuffer(i.FRAMEBUFFER,W.__webglMultisampledFramebuffer);for(let ee=0;ee<re.length;ee++){let ne=re[ee];W.__webglColorRenderbuffer[ee]=i.createRenderbuffer(),i.bindRenderbuffer(i.RENDERBUFFER,W.__webglColorRenderbuffer[ee]);let de=r.convert(ne.format,ne.colorSpace),F=r.convert(ne.type),se=A(ne.internalFormat,de,F,ne.normalized,ne.colorSpace,C.isXRRenderTarget===!0),te=it(C);i.renderbufferStorageMultisample(i.RENDERBUFFER,te,se,C.width,C.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+ee,i.RENDERBUFFER,W.__webglColorRenderbuffer[ee])}i.bindRenderbuffer(i.RENDERBUFFER,null),C.depthBuffer&&(W.__webglDepthRenderbuffer=i.createRenderbuffer(),xn(W.__webglDepthRenderbuffer,C,!0)),t.bindFramebuffer(i.FRAMEBUFFER,null)}}if(_e){t.bindTexture(i.TEXTURE_CUBE_MAP,ce.__webglTexture),lt(i.TEXTURE_CUBE_MAP,y);for(let ee=0;ee<6;ee++)if(y.mipmaps.length>0)for(let ne=0;ne<y.mipmaps.length;ne++)Pt(W.__webglFramebuffer[ee][ne],C,y,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+ee,ne);else Pt(W.__webglFramebuffer[ee],C,y,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+ee,0);E(y)?S(i.TEXTURE_CUBE_MAP):y.mipmaps.length>0&&i.texParameteri(i.TEXTURE_CUBE_MAP,i.TEXTURE_MAX_LEVEL,y.mipmaps.length-1),t.unbindTexture()}else if(ve){for(let ee=0,ne=re.length;ee<ne;ee++){let de=re[ee],F=n.get(de),se=i.TEXTURE_2D;(C.isWebGL3DRenderTarget||C.isWebGLArrayRenderTarget)&&(se=C.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),t.bindTexture(se,F.__webglTexture),lt(se,de),Pt(W.__webglFramebuffer,C,de,i.COLOR_ATTACHMENT0+ee,se,0),E(de)&&S(se)}t.unbindTexture()}else{let ee=i.TEXTURE_2D;if((C.isWebGL3DRenderTarget||C.isWebGLArrayRenderTarget)&&(ee=C.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),t.bindTexture(ee,ce.__webglTexture),lt(ee,y),y.mipmaps.length>0)for(let ne=0;ne<y.mipmaps.length;ne++)Pt(W.__webglFramebuffer[ne],C,y,i.COLOR_ATTACHMENT0,ee,ne);else Pt(W.__webglFramebuffer,C,y,i.COLOR_ATTACHMENT0,ee,0);E(y)?S(ee):y.mipmaps.length>0&&i.texParameteri(ee,i.TEXTURE_MAX_LEVEL,y.mipmaps.length-1),t.unbindTexture()}C.depthBuffer&&fn(C)}function U(C){let y=C.textures;for(let W=0,ce=y.length;W<ce;W++){let re=y[W];if(E(re)&&re.mipmapsAutoUpdate===!0){let _e=R(C),ve=n.get(re).__webglTexture;t.bindTexture(_e,ve),S(_e),t.unbindTexture()}}}let Ce=[];function qe(C){if(C.samples>0){if(Me(C)===!1){let y=C.textures,W=C.width,ce=C.height,re=i.COLOR_BUFFER_BIT,_e=C.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,ve=n.get(C),ee=y.length>1;if(ee)for(let de=0;de<y.length;de++)t.bindFramebuffer(i.FRAMEBUFFER,ve.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+de,i.RENDERBUFFER,null),t.bindFramebuffer(i.FRAMEBUFFER,ve.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+de,i.TEXTURE_2D,null,0);t.bindFramebuffer(i.READ_FRAMEBUFFER,ve.__webglMultisampledFramebuffer),C.texture.mipmaps.length>0?t.bindFramebuffer(i.DRAW_FRAMEBUFFER,ve.__webglFramebuffer[0]):t.bindFramebuffer(i.DRAW_FRAMEBUFFER,ve.__webglFramebuffer);for(let de=0;de<y.length;de++){if(C.resolveDepthBuffer&&(C.depthBuffer&&(re|=i.DEPTH_BUFFER_BIT),C.stencilBuffer&&C.resolveStencilBuffer&&(re|=i.STENCIL_BUFFER_BIT)),ee){i.framebufferRenderbuffer(i.READ_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.RENDERBUFFER,ve.__webglColorRenderbuffer[de]);let F=n.get(y[de]).__webglTexture;i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,F,0)}i.blitFramebuffer(0,0,W,ce,0,0,W,ce,re,i.NEAREST),l===!0&&(Ce.length=0,Ce.push(i.COLOR_ATTACHMENT0+de),C.depthBuffer&&C.storeMultisampledDepthBuffer===!1&&Ce.push(_e),i.invalidateFramebuffer(i.READ_FRAMEBUFFER,Ce))}if(t.bindFramebuffer(i.READ_FRAMEBUFFER,null),t.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),ee)for(let de=0;de<y.length;de++){t.bindFramebuffer(i.FRAMEBUFFER,ve.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+de,i.RENDERBUFFER,ve.__webglColorRenderbuffer[de]);let F=n.get(y[de]).__webglTexture;t.bindFramebuffer(i.FRAMEBUFFER,ve.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+de,i.TEXTURE_2D,F,0)}t.bindFramebuffer(i.DRAW_FRAMEBUFFER,ve.__webglMultisampledFramebuffer)}else if(C.depthBuffer&&C.storeMultisampledDepthBuffer===!1&&l){let y=C.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;i.invalidateFramebuffer(i.DRAW_FRAMEBUFFER,[y])}}}function it(C){return Math.min(s.maxSamples,C.samples)}function Me(C){let y=n.get(C);return C.samples>0&&e.has("WEBGL_multisampled_render_to_texture")===!0&&y.__useRenderToTexture!==!1}function Dt(C){let y=a.render.frame;u.get(C)!==y&&(u.set(C,y),C.update())}function ke(C,y){let W=C.colorSpace,ce=C.format,re=C.type;return C.isCompressedTexture===!0||C.isVideoTexture===!0||W!==Ia&&W!==ds&&(mt.getTransfer(W)===Tt?(ce!==cn||re!==ni)&&$e("WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):Qe("WebGLTextures: Unsupported texture color space:",W)),y}function Xe(C){return typeof HTMLImageElement<"u"&&C instanceof HTMLImageElement?(c.width=C.naturalWidth||C.width,c.height=C.naturalHeight||C.height):typeof VideoFrame<"u"&&C instanceof VideoFrame?(c.width=C.displayWidth,c.height=C.displayHeight):(c.width=C.width,c.height=C.height),c}this.allocateTextureUnit=ue,this.resetTextureUnits=Q,this.getTextureUnits=ie,this.setTextureUnits=he,this.setTexture2D=me,this.setTexture2DArray=xe,this.setTexture3D=Ee,this.setTextureCube=Se,this.rebindTextures=$t,this.setupRenderTarget=nn,this.updateRenderTargetMipmap=U,this.updateMultisampleRenderTarget=qe,this.setupDepthRenderbuffer=fn,this.setupFrameBufferTexture=Pt,this.useMultisampledRTT=Me,this.dispose=V}function ib(i,e){function t(n,s=ds){let r,a=mt.getTransfer(s);if(n===ni)return i.UNSIGNED_BYTE;if(n===Pl)return i.UNSIGNED_SHORT_4_4_4_4;if(n===Il)return i.UNSIGNED_SHORT_5_5_5_1;if(n===ih)return i.UNSIGNED_INT_5_9_9_9_REV;if(n===sh)return i.UNSIGNED_INT_10F_11F_11F_REV;if(n===th)return i.BYTE;if(n===nh)return i.SHORT;if(n===Jr)return i.UNSIGNED_SHORT;if(n===Cl)return i.INT;if(n===Ai)return i.UNSIGNED_INT;if(n===Nt)return i.FLOAT;if(n===Ln)return i.HALF_FLOAT;if(n===rh)return i.ALPHA;if(n===ah)return i.RGB;if(n===cn)return i.RGBA;if(n===us)return i.DEPTH_COMPONENT;if(n===fs)return i.DEPTH_STENCIL;if(n===oh)return i.RED;if(n===Ll)return i.RED_INTEGER;if(n===Xi)return i.RG;if(n===Dl)return i.RG_INTEGER;if(n===Nl)return i.RGBA_INTEGER;if(n===qa||n===Ya||n===$a||n===Za)if(a===Tt)if(r=e.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(n===qa)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(n===Ya)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(n===$a)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(n===Za)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=e.get("WEBGL_compressed_texture_s3tc"),r!==null){if(n===qa)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(n===Ya)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(n===$a)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(n===Za)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(n===Fl||n===Ul||n===Ol||n===Bl)if(r=e.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(n===Fl)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(n===Ul)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(n===Ol)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(n===Bl)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(n===zl||n===kl||n===Vl||n===Gl||n===Hl||n===Ja||n===Wl)if(r=e.get("WEBGL_compressed_texture_etc"),r!==null){if(n===zl||n===kl)return a===Tt?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(n===Vl)return a===Tt?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC;if(n===Gl)return r.COMPRESSED_R11_EAC;if(n===Hl)return r.COMPRESSED_SIGNED_R11_EAC;if(n===Ja)return r.COMPRESSED_RG11_EAC;if(n===Wl)return r.COMPRESSED_SIGNED_RG11_EAC}else return null;if(n===Xl||n===ql||n===Yl||n===$l||n===Zl||n===Jl||n===Kl||n===Ql||n===jl||n===ec||n===tc||n===nc||n===ic||n===sc)if(r=e.get("WEBGL_compressed_texture_astc"),r!==null){if(n===Xl)return a===Tt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(n===ql)return a===Tt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(n===Yl)return a===Tt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(n===$l)return a===Tt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(n===Zl)return a===Tt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(n===Jl)return a===Tt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(n===Kl)return a===Tt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(n===Ql)return a===Tt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(n===jl)return a===Tt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(n===ec)return a===Tt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(n===tc)return a===Tt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(n===nc)return a===Tt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(n===ic)return a===Tt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(n===sc)return a===Tt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(n===rc||n===ac||n===oc)if(r=e.get("EXT_texture_compression_bptc"),r!==null){if(n===rc)return a===Tt?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(n===ac)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(n===oc)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(n===lc||n===cc||n===Ka||n===uc)if(r=e.get("EXT_texture_compression_rgtc"),r!==null){if(n===lc)return r.COMPRESSED_RED_RGTC1_EXT;if(n===cc)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(n===Ka)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(n===uc)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return n===ir?i.UNSIGNED_INT_24_8:i[n]!==void 0?i[n]:null}return{convert:t}}var sb=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,rb=`
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

}`,Ah=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(e,t){if(this.texture===null){let n=new Va(e.texture);(e.depthNear!==t.depthNear||e.depthFar!==t.depthFar)&&(this.depthNear=e.depthNear,this.depthFar=e.depthFar),this.texture=n}}getMesh(e){if(this.texture!==null&&this.mesh===null){let t=e.cameras[0].viewport,n=new Gi({vertexShader:sb,fragmentShader:rb,uniforms:{depthColor:{value:this.texture},depthWidth:{value:t.z},depthHeight:{value:t.w}}});this.mesh=new pi(new Ga(20,20),n)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},Eh=class extends ki{constructor(e,t){super();let n=this,s=null,r=1,a=null,o="local-floor",l=1,c=null,u=null,f=null,h=null,d=null,g=null,b=typeof XRWebGLBinding<"u",m=new Ah,p={},v=t.getContextAttributes(),E=null,S=null,R=[],A=[],x=new ct,T=null,k=null,N=new ei;N.viewport=new Lt;let L=new ei;L.viewport=new Lt;let G=[N,L],H=new Tl,D=null,V=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(j){let me=R[j];return me===void 0&&(me=new Gr,R[j]=me),me.getTargetRaySpace()},this.getControllerGrip=function(j){let me=R[j];return me===void 0&&(me=new Gr,R[j]=me),me.getGripSpace()},this.getHand=function(j){let me=R[j];return me===void 0&&(me=new Gr,R[j]=me),me.getHandSpace()};function Z(j){let me=A.indexOf(j.inputSource);if(me===-1)return;let xe=R[me];xe!==void 0&&(xe.update(j.inputSource,j.frame,c||a),xe.dispatchEvent({type:j.type,data:j.inputSource}))}function z(){s.removeEventListener("select",Z),s.removeEventListener("selectstart",Z),s.removeEventListener("selectend",Z),s.removeEventListener("squeeze",Z),s.removeEventListener("squeezestart",Z),s.removeEventListener("squeezeend",Z),s.removeEventListener("end",z),s.removeEventListener("inputsourceschange",le);for(let j=0;j<R.length;j++){let me=A[j];me!==null&&(A[j]=null,R[j].disconnect(me))}D=null,V=null,m.reset();for(let j in p)delete p[j];if(e.setRenderTarget(E),d=null,h=null,f=null,s=null,S=null,ue.stop(),n.isPresenting=!1,e.setPixelRatio(T),e.setSize(x.width,x.height,!1),k!==null){let j=k.camera;j.fov=k.fov,j.zoom=k.zoom,j.updateProjectionMatrix(),k=null}n.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(j){r=j,n.isPresenting===!0&&$e("WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(j){o=j,n.isPresenting===!0&&$e("WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return c||a},this.setReferenceSpace=function(j){c=j},this.getBaseLayer=function(){return h!==null?h:d},this.getBinding=function(){return f===null&&b&&(f=new XRWebGLBinding(s,t)),f},this.getFrame=function(){return g},this.getSession=function(){return s},this.setSession=async function(j){if(s=j,s!==null){if(E=e.getRenderTarget(),s.addEventListener("select",Z),s.addEventListener("selectstart",Z),s.addEventListener("selectend",Z),s.addEventListener("squeeze",Z),s.addEventListener("squeezestart",Z),s.addEventListener("squeezeend",Z),s.addEventListener("end",z),s.addEventListener("inputsourceschange",le),v.xrCompatible!==!0&&await t.makeXRCompatible(),T=e.getPixelRatio(),e.getSize(x),b&&"createProjectionLayer"in XRWebGLBinding.prototype){let xe=null,Ee=null,Se=null;v.depth&&(Se=v.stencil?t.DEPTH24_STENCIL8:t.DEPTH_COMPONENT24,xe=v.stencil?fs:us,Ee=v.stencil?ir:Ai);let He={colorFormat:t.RGBA8,depthFormat:Se,scaleFactor:r};f=this.getBinding(),h=f.createProjectionLayer(He),s.updateRenderState({layers:[h]}),e.setPixelRatio(1),e.setSize(h.textureWidth,h.textureHeight,!1),S=new wn(h.textureWidth,h.textureHeight,{format:cn,type:ni,depthTexture:new Ti(h.textureWidth,h.textureHeight,Ee,void 0,void 0,void 0,void 0,void 0,void 0,xe),stencilBuffer:v.stencil,colorSpace:e.outputColorSpace,samples:v.antialias?4:0,resolveDepthBuffer:h.ignoreDepthValues===!1,resolveStencilBuffer:h.ignoreDepthValues===!1,storeMultisampledDepthBuffer:h.ignoreDepthValues===!1,storeMultisampledStencilBuffer:h.ignoreDepthValues===!1})}else{let xe={antialias:v.antialias,alpha:!0,depth:v.depth,stencil:v.stencil,framebufferScaleFactor:r};d=new XRWebGLLayer(s,t,xe),s.updateRenderState({baseLayer:d}),e.setPixelRatio(1),e.setSize(d.framebufferWidth,d.framebufferHeight,!1),S=new wn(d.framebufferWidth,d.framebufferHeight,{format:cn,type:ni,colorSpace:e.outputColorSpace,stencilBuffer:v.stencil,resolveDepthBuffer:d.ignoreDepthValues===!1,resolveStencilBuffer:d.ignoreDepthValues===!1,storeMultisampledDepthBuffer:d.ignoreDepthValues===!1,storeMultisampledStencilBuffer:d.ignoreDepthValues===!1})}S.isXRRenderTarget=!0,this.setFoveation(l),c=null,a=await s.requestReferenceSpace(o),ue.setContext(s),ue.start(),n.isPresenting=!0,n.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return m.getDepthTexture()};function le(j){for(let me=0;me<j.removed.length;me++){let xe=j.removed[me],Ee=A.indexOf(xe);Ee>=0&&(A[Ee]=null,R[Ee].disconnect(xe))}for(let me=0;me<j.added.length;me++){let xe=j.added[me],Ee=A.indexOf(xe);if(Ee===-1){for(let He=0;He<R.length;He++)if(He>=A.length){A.push(xe),Ee=He;break}else if(A[He]===null){A[He]=xe,Ee=He;break}if(Ee===-1)break}let Se=R[Ee];Se&&Se.connect(xe)}}function J(j,me){me===null?j.matrixWorld.copy(j.matrix):j.matrixWorld.multiplyMatrices(me.matrixWorld,j.matrix),j.matrixWorldInverse.copy(j.matrixWorld).invert()}this.updateCamera=function(j){if(s===null)return;let me=j.near,xe=j.far;m.texture!==null&&(m.depthNear>0&&(me=m.depthNear),m.depthFar>0&&(xe=m.depthFar)),H.near=L.near=N.near=me,H.far=L.far=N.far=xe,(D!==H.near||V!==H.far)&&(s.updateRenderState({depthNear:H.near,depthFar:H.far}),D=H.near,V=H.far),H.layers.mask=j.layers.mask|6,N.layers.mask=H.layers.mask&-5,L.layers.mask=H.layers.mask&-3;let Ee=j.parent,Se=H.cameras;J(H,Ee);for(let He=0;He<Se.length;He++)J(Se[He],Ee);H.projectionMatrix.copy(N.projectionMatrix),H.projectionMatrixInverse.copy(N.projectionMatrixInverse),k===null&&j.isPerspectiveCamera&&(k={camera:j,fov:j.fov,zoom:j.zoom}),Q(j,H,Ee)};function Q(j,me,xe){xe===null?j.matrix.copy(me.matrixWorld):(j.matrix.copy(xe.matrixWorld),j.matrix.invert(),j.matrix.multiply(me.matrixWorld)),j.matrix.decompose(j.position,j.quaternion,j.scale),j.updateMatrixWorld(!0),j.projectionMatrix.copy(me.projectionMatrix),j.projectionMatrixInverse.copy(me.projectionMatrixInverse),j.isPerspectiveCamera&&(j.fov=rl*2*Math.atan(1/j.projectionMatrix.elements[5]),j.zoom=1)}this.getCamera=function(){return H},this.getFoveation=function(){if(!(h===null&&d===null))return l},this.setFoveation=function(j){l=j,h!==null&&(h.fixedFoveation=j),d!==null&&d.fixedFoveation!==void 0&&(d.fixedFoveation=j)},this.hasDepthSensing=function(){return m.texture!==null},this.getDepthSensingMesh=function(){return m.getMesh(H)},this.getCameraTexture=function(j){return p[j]};let ie=null;function he(j,me){if(u=me.getViewerPose(c||a),g=me,u!==null){let xe=u.views;d!==null&&(e.setRenderTargetFramebuffer(S,d.framebuffer),e.setRenderTarget(S));let Ee=!1;xe.length!==H.cameras.length&&(H.cameras.length=0,Ee=!0);for(let Ve=0;Ve<xe.length;Ve++){let lt=xe[Ve],rt=null;if(d!==null)rt=d.getViewport(lt);else{let Wt=f.getViewSubImage(h,lt);rt=Wt.viewport,Ve===0&&(e.setRenderTargetTextures(S,Wt.colorTexture,Wt.depthStencilTexture),e.setRenderTarget(S))}let et=G[Ve];et===void 0&&(et=new ei,et.layers.enable(Ve),et.viewport=new Lt,G[Ve]=et),et.matrix.fromArray(lt.transform.matrix),et.matrix.decompose(et.position,et.quaternion,et.scale),et.projectionMatrix.fromArray(lt.projectionMatrix),et.projectionMatrixInverse.copy(et.projectionMatrix).invert(),et.viewport.set(rt.x,rt.y,rt.width,rt.height),Ve===0&&(H.matrix.copy(et.matrix),H.matrix.decompose(H.position,H.quaternion,H.scale)),Ee===!0&&H.cameras.push(et)}let Se=s.enabledFeatures;if(Se&&Se.includes("depth-sensing")&&s.depthUsage=="gpu-optimized"&&b){f=n.getBinding();let Ve=f.getDepthInformation(xe[0]);Ve&&Ve.isValid&&Ve.texture&&m.init(Ve,s.renderState)}if(Se&&Se.includes("camera-access")&&b){e.state.unbindTexture(),f=n.getBinding();for(let Ve=0;Ve<xe.length;Ve++){let lt=xe[Ve].camera;if(lt){let rt=p[lt];rt||(rt=new Va,p[lt]=rt);let et=f.getCameraImage(lt);rt.sourceTexture=et}}}}for(let xe=0;xe<R.length;xe++){let Ee=A[xe],Se=R[xe];Ee!==null&&Se!==void 0&&Se.update(Ee,me,c||a)}ie&&ie(j,me),me.detectedPlanes&&n.dispatchEvent({type:"planesdetected",data:me}),g=null}let ue=new Rp;ue.setAnimationLoop(he),this.setAnimationLoop=function(j){ie=j},this.dispose=function(){}}},ab=new dt,Bp=new je;Bp.set(-1,0,0,0,1,0,0,0,1);function ob(i,e){function t(m,p){m.matrixAutoUpdate===!0&&m.updateMatrix(),p.value.copy(m.matrix)}function n(m,p){p.color.getRGB(m.fogColor.value,ph(i)),p.isFog?(m.fogNear.value=p.near,m.fogFar.value=p.far):p.isFogExp2&&(m.fogDensity.value=p.density)}function s(m,p,v,E,S){p.isNodeMaterial?p.uniformsNeedUpdate=!1:p.isMeshBasicMaterial?r(m,p):p.isMeshLambertMaterial?(r(m,p),p.envMap&&(m.envMapIntensity.value=p.envMapIntensity)):p.isMeshToonMaterial?(r(m,p),f(m,p)):p.isMeshPhongMaterial?(r(m,p),u(m,p),p.envMap&&(m.envMapIntensity.value=p.envMapIntensity)):p.isMeshStandardMaterial?(r(m,p),h(m,p),p.isMeshPhysicalMaterial&&d(m,p,S)):p.isMeshMatcapMaterial?(r(m,p),g(m,p)):p.isMeshDepthMaterial?r(m,p):p.isMeshDistanceMaterial?(r(m,p),b(m,p)):p.isMeshNormalMaterial?r(m,p):p.isLineBasicMaterial?(a(m,p),p.isLineDashedMaterial&&o(m,p)):p.isPointsMaterial?l(m,p,v,E):p.isSpriteMaterial?c(m,p):p.isShadowMaterial?(m.color.value.copy(p.color),m.opacity.value=p.opacity):p.isShaderMaterial&&(p.uniformsNeedUpdate=!1)}function r(m,p){m.opacity.value=p.opacity,p.color&&m.diffuse.value.copy(p.color),p.emissive&&m.emissive.value.copy(p.emissive).multiplyScalar(p.emissiveIntensity),p.map&&(m.map.value=p.map,t(p.map,m.mapTransform)),p.alphaMap&&(m.alphaMap.value=p.alphaMap,t(p.alphaMap,m.alphaMapTransform)),p.bumpMap&&(m.bumpMap.value=p.bumpMap,t(p.bumpMap,m.bumpMapTransform),m.bumpScale.value=p.bumpScale,p.side===Vn&&(m.bumpScale.value*=-1)),p.normalMap&&(m.normalMap.value=p.normalMap,t(p.normalMap,m.normalMapTransform),m.normalScale.value.copy(p.normalScale),p.side===Vn&&m.normalScale.value.negate()),p.displacementMap&&(m.displacementMap.value=p.displacementMap,t(p.displacementMap,m.displacementMapTransform),m.displacementScale.value=p.displacementScale,m.displacementBias.value=p.displacementBias),p.emissiveMap&&(m.emissiveMap.value=p.emissiveMap,t(p.emissiveMap,m.emissiveMapTransform)),p.specularMap&&(m.specularMap.value=p.specularMap,t(p.specularMap,m.specularMapTransform)),p.alphaTest>0&&(m.alphaTest.value=p.alphaTest);let v=e.get(p),E=v.envMap,S=v.envMapRotation;E&&(m.envMap.value=E,m.envMapRotation.value.setFromMatrix4(ab.makeRotationFromEuler(S)).transpose(),E.isCubeTexture&&E.isRenderTargetTexture===!1&&m.envMapRotation.value.premultiply(Bp),m.reflectivity.value=p.reflectivity,m.ior.value=p.ior,m.refractionRatio.value=p.refractionRatio),p.lightMap&&(m.lightMap.value=p.lightMap,m.lightMapIntensity.value=p.lightMapIntensity,t(p.lightMap,m.lightMapTransform)),p.aoMap&&(m.aoMap.value=p.aoMap,m.aoMapIntensity.value=p.aoMapIntensity,t(p.aoMap,m.aoMapTransform))}function a(m,p){m.diffuse.value.copy(p.color),m.opacity.value=p.opacity,p.map&&(m.map.value=p.map,t(p.map,m.mapTransform))}function o(m,p){m.dashSize.value=p.dashSize,m.totalSize.value=p.dashSize+p.gapSize,m.scale.value=p.scale}function l(m,p,v,E){m.diffuse.value.copy(p.color),m.opacity.value=p.opacity,m.size.value=p.size*v,m.scale.value=E*.5,p.map&&(m.map.value=p.map,t(p.map,m.uvTransform)),p.alphaMap&&(m.alphaMap.value=p.alphaMap,t(p.alphaMap,m.alphaMapTransform)),p.alphaTest>0&&(m.alphaTest.value=p.alphaTest)}function c(m,p){m.diffuse.value.copy(p.color),m.opacity.value=p.opacity,m.rotation.value=p.rotation,p.map&&(m.map.value=p.map,t(p.map,m.mapTransform)),p.alphaMap&&(m.alphaMap.value=p.alphaMap,t(p.alphaMap,m.alphaMapTransform)),p.alphaTest>0&&(m.alphaTest.value=p.alphaTest)}function u(m,p){m.specular.value.copy(p.specular),m.shininess.value=Math.max(p.shininess,1e-4)}function f(m,p){p.gradientMap&&(m.gradientMap.value=p.gradientMap)}function h(m,p){m.metalness.value=p.metalness,p.metalnessMap&&(m.metalnessMap.value=p.metalnessMap,t(p.metalnessMap,m.metalnessMapTransform)),m.roughness.value=p.roughness,p.roughnessMap&&(m.roughnessMap.value=p.roughnessMap,t(p.roughnessMap,m.roughnessMapTransform)),p.envMap&&(m.envMapIntensity.value=p.envMapIntensity)}function d(m,p,v){m.ior.value=p.ior,p.diffuseRoughness>0&&(m.diffuseRoughness.value=p.diffuseRoughness,p.diffuseRoughnessMap&&(m.diffuseRoughnessMap.value=p.diffuseRoughnessMap,t(p.diffuseRoughnessMap,m.diffuseRoughnessMapTransform))),p.sheen>0&&(m.sheenColor.value.copy(p.sheenColor).multiplyScalar(p.sheen),m.sheenRoughness.value=p.sheenRoughness,p.sheenColorMap&&(m.sheenColorMap.value=p.sheenColorMap,t(p.sheenColorMap,m.sheenColorMapTransform)),p.sheenRoughnessMap&&(m.sheenRoughnessMap.value=p.sheenRoughnessMap,t(p.sheenRoughnessMap,m.sheenRoughnessMapTransform))),p.clearcoat>0&&(m.clearcoat.value=p.clearcoat,m.clearcoatRoughness.value=p.clearcoatRoughness,p.clearcoatMap&&(m.clearcoatMap.value=p.clearcoatMap,t(p.clearcoatMap,m.clearcoatMapTransform)),p.clearcoatRoughnessMap&&(m.clearcoatRoughnessMap.value=p.clearcoatRoughnessMap,t(p.clearcoatRoughnessMap,m.clearcoatRoughnessMapTransform)),p.clearcoatNormalMap&&(m.clearcoatNormalMap.value=p.clearcoatNormalMap,t(p.clearcoatNormalMap,m.clearcoatNormalMapTransform),m.clearcoatNormalScale.value.copy(p.clearcoatNormalScale),p.side===Vn&&m.clearcoatNormalScale.value.negate())),p.dispersion>0&&(m.dispersion.value=p.dispersion),p.retroreflectivity>0&&(m.retroreflectivity.value=p.retroreflectivity),p.iridescence>0&&(m.iridescence.value=p.iridescence,m.iridescenceIOR.value=p.iridescenceIOR,m.iridescenceThicknessMinimum.value=p.iridescenceThicknessMinimum,m.iridescenceThicknessMaximum.value=p.iridescenceThicknessMaximum,p.iridescenceMap&&(m.iridescenceMap.value=p.iridescenceMap,t(p.iridescenceMap,m.iridescenceMapTransform)),p.iridescenceThicknessMap&&(m.iridescenceThicknessMap.value=p.iridescenceThicknessMap,t(p.iridescenceThicknessMap,m.iridescenceThicknessMapTransform))),p.transmission>0&&(m.transmission.value=p.transmission,m.transmissionSamplerMap.value=v.texture,m.transmissionSamplerSize.value.set(v.width,v.height),p.transmissionMap&&(m.transmissionMap.value=p.transmissionMap,t(p.transmissionMap,m.transmissionMapTransform)),m.thickness.value=p.thickness,p.thicknessMap&&(m.thicknessMap.value=p.thicknessMap,t(p.thicknessMap,m.thicknessMapTransform)),m.attenuationDistance.value=p.attenuationDistance,m.attenuationColor.value.copy(p.attenuationColor)),p.anisotropy>0&&(m.anisotropyVector.value.set(p.anisotropy*Math.cos(p.anisotropyRotation),p.anisotropy*Math.sin(p.anisotropyRotation)),p.anisotropyMap&&(m.anisotropyMap.value=p.anisotropyMap,t(p.anisotropyMap,m.anisotropyMapTransform))),m.specularIntensity.value=p.specularIntensity,m.specularColor.value.copy(p.specularColor),p.specularColorMap&&(m.specularColorMap.value=p.specularColorMap,t(p.specularColorMap,m.specularColorMapTransform)),p.specularIntensityMap&&(m.specularIntensityMap.value=p.specularIntensityMap,t(p.specularIntensityMap,m.specularIntensityMapTransform))}function g(m,p){p.matcap&&(m.matcap.value=p.matcap)}function b(m,p){let v=e.get(p).light;m.referencePosition.value.setFromMatrixPosition(v.matrixWorld),m.nearDistance.value=v.shadow.camera.near,m.farDistance.value=v.shadow.camera.far}return{refreshFogUniforms:n,refreshMaterialUniforms:s}}function lb(i,e,t,n){let s={},r={};function a(v,E){let S=E.program;n.uniformBlockBinding(v,S,s[v.id])}function o(v,E){let S=s[v.id];S===void 0&&(g(v),S=l(v),s[v.id]=S,v.addEventListener("dispose",m));let R=E.program;n.updateUBOMapping(v,R);let A=e.render.frame;r[v.id]!==A&&(c(v),r[v.id]=A)}function l(v){let E=i.createBuffer(),S=v.__size,R=v.usage;return i.bindBuffer(i.UNIFORM_BUFFER,E),i.bufferData(i.UNIFORM_BUFFER,S,R),i.bindBuffer(i.UNIFORM_BUFFER,null),E}function c(v){let E=s[v.id],S=v.uniforms,R=v.__cache;i.bindBuffer(i.UNIFORM_BUFFER,E);for(let A=0,x=S.length;A<x;A++){let T=S[A];if(Array.isArray(T))for(let k=0,N=T.length;k<N;k++)u(T[k],A,k,R);else u(T,A,0,R)}i.bindBuffer(i.UNIFORM_BUFFER,null)}function u(v,E,S,R){if(h(v,E,S,R)===!0){let A=v.__offset,x=v.value;if(Array.isArray(x)){let T=0;for(let k=0;k<x.length;k++){let N=x[k],L=b(N,!0);f(N,v.__data,T),T+=L.storage/Float32Array.BYTES_PER_ELEMENT}}else f(x,v.__data,0);i.bufferSubData(i.UNIFORM_BUFFER,A,v.__data)}}function f(v,E,S){typeof v=="number"||typeof v=="boolean"?E[S]=v:v.isMatrix3?(E[S]=v.elements[0],E[S+1]=v.elements[1],E[S+2]=v.elements[2],E[S+3]=0,E[S+4]=v.elements[3],E[S+5]=v.elements[4],E[S+6]=v.elements[5],E[S+7]=0,E[S+8]=v.elements[6],E[S+9]=v.elements[7],E[S+10]=v.elements[8],E[S+11]=0):ArrayBuffer.isView(v)?E.set(v.subarray(0,E.length-S),S):v.toArray(E,S)}function h(v,E,S,R){let A=v.value,x=E+"_"+S;if(Array.isArray(A)){R[x]===void 0&&(R[x]=[]);let T=R[x],k=!1;for(let N=0;N<A.length;N++)d(A[N],T,N)===!0&&(k=!0);return k}return d(A,R,x)}function d(v,E,S){if(E[S]===void 0)return typeof v=="number"||typeof v=="boolean"?E[S]=v:ArrayBuffer.isView(v)?E[S]=v.slice():E[S]=v.clone(),!0;{let R=E[S];if(typeof v=="number"||typeof v=="boolean"){if(R!==v)return E[S]=v,!0}else{if(ArrayBuffer.isView(v))return!0;if(R.equals(v)===!1)return R.copy(v),!0}}return!1}function g(v){let E=v.uniforms,S=0,R=16;for(let x=0,T=E.length;x<T;x++){let k=Array.isArray(E[x])?E[x]:[E[x]];for(let N=0,L=k.length;N<L;N++){let G=k[N],H=Array.isArray(G.value)?G.value:[G.value],D=Array.isArray(E[x])||Array.isArray(G.value),V=S;for(let z=0,le=H.length;z<le;z++){let J=H[z],Q=b(J,D),ie=S%R,he=ie%Q.boundary,ue=ie+he;S+=he,ue!==0&&R-ue<Q.storage&&(S+=R-ue),z===0&&(V=S),S+=Q.storage}let Z=G.type==="int"?Int32Array:G.type==="uint"?Uint32Array:Float32Array;G.__data=new Z((S-V)/Float32Array.BYTES_PER_ELEMENT),G.__offset=V}}let A=S%R;return A>0&&(S+=R-A),v.__size=S,v.__cache={},this}function b(v,E){let S={boundary:0,storage:0};return typeof v=="number"||typeof v=="boolean"?(S.boundary=4,S.storage=4):v.isVector2?(S.boundary=8,S.storage=8):v.isVector3||v.isColor?(S.boundary=16,S.storage=12):v.isVector4?(S.boundary=16,S.storage=16):v.isMatrix3?(S.boundary=16,S.storage=48):v.isMatrix4?(S.boundary=16,S.storage=64):v.isTexture?$e("WebGLRenderer: Texture samplers can not be part of an uniforms group."):ArrayBuffer.isView(v)?(S.boundary=16,S.storage=v.byteLength):$e("WebGLRenderer: Unsupported uniform value type.",v),E===!0&&(S.boundary=16,S.storage=Math.ceil(S.storage/16)*16),S}function m(v){let E=v.target;E.removeEventListener("dispose",m),i.deleteBuffer(s[E.id]),delete s[E.id],delete r[E.id]}function p(){for(let v in s)i.deleteBuffer(s[v]);s={},r={}}return{bind:a,update:o,dispose:p}}var cb=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]),qi=null;function ub(){return qi===null&&(qi=new mi(cb,16,16,Xi,Ln),qi.name="DFG_LUT",qi.minFilter=An,qi.magFilter=An,qi.wrapS=ci,qi.wrapT=ci,qi.generateMipmaps=!1,qi.needsUpdate=!0),qi}var pc=class{constructor(e={}){let{canvas:t=Qd(),context:n=null,depth:s=!0,stencil:r=!1,alpha:a=!1,antialias:o=!1,premultipliedAlpha:l=!0,preserveDrawingBuffer:c=!1,powerPreference:u="default",failIfMajorPerformanceCaveat:f=!1,reversedDepthBuffer:h=!1,outputBufferType:d=ni}=e;this.isWebGLRenderer=!0;let g;if(n!==null){if(typeof WebGLRenderingContext<"u"&&n instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");g=n.getContextAttributes().alpha}else g=a;let b=d,m=new Set([Nl,Dl,Ll]),p=new Set([ni,Ai,Jr,ir,Pl,Il]),v=new Uint32Array(4),E=new Int32Array(4),S={textures:[],min:[],max:[],resolution:[]},R=null,A=null,x=[],T=[],k=null;this.domElement=t,this.debug={checkShaderErrors:!0,diagnostics:{keywords:!1},onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=Wi,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let N=this,L=!1,G=null,H=null,D=null,V=null;this._outputColorSpace=jn;let Z=0,z=0,le=null,J=-1,Q=null,ie=new Lt,he=new Lt,ue=null,j=new vt(0),me=0,xe=t.width,Ee=t.height,Se=1,He=null,nt=null,Ve=new Lt(0,0,xe,Ee),lt=new Lt(0,0,xe,Ee),rt=!1,et=new Qs,Wt=new hl,Ot=!1,tn=!1,Pt=new dt,xn=new Y,xt=new Lt,fn={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},$t=!1;function nn(){return le===null?Se:1}let U=n;function Ce(w,O){return t.getContext(w,O)}let qe,it,Me,Dt,ke,Xe,C,y,W,ce,re,_e,ve,ee,ne,de,F,se,te,we,ge,be,Ge;try{let w={alpha:!0,depth:s,stencil:r,antialias:o,premultipliedAlpha:l,preserveDrawingBuffer:c,powerPreference:u,failIfMajorPerformanceCaveat:f};if("setAttribute"in t&&t.setAttribute("data-engine",`three.js r${"187"}`),t.addEventListener("webglcontextlost",Oe,!1),t.addEventListener("webglcontextrestored",Je,!1),t.addEventListener("webglcontextcreationerror",Re,!1),U===null){let O="webgl2";if(U=Ce(O,w),U===null)throw Ce(O)?new Error("THREE.WebGLRenderer: Error creating WebGL context with your selected attributes."):new Error("THREE.WebGLRenderer: Error creating WebGL context.")}Ze()}catch(w){throw t.removeEventListener("webglcontextlost",Oe,!1),t.removeEventListener("webglcontextrestored",Je,!1),t.removeEventListener("webglcontextcreationerror",Re,!1),Qe("WebGLRenderer: "+w.message),w}function Ze(){qe=new b1(U),qe.init(),ge=new ib(U,qe),it=new u1(U,qe,e,ge),Me=new tb(U,qe),it.reversedDepthBuffer&&h&&Me.buffers.depth.setReversed(!0),H=U.createFramebuffer(),D=U.createFramebuffer(),V=U.createFramebuffer(),Dt=new w1(U),ke=new Vy,Xe=new nb(U,qe,Me,ke,it,ge,Dt),C=new y1(N),y=new A_(U),be=new l1(U,y),W=new S1(U,y,Dt,be),ce=new A1(U,W,y,be,Dt),se=new T1(U,it,Xe),ne=new h1(ke),re=new ky(N,C,qe,it,be,ne),_e=new ob(N,ke),ve=new Hy,ee=new Zy(qe),F=new o1(N,C,Me,ce,g,l),de=new eb(N,ce,it),Ge=new lb(U,Dt,it,Me),te=new c1(U,qe,Dt),we=new M1(U,qe,Dt),Dt.programs=re.programs,N.capabilities=it,N.extensions=qe,N.properties=ke,N.renderLists=ve,N.shadowMap=de,N.state=Me,N.info=Dt}b!==ni&&(k=new R1(b,t.width,t.height,o,s,r));let oe=new Eh(N,U);this.xr=oe,this.getContext=function(){return U},this.getContextAttributes=function(){return U.getContextAttributes()},this.forceContextLoss=function(){let w=qe.get("WEBGL_lose_context");w&&w.loseContext()},this.forceContextRestore=function(){let w=qe.get("WEBGL_lose_context");w&&w.restoreContext()},this.getPixelRatio=function(){return Se},this.setPixelRatio=function(w){w!==void 0&&(Se=w,this.setSize(xe,Ee,!1))},this.getSize=function(w){return w.set(xe,Ee)},this.setSize=function(w,O,K=!0){if(oe.isPresenting){$e("WebGLRenderer: Can't change size while VR device is presenting.");return}xe=w,Ee=O,t.width=Math.floor(w*Se),t.height=Math.floor(O*Se),K===!0&&(t.style.width=w+"px",t.style.height=O+"px"),k!==null&&k.setSize(t.width,t.height),this.setViewport(0,0,w,O)},this.getDrawingBufferSize=function(w){return w.set(xe*Se,Ee*Se).floor()},this.setDrawingBufferSize=function(w,O,K){xe=w,Ee=O,Se=K,t.width=Math.floor(w*K),t.height=Math.floor(O*K),this.setViewport(0,0,w,O)},this.setEffects=function(w){if(b===ni){Qe("WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.");return}if(w){for(let O=0;O<w.length;O++)if(w[O].isOutputPass===!0){$e("WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.");break}}k.setEffects(w||[])},this.getCurrentViewport=function(w){return w.copy(ie)},this.getViewport=function(w){return w.copy(Ve)},this.setViewport=function(w,O,K,X){w.isVector4?Ve.set(w.x,w.y,w.z,w.w):Ve.set(w,O,K,X),Me.viewport(ie.copy(Ve).multiplyScalar(nn()).round())},this.getScissor=function(w){return w.copy(lt)},this.setScissor=function(w,O,K,X){w.isVector4?lt.set(w.x,w.y,w.z,w.w):lt.set(w,O,K,X),Me.scissor(he.copy(lt).multiplyScalar(nn()).round())},this.getScissorTest=function(){return rt},this.setScissorTest=function(w){Me.setScissorTest(rt=w)},this.setOpaqueSort=function(w){He=w},this.setTransparentSort=function(w){nt=w},this.getClearColor=function(w){return w.copy(F.getClearColor())},this.setClearColor=function(){F.setClearColor(...arguments)},this.getClearAlpha=function(){return F.getClearAlpha()},this.setClearAlpha=function(){F.setClearAlpha(...arguments)},this.clear=function(w=!0,O=!0,K=!0){let X=0;if(w){let q=!1;if(le!==null){let Te=le.texture.format;q=m.has(Te)}if(q){let Te=le.texture.type,Pe=p.has(Te),Ae=F.getClearColor(),Ie=F.getClearAlpha(),ze=Ae.r,Ke=Ae.g,ut=Ae.b;Pe?(v[0]=ze,v[1]=Ke,v[2]=ut,v[3]=Ie,U.clearBufferuiv(U.COLOR,0,v)):(E[0]=ze,E[1]=Ke,E[2]=ut,E[3]=Ie,U.clearBufferiv(U.COLOR,0,E))}else X|=U.COLOR_BUFFER_BIT}O&&(X|=U.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),K&&(X|=U.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),X!==0&&U.clear(X)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(w){w.setRenderer(this),G=w},this.dispose=function(){t.removeEventListener("webglcontextlost",Oe,!1),t.removeEventListener("webglcontextrestored",Je,!1),t.removeEventListener("webglcontextcreationerror",Re,!1),F.dispose(),ve.dispose(),ee.dispose(),Xe.dispose(),ke.dispose(),C.dispose(),ce.dispose(),W.dispose(),be.dispose(),Ge.dispose(),re.dispose(),oe.dispose(),oe.removeEventListener("sessionstart",Mo),oe.removeEventListener("sessionend",Li),ji.stop()};function Oe(w){w.preventDefault(),fh("WebGLRenderer: Context Lost."),L=!0}function Je(){fh("WebGLRenderer: Context Restored."),L=!1;let w=Dt.autoReset,O=de.enabled,K=de.autoUpdate,X=de.needsUpdate,q=de.type;Ze(),Dt.autoReset=w,de.enabled=O,de.autoUpdate=K,de.needsUpdate=X,de.type=q}function Re(w){Qe("WebGLRenderer: A WebGL context could not be created. Reason: ",w.statusMessage)}function st(w){let O=w.target;O.removeEventListener("dispose",st),Bt(O)}function Bt(w){Fn(w),ke.remove(w)}function Fn(w){let O=ke.get(w).programs;O!==void 0&&(O.forEach(function(K){re.releaseProgram(K)}),w.isShaderMaterial&&re.releaseShaderCache(w))}this.renderBufferDirect=function(w,O,K,X,q,Te){O===null&&(O=fn);let Pe=q.isMesh&&q.matrixWorld.determinantAffine()<0,Ae=ya(w,O,K,X,q);Me.setMaterial(X,Pe);let Ie=K.index,ze=1;if(X.wireframe===!0){if(Ie=W.getWireframeAttribute(K),Ie===void 0)return;ze=2}let Ke=K.drawRange,ut=K.attributes.position,Be=Ke.start*ze,ht=(Ke.start+Ke.count)*ze;Te!==null&&(Be=Math.max(Be,Te.start*ze),ht=Math.min(ht,(Te.start+Te.count)*ze)),Ie!==null?(Be=Math.max(Be,0),ht=Math.min(ht,Ie.count)):ut!=null&&(Be=Math.max(Be,0),ht=Math.min(ht,ut.count));let qt=ht-Be;if(qt<0||qt===1/0)return;be.setup(q,X,Ae,K,Ie);let Et,Rt=te;if(Ie!==null&&(Et=y.get(Ie),Rt=we,Rt.setIndex(Et)),q.isMesh)X.wireframe===!0?(Me.setLineWidth(X.wireframeLinewidth*nn()),Rt.setMode(U.LINES)):Rt.setMode(U.TRIANGLES);else if(q.isLine){let dn=X.linewidth;dn===void 0&&(dn=1),Me.setLineWidth(dn*nn()),q.isLineSegments?Rt.setMode(U.LINES):q.isLineLoop?Rt.setMode(U.LINE_LOOP):Rt.setMode(U.LINE_STRIP)}else q.isPoints?Rt.setMode(U.POINTS):q.isSprite&&Rt.setMode(U.TRIANGLES);if(q.isBatchedMesh)if(qe.get("WEBGL_multi_draw"))Rt.renderMultiDraw(q._multiDrawStarts,q._multiDrawCounts,q._multiDrawCount);else{let dn=q._multiDrawStarts,Fe=q._multiDrawCounts,sn=q._multiDrawCount,pt=Ie?y.get(Ie).bytesPerElement:1,ts=ke.get(X).currentProgram.getUniforms();for(let rn=0;rn<sn;rn++)ts.setValue(U,"_gl_DrawID",rn),Rt.render(dn[rn]/pt,Fe[rn])}else if(q.isInstancedMesh)Rt.renderInstances(Be,qt,q.count);else if(K.isInstancedBufferGeometry){let dn=K._maxInstanceCount!==void 0?K._maxInstanceCount:1/0,Fe=Math.min(K.instanceCount,dn);Rt.renderInstances(Be,qt,Fe)}else Rt.render(Be,qt)};function _a(w,O,K,X){G!==null&&w.isNodeMaterial&&G.setObject(X,w),Ot===!0&&ne.setState(w,K,!1),w.transparent===!0&&w.side===Hi&&w.forceSinglePass===!1?(w.side=Vn,w.needsUpdate=!0,Di(w,O,X),w.side=Fs,w.needsUpdate=!0,Di(w,O,X),w.side=Hi):Di(w,O,X)}this.compile=function(w,O,K=null){K===null&&(K=w),G!==null&&G.renderStart(w,O,K),A=ee.get(K),A.init(O),T.push(A),K.traverseVisible(function(q){q.isLight&&q.layers.test(O.layers)&&(A.pushLight(q),q.castShadow&&A.pushShadow(q))}),w!==K&&w.traverseVisible(function(q){q.isLight&&q.layers.test(O.layers)&&(A.pushLight(q),q.castShadow&&A.pushShadow(q))}),A.setupLights(),G!==null&&G.updateLights(A.state.lightsArray),tn=this.localClippingEnabled,Ot=ne.init(this.clippingPlanes,tn),Ot===!0&&ne.setGlobalState(this.clippingPlanes,O),G!==null&&de.render(A.state.shadowsArray,K,O);let X=new Set;return w.traverse(function(q){if(!(q.isMesh||q.isPoints||q.isLine||q.isSprite))return;let Te=q.material;if(Te)if(Array.isArray(Te))for(let Pe=0;Pe<Te.length;Pe++){let Ae=Te[Pe];_a(Ae,K,O,q),X.add(Ae)}else _a(Te,K,O,q),X.add(Te)}),A=T.pop(),G!==null&&G.renderEnd(),X},this.compileAsync=function(w,O,K=null){let X=this.compile(w,O,K);return new Promise(q=>{function Te(){if(X.forEach(function(Pe){let Ie=ke.get(Pe).currentProgram;(Ie===void 0||Ie.isReady())&&X.delete(Pe)}),X.size===0){q(w);return}setTimeout(Te,10)}qe.get("KHR_parallel_shader_compile")!==null?Te():setTimeout(Te,10)})};let dr=null;function tu(w){dr&&dr(w)}function Mo(){ji.stop()}function Li(){ji.start()}let ji=new Rp;ji.setAnimationLoop(tu),typeof self<"u"&&ji.setContext(self),this.setAnimationLoop=function(w){dr=w,oe.setAnimationLoop(w),w===null?ji.stop():ji.start()},oe.addEventListener("sessionstart",Mo),oe.addEventListener("sessionend",Li),this.render=function(w,O){if(O!==void 0&&O.isCamera!==!0){Qe("WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(L===!0)return;G!==null&&G.renderStart(w,O);let K=oe.enabled===!0&&oe.isPresenting===!0,X=k!==null&&(le===null||K)&&k.begin(N,le);if(w.matrixWorldAutoUpdate===!0&&w.updateMatrixWorld(),O.parent===null&&O.matrixWorldAutoUpdate===!0&&O.updateMatrixWorld(),oe.enabled===!0&&oe.isPresenting===!0&&(k===null||k.isCompositing()===!1)&&(oe.cameraAutoUpdate===!0&&oe.updateCamera(O),O=oe.getCamera()),w.isScene===!0&&w.onBeforeRender(N,w,O,le),A=ee.get(w,T.length),A.init(O),A.state.textureUnits=Xe.getTextureUnits(),T.push(A),Pt.multiplyMatrices(O.projectionMatrix,O.matrixWorldInverse),O.isArrayCamera?Wt.setFromArrayCamera(O):et.setFromProjectionMatrix(Pt,ui,O.reversedDepth),tn=this.localClippingEnabled,Ot=ne.init(this.clippingPlanes,tn),R=ve.get(w,x.length),R.init(),x.push(R),this.info.render.frame++,oe.enabled===!0&&oe.isPresenting===!0){let Pe=N.xr.getDepthSensingMesh();Pe!==null&&es(Pe,O,-1/0,N.sortObjects)}es(w,O,0,N.sortObjects),R.finish(),G!==null&&G.updateLights(A.state.lightsArray),N.sortObjects===!0&&R.sort(He,nt),$t=oe.enabled===!1||oe.isPresenting===!1||oe.hasDepthSensing()===!1,$t&&F.addToRenderList(R,w),this.info.autoReset===!0&&this.info.reset(),Ot===!0&&ne.beginShadows();let q=A.state.shadowsArray;if(de.render(q,w,O),Ot===!0&&ne.endShadows(),(X&&k.hasRenderPass())===!1){let Pe=R.opaque,Ae=R.transmissive;if(A.setupLights(),O.isArrayCamera){let Ie=O.cameras;if(Ae.length>0)for(let ze=0,Ke=Ie.length;ze<Ke;ze++){let ut=Ie[ze];xi(Pe,Ae,w,ut)}$t&&F.render(w);for(let ze=0,Ke=Ie.length;ze<Ke;ze++){let ut=Ie[ze];xa(R,w,ut,ut.viewport)}}else Ae.length>0&&xi(Pe,Ae,w,O),$t&&F.render(w),xa(R,w,O)}le!==null&&z===0&&(Xe.updateMultisampleRenderTarget(le),Xe.updateRenderTargetMipmap(le)),X&&k.end(N),w.isScene===!0&&w.onAfterRender(N,w,O),be.resetDefaultState(),J=-1,Q=null,T.pop(),T.length>0?(A=T[T.length-1],Xe.setTextureUnits(A.state.textureUnits),Ot===!0&&ne.setGlobalState(N.clippingPlanes,A.state.camera)):A=null,x.pop(),x.length>0?R=x[x.length-1]:R=null,G!==null&&G.renderEnd()};function es(w,O,K,X){if(w.visible===!1)return;if(w.layers.test(O.layers)){if(w.isGroup)K=w.renderOrder;else if(w.isLOD)w.autoUpdate===!0&&w.update(O);else if(w.isLight)A.pushLight(w),w.castShadow&&A.pushShadow(w);else if(w.isSprite){let Pe=O.isArrayCamera?Wt:et;if(!w.frustumCulled||w.intersectsFrustum(Pe)){X&&xt.setFromMatrixPosition(w.matrixWorld).applyMatrix4(Pt);let Ae=ce.update(w),Ie=w.material;Ie.visible&&R.push(w,Ae,Ie,K,xt.z,null,O)}}else if(w.isMesh||w.isLine||w.isPoints){let Pe=O.isArrayCamera?Wt:et;if(!w.frustumCulled||w.intersectsFrustum(Pe)){let Ae=ce.update(w),Ie=w.material;if(X&&(w.boundingSphere!==void 0?(w.boundingSphere===null&&w.computeBoundingSphere(),xt.copy(w.boundingSphere.center)):(Ae.boundingSphere===null&&Ae.computeBoundingSphere(),xt.copy(Ae.boundingSphere.center)),xt.applyMatrix4(w.matrixWorld).applyMatrix4(Pt)),Array.isArray(Ie)){let ze=Ae.groups;for(let Ke=0,ut=ze.length;Ke<ut;Ke++){let Be=ze[Ke],ht=Ie[Be.materialIndex];ht&&ht.visible&&R.push(w,Ae,ht,K,xt.z,Be,O)}}else Ie.visible&&R.push(w,Ae,Ie,K,xt.z,null,O)}}}let Te=w.children;for(let Pe=0,Ae=Te.length;Pe<Ae;Pe++)es(Te[Pe],O,K,X)}function xa(w,O,K,X){let{opaque:q,transmissive:Te,transparent:Pe}=w;A.setupLightsView(K),Ot===!0&&ne.setGlobalState(N.clippingPlanes,K),X&&Me.viewport(ie.copy(X)),q.length>0&&Zt(q,O,K),Te.length>0&&Zt(Te,O,K),Pe.length>0&&Zt(Pe,O,K),Me.buffers.depth.setTest(!0),Me.buffers.depth.setMask(!0),Me.buffers.color.setMask(!0),Me.setPolygonOffset(!1)}function xi(w,O,K,X){if((K.isScene===!0?K.overrideMaterial:null)!==null)return;if(A.state.transmissionRenderTarget[X.id]===void 0){let Be=qe.has("EXT_color_buffer_half_float")||qe.has("EXT_color_buffer_float");A.state.transmissionRenderTarget[X.id]=new wn(1,1,{generateMipmaps:!0,type:Be?Ln:ni,minFilter:hs,samples:Math.max(4,it.samples),stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,colorSpace:mt.workingColorSpace})}let Te=A.state.transmissionRenderTarget[X.id],Pe=X.viewport||ie;Te.setSize(Pe.z*N.transmissionResolutionScale,Pe.w*N.transmissionResolutionScale);let Ae=N.getRenderTarget(),Ie=N.getActiveCubeFace(),ze=N.getActiveMipmapLevel();N.setRenderTarget(Te),N.getClearColor(j),me=N.getClearAlpha(),me<1&&N.setClearColor(16777215,.5),N.clear(),$t&&F.render(K);let Ke=N.toneMapping;N.toneMapping=Wi;let ut=X.viewport;if(X.viewport!==void 0&&(X.viewport=void 0),A.setupLightsView(X),Ot===!0&&ne.setGlobalState(N.clippingPlanes,X),Zt(w,K,X),Xe.updateMultisampleRenderTarget(Te),Xe.updateRenderTargetMipmap(Te),qe.has("WEBGL_multisampled_render_to_texture")===!1){let Be=!1;for(let ht=0,qt=O.length;ht<qt;ht++){let Et=O[ht],{object:Rt,geometry:dn,material:Fe,group:sn}=Et;if(Fe.side===Hi&&Rt.layers.test(X.layers)){let pt=Fe.side;Fe.side=Vn,Fe.needsUpdate=!0,jt(Rt,K,X,dn,Fe,sn),Fe.side=pt,Fe.needsUpdate=!0,Be=!0}}Be===!0&&(Xe.updateMultisampleRenderTarget(Te),Xe.updateRenderTargetMipmap(Te))}N.setRenderTarget(Ae,Ie,ze),N.setClearColor(j,me),ut!==void 0&&(X.viewport=ut),N.toneMapping=Ke}function Zt(w,O,K){let X=O.isScene===!0?O.overrideMaterial:null;for(let q=0,Te=w.length;q<Te;q++){let Pe=w[q],{object:Ae,geometry:Ie,group:ze}=Pe,Ke=Pe.material;Ke.allowOverride===!0&&X!==null&&(Ke=X),Ae.layers.test(K.layers)&&jt(Ae,O,K,Ie,Ke,ze)}}function jt(w,O,K,X,q,Te){G!==null&&q.isNodeMaterial&&G.setObject(w,q),w.onBeforeRender(N,O,K,X,q,Te),w.modelViewMatrix.multiplyMatrices(K.matrixWorldInverse,w.matrixWorld),w.normalMatrix.getNormalMatrix(w.modelViewMatrix),q.onBeforeRender(N,O,K,X,w,Te),q.transparent===!0&&q.side===Hi&&q.forceSinglePass===!1?(q.side=Vn,q.needsUpdate=!0,N.renderBufferDirect(K,O,X,q,w,Te),q.side=Fs,q.needsUpdate=!0,N.renderBufferDirect(K,O,X,q,w,Te),q.side=Hi):N.renderBufferDirect(K,O,X,q,w,Te),w.onAfterRender(N,O,K,X,q,Te)}function en(w){let O=0;for(let K of w)K.texture!==null&&O++;return O}function Di(w,O,K){O.isScene!==!0&&(O=fn);let X=ke.get(w),q=A.state.lights,Te=A.state.shadowsArray,Pe=q.state.version,Ae=re.getParameters(w,q.state,Te,O,K,A.state.lightProbeGridArray),Ie=re.getProgramCacheKey(Ae),ze=X.programs;X.environment=w.isMeshStandardMaterial||w.isMeshLambertMaterial||w.isMeshPhongMaterial?O.environment:null,X.fog=O.fog;let Ke=w.isMeshStandardMaterial||w.isMeshLambertMaterial&&!w.envMap||w.isMeshPhongMaterial&&!w.envMap;X.envMap=C.get(w.envMap||X.environment,Ke),X.envMapRotation=X.environment!==null&&w.envMap===null?O.environmentRotation:w.envMapRotation,ze===void 0&&(w.addEventListener("dispose",st),ze=new Map,X.programs=ze,X.programVariants=new Map);let ut=ze.get(Ie);if(ut!==void 0){if(X.currentProgram===ut&&X.lightsStateVersion===Pe)return va(w,Ae),ut}else Ae.uniforms=re.getUniforms(w),G!==null&&w.isNodeMaterial&&G.build(w,K,Ae),w.onBeforeCompile(Ae,N),ut=re.acquireProgram(Ae,Ie),ze.set(Ie,ut),X.uniforms=Ae.uniforms;let Be=X.uniforms;return(!w.isShaderMaterial&&!w.isRawShaderMaterial||w.clipping===!0)&&(Be.clippingPlanes=ne.uniform),va(w,Ae),X.needsLights=vs(w),X.lightsStateVersion=Pe,X.needsLights&&(Be.ambientLightColor.value=q.state.ambient,Be.lightProbe.value=q.state.probe,Be.sunLights.value=q.state.sun,Be.sunLightShadows.value=q.state.sunShadow,Be.directionalLights.value=q.state.directional,Be.directionalLightShadows.value=q.state.directionalShadow,Be.spotLights.value=q.state.spot,Be.spotLightShadows.value=q.state.spotShadow,Be.rectAreaLights.value=q.state.rectArea,Be.ltc_1.value=q.state.rectAreaLTC1,Be.ltc_2.value=q.state.rectAreaLTC2,Be.pointLights.value=q.state.point,Be.pointLightShadows.value=q.state.pointShadow,Be.hemisphereLights.value=q.state.hemi,Be.sunShadowMatrix.value=q.state.sunShadowMatrix,Be.sunShadowCascade.value=q.state.sunShadowCascade,Be.directionalShadowMatrix.value=q.state.directionalShadowMatrix,Be.spotLightMatrix.value=q.state.spotLightMatrix,Be.spotLightMap.value=q.state.spotLightMap,Be.pointShadowMatrix.value=q.state.pointShadowMatrix),X.numLightProbeGrids=en(A.state.lightProbeGridArray),X.currentProgram=ut,X.uniformsList=null,ut}function Yn(w,O,K,X,q){let Te=ke.get(w),Pe=Te.currentProgram.id+","+X+","+q,Ae=Te.programVariants.get(Pe);return Ae===void 0?(Ae=Di(w,O,K),Te.programVariants.set(Pe,Ae)):(Te.currentProgram=Ae,Te.uniformsList=null,Te.outputColorSpace=X,Te.toneMapping=q),Ae}function xs(w){if(w.uniformsList===null){let O=w.currentProgram.getUniforms();w.uniformsList=Kr.seqWithValue(O.seq,w.uniforms)}return w.uniformsList}function va(w,O){let K=ke.get(w);K.outputColorSpace=O.outputColorSpace,K.batching=O.batching,K.batchingColor=O.batchingColor,K.instancing=O.instancing,K.instancingColor=O.instancingColor,K.instancingMorph=O.instancingMorph,K.skinning=O.skinning,K.morphTargets=O.morphTargets,K.morphNormals=O.morphNormals,K.morphColors=O.morphColors,K.morphTargetsCount=O.morphTargetsCount,K.numClippingPlanes=O.numClippingPlanes,K.numIntersection=O.numClipIntersection,K.vertexAlphas=O.vertexAlphas,K.vertexTangents=O.vertexTangents,K.toneMapping=O.toneMapping}function ya(w,O,K,X,q){O.isScene!==!0&&(O=fn),Xe.resetTextureUnits();let Te=O.fog,Pe=X.isMeshStandardMaterial||X.isMeshLambertMaterial||X.isMeshPhongMaterial?O.environment:null,Ae=le===null?N.outputColorSpace:le.isXRRenderTarget===!0?le.texture.colorSpace:mt.workingColorSpace,Ie=X.isMeshStandardMaterial||X.isMeshLambertMaterial&&!X.envMap||X.isMeshPhongMaterial&&!X.envMap,ze=C.get(X.envMap||Pe,Ie),Ke=X.vertexColors===!0&&!!K.attributes.color&&K.attributes.color.itemSize===4,ut=!!K.attributes.tangent&&(!!X.normalMap||X.anisotropy>0),Be=!!K.morphAttributes.position,ht=!!K.morphAttributes.normal,qt=!!K.morphAttributes.color,Et=Wi;X.toneMapped&&(le===null||le.isXRRenderTarget===!0)&&(Et=N.toneMapping);let Rt=K.morphAttributes.position||K.morphAttributes.normal||K.morphAttributes.color,dn=Rt!==void 0?Rt.length:0,Fe=ke.get(X),sn=A.state.lights;if(Ot===!0&&(tn===!0||w!==Q)){let Ct=w===Q&&X.id===J;ne.setState(X,w,Ct)}let pt=!1,ts=!1;X.version===Fe.__version?Fe.needsLights&&Fe.lightsStateVersion!==sn.state.version||q.isBatchedMesh&&Fe.batching===!1||!q.isBatchedMesh&&Fe.batching===!0||q.isBatchedMesh&&Fe.batchingColor===!0&&q._colorsTexture===null||q.isBatchedMesh&&Fe.batchingColor===!1&&q._colorsTexture!==null||q.isInstancedMesh&&Fe.instancing===!1||!q.isInstancedMesh&&Fe.instancing===!0||q.isSkinnedMesh&&Fe.skinning===!1||!q.isSkinnedMesh&&Fe.skinning===!0||q.isInstancedMesh&&Fe.instancingColor===!0&&q.instanceColor===null||q.isInstancedMesh&&Fe.instancingColor===!1&&q.instanceColor!==null||q.isInstancedMesh&&Fe.instancingMorph===!0&&q.morphTexture===null||q.isInstancedMesh&&Fe.instancingMorph===!1&&q.morphTexture!==null||Fe.envMap!==ze||X.fog===!0&&Fe.fog!==Te||Fe.numClippingPlanes!==void 0&&(Fe.numClippingPlanes!==ne.numPlanes||Fe.numIntersection!==ne.numIntersection)||Fe.vertexAlphas!==Ke||Fe.vertexTangents!==ut||Fe.morphTargets!==Be||Fe.morphNormals!==ht||Fe.morphColors!==qt||Fe.morphTargetsCount!==dn||Fe.numLightProbeGrids!==en(A.state.lightProbeGridArray)?pt=!0:(Fe.outputColorSpace!==Ae||Fe.toneMapping!==Et)&&(ts=!0):(pt=!0,Fe.__version=X.version);let rn=Fe.currentProgram;(pt===!0||ts===!0)&&(rn=ts===!0?Yn(X,O,q,Ae,Et):Di(X,O,q),G&&X.isNodeMaterial&&G.onUpdateProgram(X,rn,Fe));let gr=!1,Ni=!1,ns=!1,at=rn.getUniforms(),Jt=Fe.uniforms;if(Me.useProgram(rn.program)&&(gr=!0,Ni=!0,ns=!0),X.id!==J&&(J=X.id,Ni=!0),gr||Q!==w){Me.buffers.depth.getReversed()&&w.reversedDepth!==!0&&(w._reversedDepth=!0,w.updateProjectionMatrix()),at.setValue(U,"projectionMatrix",w.projectionMatrix),at.setValue(U,"viewMatrix",w.matrixWorldInverse);let an=at.map.cameraPosition;an!==void 0&&an.setValue(U,xn.setFromMatrixPosition(w.matrixWorld)),it.logarithmicDepthBuffer&&at.setValue(U,"logDepthBufFC",2/(Math.log(w.far+1)/Math.LN2)),(X.isMeshPhongMaterial||X.isMeshToonMaterial||X.isMeshLambertMaterial||X.isMeshBasicMaterial||X.isMeshStandardMaterial||X.isShaderMaterial)&&at.setValue(U,"isOrthographic",w.isOrthographicCamera===!0),Q!==w&&(Q=w,Ni=!0,ns=!0)}if(Fe.needsLights&&(sn.state.sunShadowMap.length>0&&at.setValue(U,"sunShadowMap",sn.state.sunShadowMap,Xe),sn.state.directionalShadowMap.length>0&&at.setValue(U,"directionalShadowMap",sn.state.directionalShadowMap,Xe),sn.state.spotShadowMap.length>0&&at.setValue(U,"spotShadowMap",sn.state.spotShadowMap,Xe),sn.state.pointShadowMap.length>0&&at.setValue(U,"pointShadowMap",sn.state.pointShadowMap,Xe)),q.isSkinnedMesh){at.setOptional(U,q,"bindMatrix"),at.setOptional(U,q,"bindMatrixInverse");let Ct=q.skeleton;Ct&&(Ct.boneTexture===null&&Ct.computeBoneTexture(),at.setValue(U,"boneTexture",Ct.boneTexture,Xe))}q.isBatchedMesh&&(at.setOptional(U,q,"batchingTexture"),at.setValue(U,"batchingTexture",q._matricesTexture,Xe),at.setOptional(U,q,"batchingIdTexture"),at.setValue(U,"batchingIdTexture",q._indirectTexture,Xe),at.setOptional(U,q,"batchingColorTexture"),q._colorsTexture!==null&&at.setValue(U,"batchingColorTexture",q._colorsTexture,Xe));let Un=K.morphAttributes;if((Un.position!==void 0||Un.normal!==void 0||Un.color!==void 0)&&se.update(q,K,rn),(Ni||Fe.receiveShadow!==q.receiveShadow)&&(Fe.receiveShadow=q.receiveShadow,at.setValue(U,"receiveShadow",q.receiveShadow)),(X.isMeshStandardMaterial||X.isMeshLambertMaterial||X.isMeshPhongMaterial)&&X.envMap===null&&O.environment!==null&&(Jt.envMapIntensity.value=O.environmentIntensity),Jt.dfgLUT!==void 0&&(Jt.dfgLUT.value=ub()),Ni){if(at.setValue(U,"toneMappingExposure",N.toneMappingExposure),Fe.needsLights&&pr(Jt,ns),Te&&X.fog===!0&&_e.refreshFogUniforms(Jt,Te),_e.refreshMaterialUniforms(Jt,X,Se,Ee,A.state.transmissionRenderTarget[w.id]),Fe.needsLights&&Fe.numLightProbeGrids>0){let Ct=S,an=0;for(let Cn of A.state.lightProbeGridArray)Cn.texture!==null&&(Ct.textures[an]=Cn.texture,Ct.min[an]=Cn.boundingBox.min,Ct.max[an]=Cn.boundingBox.max,Ct.resolution[an]=Cn.resolution,an++);for(let Cn in Ct)Ct[Cn].length=an;Jt.probesSH.value=Ct.textures,Jt.probesMin.value=Ct.min,Jt.probesMax.value=Ct.max,Jt.probesResolution.value=Ct.resolution}Kr.upload(U,xs(Fe),Jt,Xe)}if(X.isShaderMaterial&&X.uniformsNeedUpdate===!0&&(Kr.upload(U,xs(Fe),Jt,Xe),X.uniformsNeedUpdate=!1),X.isSpriteMaterial&&at.setValue(U,"center",q.center),at.setValue(U,"modelViewMatrix",q.modelViewMatrix),at.setValue(U,"normalMatrix",q.normalMatrix),at.setValue(U,"modelMatrix",q.matrixWorld),X.uniformsGroups!==void 0){let Ct=X.uniformsGroups;for(let an=0,Cn=Ct.length;an<Cn;an++){let wo=Ct[an];Ge.update(wo,rn),Ge.bind(wo,rn)}}return rn}function pr(w,O){w.ambientLightColor.needsUpdate=O,w.lightProbe.needsUpdate=O,w.sunLights.needsUpdate=O,w.sunLightShadows.needsUpdate=O,w.directionalLights.needsUpdate=O,w.directionalLightShadows.needsUpdate=O,w.pointLights.needsUpdate=O,w.pointLightShadows.needsUpdate=O,w.spotLights.needsUpdate=O,w.spotLightShadows.needsUpdate=O,w.rectAreaLights.needsUpdate=O,w.hemisphereLights.needsUpdate=O}function vs(w){return w.isMeshLambertMaterial||w.isMeshToonMaterial||w.isMeshPhongMaterial||w.isMeshStandardMaterial||w.isShadowMaterial||w.isShaderMaterial&&w.lights===!0}this.getActiveCubeFace=function(){return Z},this.getActiveMipmapLevel=function(){return z},this.getRenderTarget=function(){return le},this.setRenderTargetTextures=function(w,O,K){let X=ke.get(w);X.__autoAllocateDepthBuffer=w.resolveDepthBuffer===!1,X.__autoAllocateDepthBuffer===!1&&(X.__useRenderToTexture=!1),ke.get(w.texture).__webglTexture=O,ke.get(w.depthTexture).__webglTexture=X.__autoAllocateDepthBuffer?void 0:K,X.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(w,O){let K=ke.get(w);K.__webglFramebuffer=O,K.__useDefaultFramebuffer=O===void 0},this.setRenderTarget=function(w,O=0,K=0){le=w,Z=O,z=K;let X=null,q=!1,Te=!1;if(w){let Ae=ke.get(w);if(Ae.__useDefaultFramebuffer!==void 0){Me.bindFramebuffer(U.FRAMEBUFFER,Ae.__webglFramebuffer),ie.copy(w.viewport),he.copy(w.scissor),ue=w.scissorTest,Me.viewport(ie),Me.scissor(he),Me.setScissorTest(ue),J=-1;return}else if(Ae.__webglFramebuffer===void 0)Xe.setupRenderTarget(w);else if(Ae.__hasExternalTextures)Xe.rebindTextures(w,ke.get(w.texture).__webglTexture,ke.get(w.depthTexture).__webglTexture);else if(w.depthBuffer){let Ke=w.depthTexture;if(Ae.__boundDepthTexture!==Ke){if(Ke!==null&&ke.has(Ke)&&(w.width!==Ke.image.width||w.height!==Ke.image.height))throw new Error("THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.");Xe.setupDepthRenderbuffer(w)}}let Ie=w.texture;(Ie.isData3DTexture||Ie.isDataArrayTexture||Ie.isCompressedArrayTexture)&&(Te=!0);let ze=ke.get(w).__webglFramebuffer;w.isWebGLCubeRenderTarget?(Array.isArray(ze[O])?X=ze[O][K]:X=ze[O],q=!0):w.samples>0&&Xe.useMultisampledRTT(w)===!1?X=ke.get(w).__webglMultisampledFramebuffer:Array.isArray(ze)?X=ze[K]:X=ze,ie.copy(w.viewport),he.copy(w.scissor),ue=w.scissorTest}else ie.copy(Ve).multiplyScalar(Se).floor(),he.copy(lt).multiplyScalar(Se).floor(),ue=rt;if(K!==0&&(X=H),Me.bindFramebuffer(U.FRAMEBUFFER,X)&&Me.drawBuffers(w,X),Me.viewport(ie),Me.scissor(he),Me.setScissorTest(ue),q){let Ae=ke.get(w.texture);U.framebufferTexture2D(U.FRAMEBUFFER,U.COLOR_ATTACHMENT0,U.TEXTURE_CUBE_MAP_POSITIVE_X+O,Ae.__webglTexture,K)}else if(Te){let Ae=O;for(let Ie=0;Ie<w.textures.length;Ie++){let ze=ke.get(w.textures[Ie]);U.framebufferTextureLayer(U.FRAMEBUFFER,U.COLOR_ATTACHMENT0+Ie,ze.__webglTexture,K,Ae)}}else if(w!==null&&K!==0){let Ae=ke.get(w.texture);U.framebufferTexture2D(U.FRAMEBUFFER,U.COLOR_ATTACHMENT0,U.TEXTURE_2D,Ae.__webglTexture,K)}J=-1};function mr(w){let O=ke.get(w);return(O.__readFormat!==w.format||O.__readType!==w.type)&&(O.__readFormat=w.format,O.__readType=w.type,O.__formatReadable=it.textureFormatReadable(w.format),O.__typeReadable=it.textureTypeReadable(w.type)),O}this.readRenderTargetPixels=function(w,O,K,X,q,Te,Pe,Ae=0){if(!(w&&w.isWebGLRenderTarget)){Qe("WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let Ie=ke.get(w).__webglFramebuffer;if(w.isWebGLCubeRenderTarget&&Pe!==void 0&&(Ie=Ie[Pe],Array.isArray(Ie)&&(Ie=Ie[0])),Ie){Me.bindFramebuffer(U.FRAMEBUFFER,Ie);try{let ze=w.textures[Ae],Ke=ze.format,ut=ze.type;w.textures.length>1&&U.readBuffer(U.COLOR_ATTACHMENT0+Ae);let Be=mr(ze);if(Be.__formatReadable===!1){Qe("WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(Be.__typeReadable===!1){Qe("WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}O>=0&&O<=w.width-X&&K>=0&&K<=w.height-q&&U.readPixels(O,K,X,q,ge.convert(Ke),ge.convert(ut),Te)}finally{let ze=le!==null?ke.get(le).__webglFramebuffer:null;Me.bindFramebuffer(U.FRAMEBUFFER,ze)}}},this.readRenderTargetPixelsAsync=async function(w,O,K,X,q,Te,Pe,Ae=0){if(!(w&&w.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let Ie=ke.get(w).__webglFramebuffer;if(w.isWebGLCubeRenderTarget&&Pe!==void 0&&(Ie=Ie[Pe],Array.isArray(Ie)&&(Ie=Ie[0])),Ie)if(O>=0&&O<=w.width-X&&K>=0&&K<=w.height-q){Me.bindFramebuffer(U.FRAMEBUFFER,Ie);let ze=w.textures[Ae],Ke=ze.format,ut=ze.type;w.textures.length>1&&U.readBuffer(U.COLOR_ATTACHMENT0+Ae);let Be=mr(ze);if(Be.__formatReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(Be.__typeReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let ht=U.createBuffer();U.bindBuffer(U.PIXEL_PACK_BUFFER,ht),U.bufferData(U.PIXEL_PACK_BUFFER,Te.byteLength,U.STREAM_READ),U.readPixels(O,K,X,q,ge.convert(Ke),ge.convert(ut),0),U.bindBuffer(U.PIXEL_PACK_BUFFER,null);let qt=le!==null?ke.get(le).__webglFramebuffer:null;Me.bindFramebuffer(U.FRAMEBUFFER,qt);let Et=U.fenceSync(U.SYNC_GPU_COMMANDS_COMPLETE,0);return U.flush(),await ep(U,Et,4),U.bindBuffer(U.PIXEL_PACK_BUFFER,ht),U.getBufferSubData(U.PIXEL_PACK_BUFFER,0,Te),U.bindBuffer(U.PIXEL_PACK_BUFFER,null),U.deleteBuffer(ht),U.deleteSync(Et),Te}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(w,O=null,K=0){let X=Math.pow(2,-K),q=Math.floor(w.image.width*X),Te=Math.floor(w.image.height*X),Pe=O!==null?O.x:0,Ae=O!==null?O.y:0;Xe.setTexture2D(w,0),U.copyTexSubImage2D(U.TEXTURE_2D,K,0,0,Pe,Ae,q,Te),Me.unbindTexture()},this.copyTextureToTexture=function(w,O,K=null,X=null,q=0,Te=0){let Pe,Ae,Ie,ze,Ke,ut,Be,ht,qt,Et=w.isCompressedTexture?w.mipmaps[Te]:w.image;if(K!==null)Pe=K.max.x-K.min.x,Ae=K.max.y-K.min.y,Ie=K.isBox3?K.max.z-K.min.z:1,ze=K.min.x,Ke=K.min.y,ut=K.isBox3?K.min.z:0;else{let at=Math.pow(2,-q);Pe=Math.floor(Et.width*at),Ae=Math.floor(Et.height*at),w.isDataArrayTexture?Ie=Et.depth:w.isData3DTexture?Ie=Math.floor(Et.depth*at):Ie=1,ze=0,Ke=0,ut=0}X!==null?(Be=X.x,ht=X.y,qt=X.z):(Be=0,ht=0,qt=0);let Rt=ge.convert(O.format),dn=ge.convert(O.type),Fe;O.isData3DTexture?(Xe.setTexture3D(O,0),Fe=U.TEXTURE_3D):O.isDataArrayTexture||O.isCompressedArrayTexture?(Xe.setTexture2DArray(O,0),Fe=U.TEXTURE_2D_ARRAY):(Xe.setTexture2D(O,0),Fe=U.TEXTURE_2D),Me.activeTexture(U.TEXTURE0),Me.pixelStorei(U.UNPACK_FLIP_Y_WEBGL,O.flipY),Me.pixelStorei(U.UNPACK_PREMULTIPLY_ALPHA_WEBGL,O.premultiplyAlpha),Me.pixelStorei(U.UNPACK_ALIGNMENT,O.unpackAlignment);let sn=Me.getParameter(U.UNPACK_ROW_LENGTH),pt=Me.getParameter(U.UNPACK_IMAGE_HEIGHT),ts=Me.getParameter(U.UNPACK_SKIP_PIXELS),rn=Me.getParameter(U.UNPACK_SKIP_ROWS),gr=Me.getParameter(U.UNPACK_SKIP_IMAGES);Me.pixelStorei(U.UNPACK_ROW_LENGTH,Et.width),Me.pixelStorei(U.UNPACK_IMAGE_HEIGHT,Et.height),Me.pixelStorei(U.UNPACK_SKIP_PIXELS,ze),Me.pixelStorei(U.UNPACK_SKIP_ROWS,Ke),Me.pixelStorei(U.UNPACK_SKIP_IMAGES,ut);let Ni=w.isDataArrayTexture||w.isData3DTexture,ns=O.isDataArrayTexture||O.isData3DTexture;if(w.isDepthTexture){let at=ke.get(w),Jt=ke.get(O),Un=ke.get(at.__renderTarget),Ct=ke.get(Jt.__renderTarget);Me.bindFramebuffer(U.READ_FRAMEBUFFER,Un.__webglFramebuffer),Me.bindFramebuffer(U.DRAW_FRAMEBUFFER,Ct.__webglFramebuffer);for(let an=0;an<Ie;an++)Ni&&(U.framebufferTextureLayer(U.READ_FRAMEBUFFER,U.COLOR_ATTACHMENT0,ke.get(w).__webglTexture,q,ut+an),U.framebufferTextureLayer(U.DRAW_FRAMEBUFFER,U.COLOR_ATTACHMENT0,ke.get(O).__webglTexture,Te,qt+an)),U.blitFramebuffer(ze,Ke,ze+Pe,Ke+Ae,Be,ht,Be+Pe,ht+Ae,U.DEPTH_BUFFER_BIT,U.NEAREST);Me.bindFramebuffer(U.READ_FRAMEBUFFER,null),Me.bindFramebuffer(U.DRAW_FRAMEBUFFER,null)}else if(q!==0||w.isRenderTargetTexture||ke.has(w)){let at=ke.get(w),Jt=ke.get(O);Me.bindFramebuffer(U.READ_FRAMEBUFFER,D),Me.bindFramebuffer(U.DRAW_FRAMEBUFFER,V);for(let Un=0;Un<Ie;Un++)Ni?U.framebufferTextureLayer(U.READ_FRAMEBUFFER,U.COLOR_ATTACHMENT0,at.__webglTexture,q,ut+Un):U.framebufferTexture2D(U.READ_FRAMEBUFFER,U.COLOR_ATTACHMENT0,U.TEXTURE_2D,at.__webglTexture,q),ns?U.framebufferTextureLayer(U.DRAW_FRAMEBUFFER,U.COLOR_ATTACHMENT0,Jt.__webglTexture,Te,qt+Un):U.framebufferTexture2D(U.DRAW_FRAMEBUFFER,U.COLOR_ATTACHMENT0,U.TEXTURE_2D,Jt.__webglTexture,Te),q!==0?U.blitFramebuffer(ze,Ke,ze+Pe,Ke+Ae,Be,ht,Be+Pe,ht+Ae,U.COLOR_BUFFER_BIT,U.NEAREST):ns?U.copyTexSubImage3D(Fe,Te,Be,ht,qt+Un,ze,Ke,Pe,Ae):U.copyTexSubImage2D(Fe,Te,Be,ht,ze,Ke,Pe,Ae);Me.bindFramebuffer(U.READ_FRAMEBUFFER,null),Me.bindFramebuffer(U.DRAW_FRAMEBUFFER,null)}else ns?w.isDataTexture||w.isData3DTexture?U.texSubImage3D(Fe,Te,Be,ht,qt,Pe,Ae,Ie,Rt,dn,Et.data):O.isCompressedArrayTexture?U.compressedTexSubImage3D(Fe,Te,Be,ht,qt,Pe,Ae,Ie,Rt,Et.data):U.texSubImage3D(Fe,Te,Be,ht,qt,Pe,Ae,Ie,Rt,dn,Et):w.isDataTexture?U.texSubImage2D(U.TEXTURE_2D,Te,Be,ht,Pe,Ae,Rt,dn,Et.data):w.isCompressedTexture?U.compressedTexSubImage2D(U.TEXTURE_2D,Te,Be,ht,Et.width,Et.height,Rt,Et.data):U.texSubImage2D(U.TEXTURE_2D,Te,Be,ht,Pe,Ae,Rt,dn,Et);Me.pixelStorei(U.UNPACK_ROW_LENGTH,sn),Me.pixelStorei(U.UNPACK_IMAGE_HEIGHT,pt),Me.pixelStorei(U.UNPACK_SKIP_PIXELS,ts),Me.pixelStorei(U.UNPACK_SKIP_ROWS,rn),Me.pixelStorei(U.UNPACK_SKIP_IMAGES,gr),Te===0&&O.generateMipmaps===!0&&O.mipmapsAutoUpdate===!0&&U.generateMipmap(Fe),Me.unbindTexture()},this.initRenderTarget=function(w){ke.get(w).__webglFramebuffer===void 0&&Xe.setupRenderTarget(w)},this.initTexture=function(w){w.isCubeTexture?Xe.setTextureCube(w,0):w.isData3DTexture?Xe.setTexture3D(w,0):w.isDataArrayTexture||w.isCompressedArrayTexture?Xe.setTexture2DArray(w,0):Xe.setTexture2D(w,0),Me.unbindTexture()},this.resetState=function(){Z=0,z=0,le=null,Me.reset(),be.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return ui}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(e){this._outputColorSpace=e;let t=this.getContext();t.drawingBufferColorSpace=mt._getDrawingBufferColorSpace(e),t.unpackColorSpace=mt._getUnpackColorSpace()}};var Wn=class extends Error{},hb={png:"image/png",svg:"image/svg+xml"};function zp(i){let e=i.getElementById("atlas-files"),t=e?.textContent?JSON.parse(e.textContent):null,n=t?fb(t):db,s=async a=>{let o=await n(a);if(!o)throw new Wn(`The atlas's file ${a} is missing. Copy the atlas again, or make it anew.`);return o},r=(a,o)=>{try{return JSON.parse(new TextDecoder().decode(o))}catch{throw new Wn(`The atlas's file ${a} is damaged: it is no JSON. Copy the atlas again, or make it anew.`)}};return{bytes:s,json:async a=>r(a,await s(a)),optionalJson:async a=>{let o=await n(a);return o?r(a,o):null},url:async a=>{let o=hb[a.split(".").pop()??""]??"application/octet-stream";return t?URL.createObjectURL(new Blob([await s(a)],{type:o})):`atlas/${a}`}}}function fb(i){return async e=>{let t=i[e];if(t===void 0)return null;let n=atob(t),s=new Uint8Array(n.length);for(let r=0;r<n.length;r++)s[r]=n.charCodeAt(r);return s}}async function db(i){let e;try{e=await fetch(`atlas/${i.split("/").map(encodeURIComponent).join("/")}`)}catch{throw new Wn(`The atlas's file ${i} cannot be reached. Is the program that serves this page still running?`)}if(e.status===404)return null;if(!e.ok)throw new Wn(`The atlas's file ${i} cannot be read (status ${e.status}).`);return new Uint8Array(await e.arrayBuffer())}var Yt=class extends Error{},pb=20000630,kp=16384;async function Vp(i){try{return await mb(i)}catch(e){throw e instanceof Yt?e:new Yt(e instanceof RangeError?"it ends too early":`it is damaged (${String(e)})`)}}async function mb(i){let e=new DataView(i.buffer,i.byteOffset,i.byteLength);if(e.getUint32(0,!0)!==pb)throw new Yt("it is no EXR image");if(e.getUint32(4,!0)&6656)throw new Yt("it has tiles, deep samples or several parts, which are not read");let t=gb(i,e,8),{channels:n,compression:s,width:r,height:a}=t,l={0:1,2:1,3:16}[s];if(!l)throw new Yt(`its compression (${s}) is not read: ZIP is`);let c=n.reduce((g,b)=>g+b.bytes,0),u=n.map(g=>g.bytes===2?new Uint16Array(r*a):new Float32Array(r*a)),f=Math.ceil(a/l),h=Array.from({length:f},async(g,b)=>{let m=Number(e.getBigUint64(t.end+8*b,!0)),p=e.getInt32(m,!0)-t.top,v=e.getUint32(m+4,!0);if(p<0||p>=a||p%l)throw new Yt("its rows are out of place");let E=Math.min(l,a-p),S=E*r*c,R=i.subarray(m+8,m+8+v);if(R.length<v)throw new Yt("it ends too early");let A=s===0||v===S?R:vb(await xb(R,S));if(A.length!==S)throw new Yt("it is damaged: rows of a wrong length");return yb(A,n,u,{row:p,rows:E,width:r}),E});if((await Promise.all(h)).reduce((g,b)=>g+b,0)!==a)throw new Yt("rows are missing");return{width:r,height:a,channels:n.map(g=>g.name),half:n.every(g=>g.bytes===2),planes:u}}function gb(i,e,t){let n=t,s=()=>{let g=i.indexOf(0,n);if(g<0)throw new Yt("it ends too early");let b=new TextDecoder().decode(i.subarray(n,g));return n=g+1,b},r=[],a=-1,o=[];for(let g=s();g!=="";g=s()){s();let b=e.getUint32(n,!0),m=n+4;if(n=m,g==="channels"?r=_b(e,s,()=>n,p=>n=p):g==="compression"?a=e.getUint8(m):g==="dataWindow"&&(o=[0,4,8,12].map(p=>e.getInt32(m+p,!0))),n=m+b,n>i.length)throw new Yt("it ends too early")}if(!r.length||o.length!==4)throw new Yt("its header lacks what every image has");let[l,c,u,f]=o,[h,d]=[u-l+1,f-c+1];if(!(h>0&&d>0&&h<=kp&&d<=kp))throw new Yt(`its size, ${h} x ${d}, is not that of a table`);return{channels:r,compression:a,width:h,height:d,top:c,end:n}}function _b(i,e,t,n){let s=[];for(let r=e();r!=="";r=e()){let a=i.getUint32(t(),!0);if(a!==1&&a!==2)throw new Yt(`its channel ${r} holds whole numbers`);let o=[i.getUint32(t()+8,!0),i.getUint32(t()+12,!0)];if(o[0]!==1||o[1]!==1)throw new Yt(`its channel ${r} is subsampled`);s.push({name:r,bytes:a===1?2:4}),n(t()+16)}return s}async function xb(i,e){let t=new Blob([i]).stream().pipeThrough(new DecompressionStream("deflate")),n=new Uint8Array(e),s=0,r=t.getReader();for(;;){let{done:a,value:o}=await r.read();if(a)break;if(s+o.length>e)throw new Yt("it is damaged: more data than pixels");n.set(o,s),s+=o.length}if(s!==e)throw new Yt("it is damaged: less data than pixels");return n}function vb(i){for(let n=1;n<i.length;n++)i[n]=i[n-1]+i[n]-128;let e=new Uint8Array(i.length),t=i.length+1>>1;for(let n=0;n<i.length;n++)e[n]=i[n%2?t+(n>>1):n>>1];return e}function yb(i,e,t,{row:n,rows:s,width:r}){let a=new DataView(i.buffer,i.byteOffset,i.byteLength),o=0;for(let l=n;l<n+s;l++)e.forEach(({bytes:c},u)=>{let f=t[u],h=l*r;if(c===2)for(let d=0;d<r;d++,o+=2)f[h+d]=a.getUint16(o,!0);else for(let d=0;d<r;d++,o+=4)f[h+d]=a.getFloat32(o,!0)})}var Gp=new DataView(new ArrayBuffer(4));function Rh(i){Gp.setFloat32(0,i);let e=Gp.getUint32(0),t=e>>>16&32768,n=e>>>23&255,s=e&8388607;if(n===255)return t|31744|(s?512:0);let r=n-127;if(r>15)return t|31744;if(r<-25)return t;let a=s|8388608,o=r>=-14?13:13+(-14-r),l=Math.floor(a/2**o),c=a-l*2**o,u=2**(o-1),f=c>u||c===u&&l%2===1?1:0,h=r>=-14?(r+15-1)*1024:0;return t|h+l+f}function Ch(i){let e=i&32768?-1:1,t=i>>>10&31,n=i&1023;return t===31?n?NaN:e*(1/0):t===0?e*n*2**-24:e*(1024+n)*2**(t-25)}var _c=256,bb=12;function Sb(i){return i===0||!Number.isFinite(i)?1:2**Math.min(127,Math.max(-126,Math.ceil(Math.log2(i))-bb))}function ro(i){let[e,t,n]=i==="ideal"?[0,1,0]:"dielectric"in i?[i.dielectric.n<1?2:1,i.dielectric.n,0]:[2,i.conductor.n,i.conductor.k];return{material:e,index_n:t,index_k:n,permittivity:[t*t-n*n,2*t*n]}}var Xp=i=>i==="vector"?1:0;async function xc(i,e,t,n){let s=`${e}/${t.file}`,r=await i.bytes(s);try{let a=await Vp(r);for(let o of["R","G","B"])if(!a.channels.includes(o))throw new Yt(`it has no channel ${o}`);if(a.width!==n[0]||a.height!==n[1])throw new Yt(`it is ${a.width} x ${a.height} and not ${n[0]} x ${n[1]} texels large`);return a}catch(a){let o=a instanceof Yt?a.message:String(a);throw new Wn(`The atlas's file ${s} is damaged: ${o}. Copy the atlas again, or make it anew.`)}}var so=(i,e)=>i.planes[i.channels.indexOf(e)];function qp(i,e){if(i.every(a=>a instanceof Uint16Array))return{scale:e,bits:i};let t=i.map(a=>a instanceof Uint16Array?Float32Array.from(a,Ch):a),n=0;for(let a of t)for(let o of a)n=Math.max(n,Math.abs(o));let s=Sb(n*e),r=e/s;return{scale:s,bits:t.map(a=>Uint16Array.from(a,o=>Rh(o*r)))}}var Yp=()=>({width:1,height:1,count:1,texels:new Uint16Array(4),scales:new Float32Array(_c)});function $p(i,e,t,n){if(t>_c)throw new Wn(`The atlas has ${t} tables for a specimen; the page takes ${_c}.`);let s=new Uint16Array(4*i*e*t);return{width:i,height:e,count:t,texels:s,scales:new Float32Array(Math.max(n,_c))}}async function Hp(i,e,t,n,s,r){let[a,o]=n,l=$p(a,o,t.length+s,t.length);return await Promise.all(t.map(async(c,u)=>{let f=await xc(i,e,c,n),{scale:h,bits:d}=qp([so(f,"R"),so(f,"G"),so(f,"B")],c.scale);Ph(l,u,d,[0,1,2]),l.scales[u]=h,r()})),l}function Ph(i,e,t,n){let s=i.width*i.height,r=4*s*e;t.forEach((a,o)=>{for(let l=0,c=r+n[o];l<s;l++,c+=4)i.texels[c]=a[l]})}async function Wp(i,e,t,n,s,r){let a=$p(s[0],s[1],Math.ceil(n/4),n);return await Promise.all(t.map(async(o,l)=>{let c=await xc(i,e,o,s);["R","G","B"].forEach((u,f)=>{let h=3*l+f;if(h>=n)return;let{scale:d,bits:g}=qp([so(c,u)],o.scale);Ph(a,Math.floor(h/4),g,[h%4]),a.scales[h]=d}),r()})),a}var Zp=(i,e)=>{let t=so(i,e);return t instanceof Float32Array?t:Float32Array.from(t,Ch)};async function Jp(i,e,t,n){let s=await xc(i,e,t,n),r=new Float32Array(4*n[0]*n[1]);return["R","G","B"].forEach((a,o)=>{Zp(s,a).forEach((l,c)=>r[4*c+o]=l*t.scale)}),{width:n[0],height:n[1],texels:r}}async function Kp(i,e,t){let{tables:n,optics:s,pigment:r}=e,{lobe:a,served:o}=n,l=e.name,c=n.tables.length+(a?1+(a.cross?.patches.length??0):0),u=0,f=()=>t(++u/c),h=[n.u.samples,n.v.samples],[d,g,b]=await Promise.all([Hp(i,l,n.tables,h,o?1:0,f),a?.cross?Hp(i,l,a.cross.patches,[a.cross.u.samples,a.cross.v.samples],0,f):Yp(),a?Jp(i,l,a.coherent,[a.radius.samples,a.t.samples]):{width:1,height:1,texels:new Float32Array(4)}]);if(o){let p=await xc(i,l,o.range,h),v=o.range.scale,E=["R","G","B"].map(S=>Uint16Array.from(Zp(p,S),R=>Rh(R*v)));Ph(d,n.tables.length,E,[0,1,2])}return{params:{basis:n.basis==="taylor"?1:0,table_count:n.tables.length,cross_count:a?.cross?.patches.length??0,...ro(s.material),shadowing:s.shadowing?1:0,radius_max:a?.radius_max??0,restricted:o?1:0,grid_last:(o?.size??h[0])-1,first_column:o?.first[1]??0,first_row:o?.first[0]??0,factor:Xp(s.factor),pigment:r?[...r.xyz_per_sr,1]:[0,0,0,0],table_scales:d.scales,cross_scales:g.scales},tables:d,cross:g,lobe:b}}async function Qp(i,e,t){let{spectral:n,optics:s}=e;if(!n)return null;let r=Math.round(4/n.shortest_nm/(n.xi_per_nm.last-n.xi_per_nm.first)*(n.xi_per_nm.samples-1))+1;if(r!==n.xi_per_nm.samples)throw new Wn(`The spectral tables of ${e.name} do not reach as far as their wavelengths ask for.`);let a=n.lobe?.cross??null,o=n.images.length+(n.lobe?1:0)+(a?.images.length??0),l=0,c=()=>t(++l/o),u=e.name,[f,h,d]=await Promise.all([Wp(i,u,n.images,n.tables,[r,n.eta_per_nm.samples],c),a?Wp(i,u,a.images,a.patches,[a.xi_per_nm.samples,a.eta_per_nm.samples],c):Yp(),n.lobe?Jp(i,u,n.lobe.power,[n.lobe.half_abs_w.samples,1]):{width:1,height:1,texels:new Float32Array(4)}]);return{params:{table_layers:f.count,cross_layers:a?h.count:0,lobe_count:n.lobe?.half_abs_w.samples??0,...ro(s.material),factor:Xp(s.factor),shadowing:s.shadowing?1:0,shortest_nm:n.shortest_nm,lobe_sigma_nm:n.lobe?.sigma_nm??0,cross_radius:a?a.xi_per_nm.last*n.shortest_nm:0,table_scales:f.scales,cross_scales:h.scales},tables:f,cross:h,lobe:d}}function t0(i,e){let t=i.spectral?.dispersion;if(!t)return ro(i.optics.material);let n=Mb(t,e);if(!n)return null;let[s,r]=n;return ro(r===0?{dielectric:{n:s}}:{conductor:{n:s,k:r}})}function Mb({wavelength_nm:i,n:e,k:t},n){let s=i.length-1;if(!(n>=i[0]&&n<=i[s]))return null;let r=0;for(;r<s-1&&i[r+1]<=n;)r++;return[jp(i,e,r,n),jp(i,t,r,n)]}function jp(i,e,t,n){let s=i[t+1]-i[t],r=(n-i[t])/s,a=1-r,[o,l]=[s*e0(i,e,t),s*e0(i,e,t+1)],[c,u]=[e[t],e[t+1]];return c*(1+2*r)*a*a+u*r*r*(3-2*r)+o*r*a*a-l*r*r*a}function e0(i,e,t){let n=u=>(e[u+1]-e[u])/(i[u+1]-i[u]);if(t===0)return n(0);if(t===i.length-1)return n(t-1);let[s,r]=[n(t-1),n(t)];if(s*r<=0)return 0;let[a,o]=[i[t]-i[t-1],i[t+1]-i[t]],[l,c]=[2*o+a,o+2*a];return(l+c)/(l/s+c/r)}var n0=i=>i.json("atlas.json"),i0=(i,e)=>i.json(`${e}/specimen.json`);var wb=[.8566748838545029,.733891856627126,.6287067210378086,.5385972572236101],Tb=.38196601125010515,s0=i=>i-Math.floor(i),ao=(i,e)=>i[0]*e[0]+i[1]*e[1]+i[2]*e[2];function Xn(i){let e=Math.hypot(...i);return[i[0]/e,i[1]/e,i[2]/e]}var Ih=i=>wb.map(e=>s0(.5+e*i));function vc(i,e){return e<=1?[0,0]:[(i+.5)/e,2*Math.PI*s0(Tb*i)]}function r0(i,e){if(e<=1)return[0,0];let[t,n]=Ih(i);return[t-.5,n-.5]}function Ab([i,e,t],n){if(t<-1+1e-12)return[n[0],-n[1],-n[2]];let s=1/(1+t),r=[1-i*i*s,-i*e*s,-i],a=[-i*e*s,1-e*e*s,-e];return[0,1,2].map(o=>n[0]*r[o]+n[1]*a[o]+n[2]*[i,e,t][o])}function yc(i,e,[t,n]){let s=.5*e*Math.PI/180,r=t*2*Math.sin(.5*s)**2,a=Math.sqrt(r*(2-r));return Ab(Xn(i),[a*Math.cos(n),a*Math.sin(n),1-r])}function a0(i,e,t){let n=Xn(i),s=0;for(let r=0;r<t;r++)s+=ao(yc(n,e,vc(r,t)),n);return t/s}var rr=`
in vec3 position;
out vec2 v_clip;
void main() {
  v_clip = position.xy;
  gl_Position = vec4(position.xy, 0.0, 1.0);
}
`,o0=`
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
  out_value = u_output == 1 ? directions : vec4(sum, answered ? 0.0 : 1.0);
}

void shade(Point p) {
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
}
`,Lh=`
float lit(int light) { return 1.0; }
`,Dh=`
in vec2 v_clip;
uniform mat4 u_from_clip;
void camera_ray(out vec3 origin, out vec3 direction) {
  vec4 near = u_from_clip * vec4(v_clip, -1.0, 1.0);
  vec4 far = u_from_clip * vec4(v_clip, 1.0, 1.0);
  origin = near.xyz / near.w;
  direction = normalize(far.xyz / far.w - origin);
}
`;var Nh=Math.PI/180,Fh=.95,Uh={position:[0,0,5],target:[0,0,0],parallel:!0,half:1,near:1,far:9};function Oh({tilt_deg:i}){let[e,t]=[Math.sin(i*Nh),Math.cos(i*Nh)];return{tangent:[1,0,0],bitangent:[0,t,-e],normal:[0,e,t]}}var Eb=1.04;function l0(i){let{tangent:e,bitangent:t}=Oh(i),n=.5*i.width_mm,s=0;for(let a of[-n,n])for(let o of[-n,n]){let l=e.map((u,f)=>a*u+o*t[f]),c=i.distance_mm/(i.distance_mm-l[2]);s=Math.max(s,c*Math.abs(l[0]),c*Math.abs(l[1]))}let{distance_mm:r}=i;return{position:[0,0,r],target:[0,0,0],parallel:!1,half:Eb*s/r,near:.05*r,far:4*r}}var bc={position:[.02,.08,6],target:[.02,.08,0],parallel:!1,half:Math.tan(.5*17.4*Nh),near:3,far:9};var c0=`
${Dh}
${Lh}
void main() {
  vec3 origin, direction;
  camera_ray(origin, direction);
  float along = dot(origin, direction);
  vec3 nearest = origin - along * direction;
  float apart2 = dot(nearest, nearest);
  float radius2 = ${(Fh*Fh).toFixed(8)};
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
`,u0=`
${Dh}
${Lh}
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
`;var h0=`
in vec2 v_clip;
uniform vec2 u_extent;
uniform vec2 u_offset;
vec2 picture_place() { return v_clip * u_extent + u_offset; }
float lit(int light) { return 1.0; }
`,f0=`
${h0}
uniform vec3 u_wi;
void main() {
  vec2 at = picture_place();
  float cos2 = 1.0 - dot(at, at);
  if (cos2 > 0.0) add(0, u_wi, vec3(at, sqrt(cos2)), 1.0);
  finish();
}
`,d0=`
${h0}
uniform vec3 u_sample_normal;
uniform float u_distance;
uniform float u_half_width;
uniform float u_hole_radius;
uniform vec3 u_beam_point;
uniform vec3 u_beam_wi;
uniform float u_beam_power;
void main() {
  vec2 at = picture_place() * u_half_width;
  if (max(abs(at.x), abs(at.y)) <= u_half_width && length(at) >= u_hole_radius) {
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
`;var Sc=Math.PI/180;function jr(i,e){return i>=e?[i/e,1]:[1,e/i]}function ea([i,e,t],n){let[s,r]=[Math.sin(n*Sc),Math.cos(n*Sc)];return[i*r+t*s,e,t*r-i*s]}function p0(i,e,[t,n]){let s=new dt().makeRotationY((e.view.azimuth_deg-e.spin_deg)*Sc).multiply(new dt().makeRotationX(-e.view.elevation_deg*Sc)),r=new Y(...i.target),a=new Y(...i.position).sub(r).applyMatrix4(s),o=new Y(0,1,0).applyMatrix4(s),l=r.clone().add(a),c=new dt().lookAt(l,r,o).setPosition(l),u=i.half/e.view.zoom,f=new dt;if(i.parallel)f.makeOrthographic(-u*t,u*t,u*n,-u*n,i.near,i.far);else{let h=u*i.near;f.makePerspective(-h*t,h*t,h*n,-h*n,i.near,i.far)}return f.multiply(c.invert())}function m0(i,[e,t],n){return new dt().makeScale(n,n,1).multiply(new dt().makeTranslation(-e,-t,0)).multiply(i)}var g0=`#version 300 es

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
    vec4 table_scales[64];
    vec4 cross_scales[64];
};
const uint IDEAL = 0u;
const uint DIELECTRIC = 1u;
const uint CONDUCTOR = 2u;
const uint SCALAR = 0u;
const uint VECTOR = 1u;
const float NO_ANSWER = -1.0;
const float SHORTEST_SLACK = 1e-6;

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
    vec3 sum_2 = (wi_3 + wo_3);
    vec3 m = (sum_2 / vec3(sqrt(dot(sum_2, sum_2))));
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

vec4 next_four(vec4 basis, float x_1) {
    float a_4 = (((2.0 * x_1) * basis.w) - basis.z);
    float b_3 = (((2.0 * x_1) * a_4) - basis.w);
    float c = (((2.0 * x_1) * b_3) - a_4);
    return vec4(a_4, b_3, c, (((2.0 * x_1) * c) - b_3));
}

float expansion(vec2 at_1, float t) {
    vec4 basis_1 = vec4(0.0);
    float sum = 0.0;
    uint layer = 0u;
    vec2 _e4 = texel_centred(at_1, uvec2(textureSize(_group_0_binding_1_fs, 0).xy));
    vec4 _e9 = first_four(((2.0 * t) - 1.0));
    basis_1 = _e9;
    bool loop_init = true;
    while(true) {
        if (!loop_init) {
            uint _e41 = layer;
            layer = (_e41 + 1u);
        }
        loop_init = false;
        uint _e15 = layer;
        uint _e18 = _group_0_binding_0_fs.table_layers;
        if ((_e15 < _e18)) {
        } else {
            break;
        }
        {
            uint _e22 = layer;
            vec4 texel_1 = textureLod(_group_0_binding_1_fs, vec3(_e4, _e22), 0.0);
            float _e25 = sum;
            vec4 _e26 = basis_1;
            uint _e29 = layer;
            vec4 _e31 = _group_0_binding_0_fs.table_scales[_e29];
            sum = (_e25 + dot((_e26 * _e31), texel_1));
            vec4 _e35 = basis_1;
            vec4 _e40 = next_four(_e35, ((2.0 * t) - 1.0));
            basis_1 = _e40;
        }
    }
    float _e44 = sum;
    return _e44;
}

float cross_value(vec3 q_1, float t_1) {
    bool local_2 = false;
    vec4 basis_2 = vec4(0.0);
    float sum_1 = 0.0;
    uint layer_1 = 0u;
    uint _e4 = _group_0_binding_0_fs.cross_layers;
    if (!((_e4 == 0u))) {
        float _e17 = _group_0_binding_0_fs.cross_radius;
        local_2 = (max(abs(q_1.x), abs(q_1.y)) >= _e17);
    } else {
        local_2 = true;
    }
    bool _e20 = local_2;
    if (_e20) {
        return 0.0;
    }
    float _e25 = _group_0_binding_0_fs.cross_radius;
    vec2 _e30 = texel_centred((q_1.xy / vec2(_e25)), uvec2(textureSize(_group_0_binding_2_fs, 0).xy));
    vec4 _e35 = first_four(((2.0 * t_1) - 1.0));
    basis_2 = _e35;
    bool loop_init_1 = true;
    while(true) {
        if (!loop_init_1) {
            uint _e67 = layer_1;
            layer_1 = (_e67 + 1u);
        }
        loop_init_1 = false;
        uint _e41 = layer_1;
        uint _e44 = _group_0_binding_0_fs.cross_layers;
        if ((_e41 < _e44)) {
        } else {
            break;
        }
        {
            uint _e48 = layer_1;
            vec4 texel_2 = textureLod(_group_0_binding_2_fs, vec3(_e30, _e48), 0.0);
            float _e51 = sum_1;
            vec4 _e52 = basis_2;
            uint _e55 = layer_1;
            vec4 _e57 = _group_0_binding_0_fs.cross_scales[_e55];
            sum_1 = (_e51 + dot((_e52 * _e57), texel_2));
            vec4 _e61 = basis_2;
            vec4 _e66 = next_four(_e61, ((2.0 * t_1) - 1.0));
            basis_2 = _e66;
        }
    }
    float _e70 = sum_1;
    return (_e70 / abs(q_1.z));
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
    uint last = (_e3 - 1u);
    float at_2 = (clamp((0.5 * abs_w), 0.0, 1.0) * float(last));
    uint first = min(uint(at_2), (last - 1u));
    float _e17 = power_texel(first);
    float _e20 = power_texel((first + 1u));
    return mix(_e17, _e20, (at_2 - float(first)));
}

float brdf_spectral_with(Front front_5, vec3 wi_10, vec3 wo_10, float wavelength_nm_2) {
    bool local_3 = false;
    bool local_4 = false;
    float shape = 0.0;
    if ((wi_10.z > 0.0)) {
        local_3 = (wo_10.z > 0.0);
    } else {
        local_3 = false;
    }
    bool _e13 = local_3;
    if (!(_e13)) {
        return 0.0;
    }
    float _e18 = _group_0_binding_0_fs.shortest_nm;
    float ratio = (_e18 / wavelength_nm_2);
    if ((ratio > 0.0)) {
        local_4 = (ratio <= 1.000001);
    } else {
        local_4 = false;
    }
    bool _e27 = local_4;
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
    float _e54 = lobe_shape(dot(_e32.xy, _e32.xy), wavelength_nm_2);
    shape = _e54;
    if ((front_5.factor == VECTOR)) {
        float _e59 = shape;
        float _e60 = image_radius2_(wi_10, wo_10);
        float _e61 = lobe_shape(_e60, wavelength_nm_2);
        shape = (_e59 + _e61);
    }
    float _e65 = coherent_factor(front_5, wi_10, wo_10);
    float _e69 = power_at(abs(q_2.z));
    float _e71 = shape;
    return (((r2_ * r2_) * diffuse) + (((r2_ * _e65) * _e69) * _e71));
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

`;var _0=`#version 300 es

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
const uint IDEAL = 0u;
const uint DIELECTRIC = 1u;
const uint CONDUCTOR = 2u;
const uint SCALAR = 0u;
const uint VECTOR = 1u;
const float NO_ANSWER = -1.0;
const uint CHEBYSHEV = 0u;
const uint TAYLOR = 1u;
const float RANGE_SLACK = 0.02;

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
    vec3 sum_2 = (wi_3 + wo_3);
    vec3 m = (sum_2 / vec3(sqrt(dot(sum_2, sum_2))));
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
    float x = ((2.0 * t) - 1.0);
    return Recurrence(1.0, x, (2.0 * x), 1.0);
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

vec3 expansion(Recurrence basis, vec2 at_3) {
    vec3 sum = vec3(0.0, 0.0, 0.0);
    float now = 0.0;
    float next = 0.0;
    uint n = 0u;
    vec2 _e2 = table_place(at_3);
    now = basis.first;
    next = basis.second;
    bool loop_init = true;
    while(true) {
        if (!loop_init) {
            uint _e49 = n;
            n = (_e49 + 1u);
        }
        loop_init = false;
        uint _e14 = n;
        uint _e17 = _group_0_binding_0_fs.table_count;
        if ((_e14 < _e17)) {
        } else {
            break;
        }
        {
            uint _e21 = n;
            vec4 _e23 = textureLod(_group_0_binding_1_fs, vec3(_e2, _e21), 0.0);
            vec3 texel_2 = _e23.xyz;
            vec3 _e25 = sum;
            float _e26 = now;
            uint _e29 = n;
            uint _e33 = n;
            float _e37 = _group_0_binding_0_fs.table_scales[(_e29 / 4u)][(_e33 % 4u)];
            sum = (_e25 + ((_e26 * _e37) * texel_2));
            float _e42 = next;
            float _e45 = now;
            float after = ((basis.forward * _e42) - (basis.back * _e45));
            float _e48 = next;
            now = _e48;
            next = after;
        }
    }
    vec3 _e52 = sum;
    return _e52;
}

vec3 cross_expansion(Recurrence basis_1, vec2 at_4) {
    vec3 sum_1 = vec3(0.0, 0.0, 0.0);
    float now_1 = 0.0;
    float next_1 = 0.0;
    uint n_1 = 0u;
    vec2 _e4 = texel_centred(at_4, uvec2(textureSize(_group_0_binding_2_fs, 0).xy));
    now_1 = basis_1.first;
    next_1 = basis_1.second;
    bool loop_init_1 = true;
    while(true) {
        if (!loop_init_1) {
            uint _e51 = n_1;
            n_1 = (_e51 + 1u);
        }
        loop_init_1 = false;
        uint _e16 = n_1;
        uint _e19 = _group_0_binding_0_fs.cross_count;
        if ((_e16 < _e19)) {
        } else {
            break;
        }
        {
            uint _e23 = n_1;
            vec4 _e25 = textureLod(_group_0_binding_2_fs, vec3(_e4, _e23), 0.0);
            vec3 texel_3 = _e25.xyz;
            vec3 _e27 = sum_1;
            float _e28 = now_1;
            uint _e31 = n_1;
            uint _e35 = n_1;
            float _e39 = _group_0_binding_0_fs.cross_scales[(_e31 / 4u)][(_e35 % 4u)];
            sum_1 = (_e27 + ((_e28 * _e39) * texel_3));
            float _e44 = next_1;
            float _e47 = now_1;
            float after_1 = ((basis_1.forward * _e44) - (basis_1.back * _e47));
            float _e50 = next_1;
            now_1 = _e50;
            next_1 = after_1;
        }
    }
    vec3 _e54 = sum_1;
    return _e54;
}

vec3 cross_value(vec3 q_1, float t_2) {
    bool local_6 = false;
    uint _e4 = _group_0_binding_0_fs.cross_count;
    if (!((_e4 == 0u))) {
        float _e17 = _group_0_binding_0_fs.radius_max;
        local_6 = (max(abs(q_1.x), abs(q_1.y)) >= _e17);
    } else {
        local_6 = true;
    }
    bool _e20 = local_6;
    if (_e20) {
        return vec3(0.0, 0.0, 0.0);
    }
    Recurrence _e25 = shifted_values(t_2);
    float _e29 = _group_0_binding_0_fs.radius_max;
    vec3 _e32 = cross_expansion(_e25, (q_1.xy / vec2(_e29)));
    return (_e32 / vec3(abs(q_1.z)));
}

vec3 sample_(vec2 at_5) {
    ivec2 last = (ivec2(uvec2(textureSize(_group_0_binding_3_fs, 0).xy)).yx - ivec2(1));
    vec2 inside_1 = clamp(at_5, vec2(0.0, 0.0), vec2(last));
    ivec2 first_1 = max(min(ivec2(inside_1), (last - ivec2(1))), ivec2(0, 0));
    ivec2 second = min((first_1 + ivec2(1)), last);
    vec2 share = (inside_1 - vec2(first_1));
    vec4 _e33 = texelFetch(_group_0_binding_3_fs, ivec2(first_1.y, first_1.x), 0);
    vec4 _e40 = texelFetch(_group_0_binding_3_fs, ivec2(second.y, first_1.x), 0);
    vec3 low = mix(_e33.xyz, _e40.xyz, share.y);
    vec4 _e49 = texelFetch(_group_0_binding_3_fs, ivec2(first_1.y, second.x), 0);
    vec4 _e56 = texelFetch(_group_0_binding_3_fs, ivec2(second.y, second.x), 0);
    vec3 high = mix(_e49.xyz, _e56.xyz, share.y);
    return mix(low, high, share.x);
}

vec3 lobe_at(float radius, float w_1) {
    float _e4 = _group_0_binding_0_fs.radius_max;
    if ((radius >= _e4)) {
        return vec3(0.0, 0.0, 0.0);
    }
    vec2 last_1 = (vec2(uvec2(textureSize(_group_0_binding_3_fs, 0).xy)) - vec2(1.0));
    float _e18 = normalised_abs_w(vec3(radius, 0.0, w_1));
    float _e23 = _group_0_binding_0_fs.radius_max;
    vec3 _e28 = sample_(vec2((_e18 * last_1.y), ((radius / _e23) * last_1.x)));
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
    bool local_7 = false;
    float s = 0.0;
    Recurrence basis_2 = Recurrence(0.0, 0.0, 0.0, 0.0);
    if ((wi_12.z > 0.0)) {
        local_7 = (wo_12.z > 0.0);
    } else {
        local_7 = false;
    }
    bool _e11 = local_7;
    if (!(_e11)) {
        return vec3(0.0, 0.0, 0.0);
    }
    vec3 _e17 = wave_vector_change(wi_12, wo_12);
    float _e18 = normalised_abs_w(_e17);
    vec2 at_6 = (0.5 * _e17.xy);
    s = _e18;
    uint _e25 = _group_0_binding_0_fs.restricted;
    if ((_e25 != 0u)) {
        float _e28 = share_of_range(at_6, _e18);
        s = _e28;
        float _e29 = s;
        if ((_e29 < 0.0)) {
            return vec3(-1.0, -1.0, -1.0);
        }
    }
    float _e36 = s;
    Recurrence _e37 = shifted_values(_e36);
    basis_2 = _e37;
    uint _e41 = _group_0_binding_0_fs.basis;
    if ((_e41 == TAYLOR)) {
        Recurrence _e46 = powers(abs(_e17.z));
        basis_2 = _e46;
    }
    Front _e47 = front_factor();
    float _e48 = diffuse_factor(_e47, wi_12, wo_12);
    Recurrence _e49 = basis_2;
    vec3 _e50 = expansion(_e49, at_6);
    vec3 _e51 = cross_value(_e17, _e18);
    vec3 diffuse = (_e48 * (_e50 + _e51));
    vec3 _e54 = coherent_value(wi_12, wo_12, _e17);
    return (diffuse + _e54);
}

bool has_answer(vec3 xyz) {
    bool local_8 = false;
    bool local_9 = false;
    if ((xyz.x == NO_ANSWER)) {
        local_8 = (xyz.y == NO_ANSWER);
    } else {
        local_8 = false;
    }
    bool _e10 = local_8;
    if (_e10) {
        local_9 = (xyz.z == NO_ANSWER);
    } else {
        local_9 = false;
    }
    bool _e17 = local_9;
    return !(_e17);
}

vec3 surface_xyz(vec3 wi_13, vec3 wo_13) {
    bool local_10 = false;
    vec3 _e2 = brdf_xyz(wi_13, wo_13);
    float _e6 = _group_0_binding_0_fs.pigment.w;
    if (!((_e6 == 0.0))) {
        bool _e12 = has_answer(_e2);
        local_10 = !(_e12);
    } else {
        local_10 = true;
    }
    bool _e15 = local_10;
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

`;var oo=["_group_0_binding_0_fs","_group_0_binding_1_fs","_group_0_binding_2_fs","_group_0_binding_3_fs"];function x0(i){let e=i.replace(/^#version.*$/m,"").replace(/layout\(std140\) uniform \w+ \{ (\w+) (\w+); \};/,"uniform $1 $2;").replace(/^(smooth|flat) in .*;$/gm,"").replace(/^layout\(location = \d+\) out .*;$/gm,""),t=e.indexOf("void main()");if(t<0)throw new Error("the translated shader has no entry point");return e.slice(0,t)}var Pb=`
bool answered = true;
vec3 reflected(vec3 wi, vec3 wo) {
  vec3 xyz = surface_xyz(wi, wo);
  if (!has_answer(xyz)) {
    answered = false;
    return vec3(0.0);
  }
  return xyz;
}
`,Ib=`
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
`,Mc={tables:x0(_0)+Pb,spectral:x0(g0)+Ib};var v0=`
uniform sampler2D u_xyz;
uniform sampler2D u_other;
uniform float u_exposure;
uniform int u_mode;
layout(location = 0) out highp vec4 out_value;

const mat3 RGB_FROM_XYZ = mat3(3.2404542, -0.9692660, 0.0556434, -1.5371385, 1.8760108, -0.2040259, -0.4985314, 0.0415560, 1.0572252);
const vec3 LUMINANCE = vec3(0.2126729, 0.7151522, 0.0721750);
const mat3 LMS_FROM_RGB = mat3(0.4122214708, 0.2119034982, 0.0883024619, 0.5363325363, 0.6806995451, 0.2817188376, 0.0514459929, 0.1073969566, 0.6299787005);
const mat3 RGB_FROM_LMS = mat3(4.0767416621, -1.2684380046, -0.0041960863, -3.3077115913, 2.6097574011, -0.7034186147, 0.2309699292, -0.3413193965, 1.7076147010);
const mat3 LAB_FROM_ROOTS = mat3(0.2104542553, 1.9779984951, 0.0259040371, 0.7936177850, -2.4285922050, 0.7827717662, -0.0040720468, 0.4505937099, -0.8086757660);
const float HIGHLIGHT_START = 0.8;

float cube_root(float x) { return sign(x) * pow(abs(x), 1.0 / 3.0); }

// A colour's hue as the change of each cone's root with the saturation, and its saturation; none where negative.
vec4 hue_ray(vec3 rgb) {
  vec3 lms = LMS_FROM_RGB * rgb;
  vec3 lab = LAB_FROM_ROOTS * vec3(cube_root(lms.x), cube_root(lms.y), cube_root(lms.z));
  float chroma = length(lab.yz);
  if (lab.x <= 0.0 || chroma <= 0.0) return vec4(-1.0);
  vec2 ab = lab.yz / chroma;
  vec3 slope = vec3(0.3963377774 * ab.x + 0.2158037573 * ab.y, -0.1055613458 * ab.x - 0.0638541728 * ab.y, -0.0894841775 * ab.x - 1.2914855480 * ab.y);
  return vec4(slope, chroma / lab.x);
}

vec3 on_ray(vec3 slope, float saturation) {
  vec3 root = 1.0 + saturation * slope;
  return RGB_FROM_LMS * (root * root * root);
}

float least(vec3 v) { return min(v.x, min(v.y, v.z)); }
float most(vec3 v) { return max(v.x, max(v.y, v.z)); }

vec3 into_gamut(vec3 rgb) {
  if (least(rgb) >= 0.0) return rgb;
  float target = dot(LUMINANCE, rgb);
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
  return found * (target / dot(LUMINANCE, found));
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
  vec3 rgb = RGB_FROM_XYZ * (value.xyz * u_exposure);
  vec3 shown = u_mode == 1 ? encode(rgb) : encode(roll_off(into_gamut(rgb)));
  // Directions that the tables do not cover: a grey hatch.
  float hatch = step(3.0, mod(gl_FragCoord.x + gl_FragCoord.y, 6.0));
  shown = mix(shown, vec3(0.35 + 0.15 * hatch), clamp(value.a, 0.0, 1.0));
  out_value = vec4(shown, 1.0);
}
`;function Lb(){let i=new di;return i.setAttribute("position",new kn(new Float32Array([-1,-1,0,3,-1,0,-1,3,0]),3)),i}function Us(i,e,t,n=!1){return new Xr({glslVersion:Qa,vertexShader:`precision highp float;
${i}`,fragmentShader:e,uniforms:t,depthTest:n,depthWrite:n})}var $i=class{constructor(e,t=Lb()){this.material=e;let n=new pi(t,e);n.frustumCulled=!1,this.scene.add(n),this.scene.matrixWorldAutoUpdate=!1}material;scene=new Ua;camera=new js;draw(e,t){e.setRenderTarget(t),e.render(this.scene,this.camera)}},y0=`precision highp float;
precision highp int;
precision highp sampler2D;
`,b0=()=>new $i(Us(rr,`${y0}
uniform sampler2D u_before;
uniform sampler2D u_sample;
uniform float u_share;
layout(location = 0) out highp vec4 out_value;
void main() {
  ivec2 at = ivec2(gl_FragCoord.xy);
  out_value = mix(texelFetch(u_before, at, 0), texelFetch(u_sample, at, 0), u_share);
}`,{u_before:{value:null},u_sample:{value:null},u_share:{value:1}})),wc=()=>new $i(Us(rr,`${y0}${v0}`,{u_xyz:{value:null},u_other:{value:null},u_exposure:{value:1},u_mode:{value:0}}));var Tc=Math.PI/180,ta=(i,e,t,n=!1)=>{let s=new wn(i,e,{format:cn,type:t,depthBuffer:n});return s.texture.minFilter=s.texture.magFilter=Mt,s},Ac=(i,e)=>{let t=new wn(i,e,{depthBuffer:!1});return t.texture.minFilter=t.texture.magFilter=Mt,t};function Db(i,e){switch(i.shape){case"ball":return Uh;case"patch":return l0(i.patch);case"snake":return bc;case"model":return e?.view??Uh;case"screen":case"map":return null}}var ps=class i{constructor(e,t){this.renderer=e;this.type=t;this.sums=[ta(1,1,t),ta(1,1,t)],this.sample=ta(1,1,t,!0),this.pixel=ta(1,1,t,!0)}renderer;type;programs=new Map;own={u_output:{value:0},u_active:{value:0},u_lights:{value:1},u_light:{value:Array.from({length:4},()=>new Lt)},u_turn:{value:new ct(1,0)},u_from_clip:{value:new dt},u_to_clip:{value:new dt},u_extent:{value:new ct(1,1)},u_offset:{value:new ct},u_size:{value:new ct(1,1)},u_wi:{value:new Y(0,0,1)},u_tangent:{value:new Y},u_bitangent:{value:new Y},u_normal:{value:new Y},u_half_width:{value:1},u_sample_normal:{value:new Y},u_distance:{value:1},u_hole_radius:{value:1},u_beam_point:{value:new Y},u_beam_wi:{value:new Y},u_beam_power:{value:1}};mean=b0();display=wc();sums;sample;pixel;taken=0;width=1;height=1;get samples(){return this.taken}resize(e,t){if(!(e===this.width&&t===this.height)){[this.width,this.height]=[e,t];for(let n of[...this.sums,this.sample])n.setSize(e,t);this.restart()}}restart(){this.taken=0}static samplesOf(e){let t=e.shape==="screen"||e.lights.some(n=>n.diameter_deg>0);return Math.max(t?e.light_samples:1,e.pixel_samples)}step(e,t,n){let s=i.samplesOf(e),[r,a]=r0(this.taken,e.pixel_samples),o=[2*r/this.width,2*a/this.height];this.prepare(e,t,n,this.taken,s,o,1),this.own.u_output.value=0,this.draw(e,t,n,this.sample);let[l,c]=this.sums;this.mean.material.uniforms.u_before.value=l.texture,this.mean.material.uniforms.u_sample.value=this.sample.texture,this.mean.material.uniforms.u_share.value=1/(this.taken+1),this.mean.draw(this.renderer,c),this.sums=[c,l],this.taken+=1}show(e,t,n,s=null){let r=this.display.material.uniforms;r.u_xyz.value=this.sums[0].texture,r.u_other.value=s?.sums[0].texture??this.sums[0].texture,r.u_exposure.value=e,r.u_mode.value=s?2:t==="clip"?1:0,this.display.draw(this.renderer,n)}values(){let{width:e,height:t}=this,n=new Float32Array(4*e*t);if(this.type===Nt)this.renderer.readRenderTargetPixels(this.sums[0],0,0,e,t,n);else throw new Error("this browser cannot read pictures of floating-point numbers");return lo(n,e,t)}directionsAt(e,t,n,s){let[r,a]=jr(this.width,this.height);this.prepare(e,t,n,-1,1,[s.x/r,s.y/a],this.width),this.own.u_output.value=1,this.draw(e,t,n,this.pixel);let o=new Float32Array(4);this.renderer.readRenderTargetPixels(this.pixel,0,0,1,1,o);let[l,c,u,f]=o;if(l>2)return null;let h=(d,g)=>[d,g,Math.sqrt(Math.max(0,1-d*d-g*g))];return{wi:h(l,c),wo:h(u,f)}}draw(e,t,n,s){n?.drawShadows(this.renderer,this.own),this.own.u_size.value.set(s.width,s.height),this.program(e,t,n).draw(this.renderer,s)}prepare(e,t,n,s,r,a,o){let l=this.own,c=jr(this.width,this.height),u=l.u_light.value;l.u_active.value=e.shape==="map"||e.shape==="screen"?0:e.active,l.u_lights.value=Math.min(e.lights.length,4),e.lights.slice(0,4).forEach((h,d)=>{let[g,b]=S0(h,s,r);u[d].set(...ea(g,-e.spin_deg),b)}),l.u_turn.value.set(Math.cos(e.turn_deg*Tc),Math.sin(e.turn_deg*Tc));let f=Db(e,n);if(f){let h=m0(p0(f,e,c),a,o);l.u_to_clip.value=h,l.u_from_clip.value=h.clone().invert()}l.u_extent.value.set(c[0]/o,c[1]/o),l.u_offset.value.set(a[0]*c[0],a[1]*c[1]),e.shape==="patch"&&this.preparePatch(e),e.shape==="map"&&l.u_wi.value.set(...S0(e.lights[0],s,r)[0]),e.shape==="screen"&&this.prepareScreen(e,s,r)}preparePatch(e){let{tangent:t,bitangent:n,normal:s}=Oh(e.patch);this.own.u_tangent.value.set(...t),this.own.u_bitangent.value.set(...n),this.own.u_normal.value.set(...s),this.own.u_half_width.value=.5*e.patch.width_mm}prepareScreen(e,t,n){let{distance_mm:s,width_mm:r,beam_mm:a,incidence_deg:o}=e.screen,[l,c]=[Math.sin(o*Tc),Math.cos(o*Tc)],u=.5*a,f=e.lights[0],[h,d]=t<0?[0,0]:vc(t,n),[g,b]=[Math.sqrt(h)*Math.cos(d)*u,Math.sqrt(h)*Math.sin(d)*u],[,,m,p]=t<0?[0,0,0,0]:Ih(t),[v,E,S]=yc([0,0,1],f.diameter_deg,[m,2*Math.PI*p]),R=this.own;R.u_sample_normal.value.set(l,0,c),R.u_distance.value=s,R.u_half_width.value=.5*r,R.u_hole_radius.value=u,R.u_beam_point.value.set(g,b,-g*l/c);let A=[c*v-l*S,E,l*v+c*S];R.u_beam_wi.value.set(...A),R.u_beam_power.value=f.irradiance*A[2]*Math.PI*u*u/c}program(e,t,n){let s=`${t.source} ${e.shape} ${e.interpolation}`,r={ball:c0,patch:u0,screen:d0,map:f0},a=this.programs.get(s),o=e.shape==="snake"||e.shape==="model";if(!a){let l=o?n?.fragment:r[e.shape];if(l===void 0)throw new Error(`the shape ${e.shape} is not there yet`);let c=Mc[t.source]+o0+l,u=Us(o?n?.vertex??"":rr,c,{...this.own},o);a=new $i(u,o?n?.geometry:void 0),this.programs.set(s,a)}return Object.assign(a.material.uniforms,t.uniforms,o?n?.uniforms:{}),a}};function S0(i,e,t){return e<0||i.diameter_deg===0?[Xn(i.direction),i.irradiance]:[yc(i.direction,i.diameter_deg,vc(e,t)),i.irradiance*a0(i.direction,i.diameter_deg,t)]}function lo(i,e,t){let n=4*e,s=i.slice();for(let r=0;r<t;r++)s.set(i.subarray(r*n,(r+1)*n),(t-1-r)*n);return s}var Bh=`layout(location = 0) out highp vec4 out_value;
uniform highp sampler2D u_list;
`,Nb=`${Bh}
void main() {
  int i = int(gl_FragCoord.x);
  vec3 f = reflected(texelFetch(u_list, ivec2(i, 0), 0).xyz, texelFetch(u_list, ivec2(i, 1), 0).xyz);
  out_value = vec4(f, answered ? 1.0 : 0.0);
}
`,Fb=`${Bh}
uniform vec3 u_wi;
uniform vec3 u_wo;
void main() {
  vec4 ask = texelFetch(u_list, ivec2(int(gl_FragCoord.x), 0), 0);
  float f = brdf_spectral_with(front_at(ask.yzw), u_wi, u_wo, ask.x / u_structure_scale);
  out_value = vec4(has_answer(f) ? f : 0.0, has_answer(f) ? 1.0 : 0.0, 0.0, 0.0);
}
`,Ub=`${Bh}
uniform vec3 u_wi;
uniform float u_side;
void main() {
  vec2 at = 2.0 * gl_FragCoord.xy / u_side - 1.0;
  float cos2 = 1.0 - dot(at, at);
  vec3 f = cos2 > 0.0 ? reflected(u_wi, vec3(at, sqrt(cos2))) : vec3(0.0);
  out_value = vec4(f, answered ? 0.0 : 1.0);
}
`;function Ob(i,e){let t=new Float32Array(4*e*i.length);i.forEach((s,r)=>t.set(s,4*e*r));let n=new mi(t,e,i.length,cn,Nt);return n.minFilter=n.magFilter=Mt,n.needsUpdate=!0,n}var Ec=class{constructor(e){this.renderer=e}renderer;programs=new Map;targets=new Map;display=wc();own={u_list:{value:null},u_wi:{value:new Y},u_wo:{value:new Y},u_side:{value:1}};brdf(e,t){let n=[t.flatMap(({wi:r})=>[...r,0]),t.flatMap(({wo:r})=>[...r,0])],s=this.list(e,"pairs",Nb,n,t.length);return t.map((r,a)=>s[4*a+3]>.5?[s[4*a],s[4*a+1],s[4*a+2]]:null)}spectrum(e,{wi:t,wo:n},s){this.own.u_wi.value.set(...t),this.own.u_wo.value.set(...n);let r=s.flatMap(({nm:o,index_n:l,index_k:c,material:u})=>[o,l,c,u]),a=this.list(e,"spectrum",Fb,[r],s.length);return Float64Array.from(s,(o,l)=>a[4*l+1]>.5?a[4*l]:NaN)}map(e,t,n,s){this.own.u_wi.value.set(...t),this.own.u_side.value=n;let r=this.target("map",n,n);this.program(e,"map",Ub).draw(this.renderer,r);let a=s??this.exposureOf(r,n,n),o=this.bytes(r,n,n,a);return{pixels:lo(o,n,n),exposure:a}}exposureOf(e,t,n){let s=new Float32Array(4*t*n);return this.renderer.readRenderTargetPixels(e,0,0,t,n,s),zh(s)}bytes(e,t,n,s){let r=this.display.material.uniforms;r.u_xyz.value=e.texture,r.u_other.value=e.texture,r.u_exposure.value=s;let a=this.target("bytes",t,n,!0);this.display.draw(this.renderer,a);let o=new Uint8Array(4*t*n);return this.renderer.readRenderTargetPixels(a,0,0,t,n,o),o}list(e,t,n,s,r){let a=Ob(s,r);this.own.u_list.value=a;let o=this.target(t,r,1);this.program(e,t,n).draw(this.renderer,o);let l=new Float32Array(4*r);return this.renderer.readRenderTargetPixels(o,0,0,r,1,l),a.dispose(),l}target(e,t,n,s=!1){let r=this.targets.get(e);return r||(r=ta(t,n,Nt),s&&(r=Ac(t,n)),this.targets.set(e,r)),(r.width!==t||r.height!==n)&&r.setSize(t,n),r}program(e,t,n){let s=`${e.source} ${t}`,r=this.programs.get(s);return r||(r=new $i(Us(rr,Mc[e.source]+n,{...this.own})),this.programs.set(s,r)),Object.assign(r.material.uniforms,e.uniforms),r}},Bb=.995;function zh(i){let e=[];for(let t=1;t<i.length;t+=4)i[t]>0&&Number.isFinite(i[t])&&e.push(i[t]);return e.length?(e.sort((t,n)=>t-n),1/e[Math.ceil(Bb*e.length)-1]):1}function M0({width:i,height:e,count:t,texels:n}){let s=new Js(n,i,e,t);return s.format=cn,s.type=Ln,s.minFilter=s.magFilter=An,s.wrapS=s.wrapT=ci,s.generateMipmaps=!1,s.needsUpdate=!0,s}function zb({width:i,height:e,texels:t}){let n=new mi(t,i,e,cn,Nt);return n.minFilter=n.magFilter=Mt,n.generateMipmaps=!1,n.needsUpdate=!0,n}var w0=i=>Array.from({length:i.length/4},(e,t)=>new Lt(...i.subarray(4*t,4*t+4)));function kb(i){return{...i,permittivity:new ct(...i.permittivity),..."pigment"in i?{pigment:new Lt(...i.pigment)}:{},table_scales:w0(i.table_scales),cross_scales:w0(i.cross_scales)}}function kh(i){let e=[M0(i.tables),M0(i.cross),zb(i.lobe)],t=[kb(i.params),...e];return{uniforms:Object.fromEntries(oo.map((n,s)=>[n,{value:t[s]}])),dispose:()=>e.forEach(n=>n.dispose())}}var Ei={observerFirstNm:360,observer:[[1299e-7,3917e-9,6061e-7],[145847e-9,4393581e-12,.0006808792],[.0001638021,4929604e-12,.0007651456],[.0001840037,5532136e-12,.0008600124],[.0002066902,6208245e-12,.0009665928],[2321e-7,6965e-9,.001086],[260728e-9,7813219e-12,.001220586],[293075e-9,8767336e-12,.001372729],[329388e-9,9839844e-12,.001543579],[369914e-9,1104323e-11,.001734286],[4149e-7,1239e-8,.001946],[.0004641587,1388641e-11,.002177777],[518986e-9,1555728e-11,.002435809],[581854e-9,1744296e-11,.002731953],[.0006552347,1958375e-11,.003078064],[7416e-7,2202e-8,.003486],[.0008450296,2483965e-11,.003975227],[.0009645268,2804126e-11,.00454088],[.001094949,3153104e-11,.00515832],[.001231154,3521521e-11,.005802907],[.001368,39e-6,.006450001],[.00150205,428264e-10,.007083216],[.001642328,469146e-10,.007745488],[.001802382,515896e-10,.008501152],[.001995757,571764e-10,.009414544],[.002236,64e-6,.01054999],[.002535385,7234421e-11,.0119658],[.002892603,8221224e-11,.01365587],[.003300829,9350816e-11,.01558805],[.003753236,.0001061361,.01773015],[.004243,12e-5,.02005001],[.004762389,134984e-9,.02251136],[.005330048,151492e-9,.02520288],[.005978712,170208e-9,.02827972],[.006741117,191816e-9,.03189704],[.00765,217e-6,.03621],[.008751373,.0002469067,.04143771],[.01002888,28124e-8,.04750372],[.0114217,31852e-8,.05411988],[.01286901,.0003572667,.06099803],[.01431,396e-6,.06785001],[.01570443,.0004337147,.07448632],[.01714744,473024e-9,.08136156],[.01878122,517876e-9,.08915364],[.02074801,.0005722187,.09854048],[.02319,64e-5,.1102],[.02620736,72456e-8,.1246133],[.02978248,8255e-7,.1417017],[.03388092,94116e-8,.1613035],[.03846824,.00106988,.1832568],[.04351,.00121,.2074],[.0489956,.001362091,.2336921],[.0550226,.001530752,.2626114],[.0617188,.001720368,.2947746],[.069212,.001935323,.3307985],[.07763,.00218,.3713],[.08695811,.0024548,.4162091],[.09717672,.002764,.4654642],[.1084063,.0031178,.5196948],[.1207672,.0035264,.5795303],[.13438,.004,.6456],[.1493582,.00454624,.7184838],[.1653957,.00515932,.7967133],[.1819831,.00582928,.8778459],[.198611,.00654616,.959439],[.21477,.0073,1.0390501],[.2301868,.008086507,1.1153673],[.2448797,.00890872,1.1884971],[.2587773,.00976768,1.2581233],[.2718079,.01066443,1.3239296],[.2839,.0116,1.3856],[.2949438,.01257317,1.4426352],[.3048965,.01358272,1.4948035],[.3137873,.01462968,1.5421903],[.3216454,.01571509,1.5848807],[.3285,.01684,1.62296],[.3343513,.01800736,1.6564048],[.3392101,.01921448,1.6852959],[.3431213,.02045392,1.7098745],[.3461296,.02171824,1.7303821],[.34828,.023,1.74706],[.3495999,.02429461,1.7600446],[.3501474,.02561024,1.7696233],[.350013,.02695857,1.7762637],[.349287,.02835125,1.7804334],[.34806,.0298,1.7826],[.3463733,.03131083,1.7829682],[.3442624,.03288368,1.7816998],[.3418088,.03452112,1.7791982],[.3390941,.03622571,1.7758671],[.3362,.038,1.77211],[.3331977,.03984667,1.7682589],[.3300411,.041768,1.764039],[.3266357,.043766,1.7589438],[.3228868,.04584267,1.7524663],[.3187,.048,1.7441],[.3140251,.05024368,1.7335595],[.308884,.05257304,1.7208581],[.3032904,.05498056,1.7059369],[.2972579,.05745872,1.6887372],[.2908,.06,1.6692],[.2839701,.06260197,1.6475287],[.2767214,.06527752,1.6234127],[.2689178,.06804208,1.5960223],[.2604227,.07091109,1.564528],[.2511,.0739,1.5281],[.2408475,.077016,1.4861114],[.2298512,.0802664,1.4395215],[.2184072,.0836668,1.3898799],[.2068115,.0872328,1.3387362],[.19536,.09098,1.28764],[.1842136,.09491755,1.2374223],[.1733273,.09904584,1.1878243],[.1626881,.1033674,1.1387611],[.1522833,.1078846,1.090148],[.1421,.1126,1.0419],[.1321786,.117532,.9941976],[.1225696,.1226744,.9473473],[.1132752,.1279928,.9014531],[.1042979,.1334528,.8566193],[.09564,.13902,.8129501],[.08729955,.1446764,.7705173],[.07930804,.1504693,.7294448],[.07171776,.1564619,.6899136],[.06458099,.1627177,.6521049],[.05795001,.1693,.6162],[.05186211,.1762431,.5823286],[.04628152,.1835581,.5504162],[.04115088,.1912735,.5203376],[.03641283,.199418,.4919673],[.03201,.20802,.46518],[.0279172,.2171199,.4399246],[.0241444,.2267345,.4161836],[.020687,.2368571,.3938822],[.0175404,.2474812,.3729459],[.0147,.2586,.3533],[.01216179,.2701849,.3348578],[.00991996,.2822939,.3175521],[.00796724,.2950505,.3013375],[.006296346,.308578,.2861686],[.0049,.323,.272],[.003777173,.3384021,.2588171],[.00294532,.3546858,.2464838],[.00242488,.3716986,.2347718],[.002236293,.3892875,.2234533],[.0024,.4073,.2123],[.00292552,.4256299,.2011692],[.00383656,.4443096,.1901196],[.00517484,.4633944,.1792254],[.00698208,.4829395,.1685608],[.0093,.503,.1582],[.01214949,.5235693,.1481383],[.01553588,.544512,.1383758],[.01947752,.56569,.1289942],[.02399277,.5869653,.1200751],[.0291,.6082,.1117],[.03481485,.6293456,.1039048],[.04112016,.6503068,.09666748],[.04798504,.6708752,.08998272],[.05537861,.6908424,.08384531],[.06327,.71,.07824999],[.07163501,.7281852,.07320899],[.08046224,.7454636,.06867816],[.08973996,.7619694,.06456784],[.09945645,.7778368,.06078835],[.1096,.7932,.05725001],[.1201674,.8081104,.05390435],[.1311145,.8224962,.05074664],[.1423679,.8363068,.04775276],[.1538542,.8494916,.04489859],[.1655,.862,.04216],[.1772571,.8738108,.03950728],[.18914,.8849624,.03693564],[.2011694,.8954936,.03445836],[.2133658,.9054432,.03208872],[.2257499,.9148501,.02984],[.2383209,.9237348,.02771181],[.2510668,.9320924,.02569444],[.2639922,.9399226,.02378716],[.2771017,.9472252,.02198925],[.2904,.954,.0203],[.3038912,.9602561,.01871805],[.3175726,.9660074,.01724036],[.3314384,.9712606,.01586364],[.3454828,.9760225,.01458461],[.3597,.9803,.0134],[.3740839,.9840924,.01230723],[.3886396,.9874182,.01130188],[.4033784,.9903128,.01037792],[.4183115,.9928116,.009529306],[.4334499,.9949501,.008749999],[.4487953,.9967108,.0080352],[.464336,.9980983,.0073816],[.480064,.999112,.0067854],[.4959713,.9997482,.0062428],[.5120501,1,.005749999],[.5282959,.9998567,.0053036],[.5446916,.9993046,.0048998],[.5612094,.9983255,.0045342],[.5778215,.9968987,.0042024],[.5945,.995,.0039],[.6112209,.9926005,.0036232],[.6279758,.9897426,.0033706],[.6447602,.9864444,.0031414],[.6615697,.9827241,.0029348],[.6784,.9786,.002749999],[.6952392,.9740837,.0025852],[.7120586,.9691712,.0024386],[.7288284,.9638568,.0023094],[.7455188,.9581349,.0021968],[.7621,.952,.0021],[.7785432,.9454504,.002017733],[.7948256,.9384992,.0019482],[.8109264,.9311628,.0018898],[.8268248,.9234576,.001840933],[.8425,.9154,.0018],[.8579325,.9070064,.001766267],[.8730816,.8982772,.0017378],[.8878944,.8892048,.0017112],[.9023181,.8797816,.001683067],[.9163,.87,.001650001],[.9297995,.8598613,.001610133],[.9427984,.849392,.0015644],[.9552776,.838622,.0015136],[.9672179,.8275813,.001458533],[.9786,.8163,.0014],[.9893856,.8047947,.001336667],[.9995488,.793082,.00127],[1.0090892,.781192,.001205],[1.0180064,.7691547,.001146667],[1.0263,.757,.0011],[1.0339827,.7447541,.0010688],[1.040986,.7324224,.0010494],[1.047188,.7200036,.0010356],[1.0524667,.7074965,.0010212],[1.0567,.6949,.001],[1.0597944,.6822192,96864e-8],[1.0617992,.6694716,92992e-8],[1.0628068,.6566744,88688e-8],[1.0629096,.6438448,84256e-8],[1.0622,.631,8e-4],[1.0607352,.6181555,76096e-8],[1.0584436,.6053144,72368e-8],[1.0552244,.5924756,68592e-8],[1.0509768,.5796379,64544e-8],[1.0456,.5668,6e-4],[1.0390369,.5539611,.0005478667],[1.0313608,.5411372,4916e-7],[1.0226662,.5283528,4354e-7],[1.0130477,.5156323,.0003834667],[1.0026,.503,34e-5],[.9913675,.4904688,.0003072533],[.9793314,.4780304,28316e-8],[.9664916,.4656776,26544e-8],[.9528479,.4534032,.0002518133],[.9384,.4412,24e-5],[.923194,.42908,.0002295467],[.907244,.417036,22064e-8],[.890502,.405032,21196e-8],[.87292,.393032,.0002021867],[.8544499,.381,19e-5],[.835084,.3689184,.0001742133],[.814946,.3568272,15564e-8],[.794186,.3447768,13596e-8],[.772954,.3328176,.0001168533],[.7514,.321,1e-4],[.7295836,.3093381,8613333e-11],[.7075888,.2978504,746e-7],[.6856022,.2865936,65e-6],[.6638104,.2756245,5693333e-11],[.6424,.265,4999999e-11],[.6215149,.2547632,4416e-8],[.6011138,.2448896,3948e-8],[.5811052,.2353344,3572e-8],[.5613977,.2260528,3264e-8],[.5419,.217,3e-5],[.5225995,.2081616,2765333e-11],[.5035464,.1995488,2556e-8],[.4847436,.1911552,2364e-8],[.4661939,.1829744,2181333e-11],[.4479,.175,2e-5],[.4298613,.1672235,1813333e-11],[.412098,.1596464,162e-7],[.394644,.1522776,142e-7],[.3775333,.1451259,1213333e-11],[.3608,.1382,1e-5],[.3444563,.1315003,7733333e-12],[.3285168,.1250248,54e-7],[.3130192,.1187792,32e-7],[.2980011,.1127691,1333333e-12],[.2835,.107,0],[.2695448,.1014762,0],[.2561184,.09618864,0],[.2431896,.09112296,0],[.2307272,.08626485,0],[.2187,.0816,0],[.2070971,.07712064,0],[.1959232,.07282552,0],[.1851708,.06871008,0],[.1748323,.06476976,0],[.1649,.061,0],[.1553667,.05739621,0],[.14623,.05395504,0],[.13749,.05067376,0],[.1291467,.04754965,0],[.1212,.04458,0],[.1136397,.04175872,0],[.106465,.03908496,0],[.09969044,.03656384,0],[.09333061,.03420048,0],[.0874,.032,0],[.08190096,.02996261,0],[.07680428,.02807664,0],[.07207712,.02632936,0],[.06768664,.02470805,0],[.0636,.0232,0],[.05980685,.02180077,0],[.05628216,.02050112,0],[.05297104,.01928108,0],[.04981861,.01812069,0],[.04677,.017,0],[.04378405,.01590379,0],[.04087536,.01483718,0],[.03807264,.01381068,0],[.03540461,.01283478,0],[.0329,.01192,0],[.03056419,.01106831,0],[.02838056,.01027339,0],[.02634484,.009533311,0],[.02445275,.008846157,0],[.0227,.00821,0],[.02108429,.007623781,0],[.01959988,.007085424,0],[.01823732,.006591476,0],[.01698717,.006138485,0],[.01584,.005723,0],[.01479064,.005343059,0],[.01383132,.004995796,0],[.01294868,.004676404,0],[.0121292,.004380075,0],[.01135916,.004102,0],[.01062935,.003838453,0],[.009938846,.003589099,0],[.009288422,.003354219,0],[.008678854,.003134093,0],[.008110916,.002929,0],[.007582388,.002738139,0],[.007088746,.002559876,0],[.006627313,.002393244,0],[.006195408,.002237275,0],[.005790346,.002091,0],[.005409826,.001953587,0],[.005052583,.00182458,0],[.004717512,.00170358,0],[.004403507,.001590187,0],[.004109457,.001484,0],[.003833913,.001384496,0],[.003575748,.001291268,0],[.003334342,.001204092,0],[.003109075,.001122744,0],[.002899327,.001047,0],[.002704348,.0009765896,0],[.00252302,.0009111088,0],[.002354168,.0008501332,0],[.002196616,.0007932384,0],[.00204919,74e-5,0],[.00191096,.0006900827,0],[.001781438,64331e-8,0],[.00166011,599496e-9,0],[.001546459,.0005584547,0],[.001439971,52e-5,0],[.001340042,.0004839136,0],[.001246275,.0004500528,0],[.001158471,.0004183452,0],[.00107643,.0003887184,0],[.0009999493,3611e-7,0],[.0009287358,.0003353835,0],[.0008624332,.0003114404,0],[.0008007503,.0002891656,0],[743396e-9,.0002684539,0],[.0006900786,2492e-7,0],[.0006405156,.0002313019,0],[.0005945021,.0002146856,0],[.0005518646,.0001992884,0],[512429e-9,.0001850475,0],[.0004760213,1719e-7,0],[.0004424536,.0001597781,0],[.0004115117,.0001486044,0],[.0003829814,.0001383016,0],[.0003566491,.0001287925,0],[.0003323011,12e-5,0],[.0003097586,.0001118595,0],[.0002888871,.0001043224,0],[.0002695394,973356e-10,0],[.0002515682,9084587e-11,0],[.0002348261,848e-7,0],[219171e-9,7914667e-11,0],[.0002045258,73858e-9,0],[.0001908405,68916e-9,0],[.0001780654,6430267e-11,0],[.0001661505,6e-5,0],[.0001550236,5598187e-11,0],[.0001446219,522256e-10,0],[.0001349098,487184e-10,0],[125852e-9,4544747e-11,0],[117413e-9,424e-7,0],[.0001095515,3956104e-11,0],[.0001022245,3691512e-11,0],[9539445e-11,3444868e-11,0],[890239e-10,3214816e-11,0],[8307527e-11,3e-5,0],[7751269e-11,2799125e-11,0],[7231304e-11,2611356e-11,0],[6745778e-11,2436024e-11,0],[6292844e-11,2272461e-11,0],[5870652e-11,212e-7,0],[5477028e-11,1977855e-11,0],[5109918e-11,1845285e-11,0],[4767654e-11,1721687e-11,0],[4448567e-11,1606459e-11,0],[4150994e-11,1499e-8,0],[3873324e-11,1398728e-11,0],[3614203e-11,1305155e-11,0],[3372352e-11,1217818e-11,0],[3146487e-11,1136254e-11,0],[2935326e-11,106e-7,0],[2737573e-11,9885877e-12,0],[2552433e-11,9217304e-12,0],[2379376e-11,8592362e-12,0],[221787e-10,8009133e-12,0],[2067383e-11,74657e-10,0],[1927226e-11,6959567e-12,0],[179664e-10,6487995e-12,0],[1674991e-11,6048699e-12,0],[1561648e-11,5639396e-12,0],[1455977e-11,52578e-10,0],[1357387e-11,4901771e-12,0],[1265436e-11,456972e-11,0],[1179723e-11,4260194e-12,0],[1099844e-11,3971739e-12,0],[1025398e-11,37029e-10,0],[9559646e-12,3452163e-12,0],[8912044e-12,3218302e-12,0],[8308358e-12,30003e-10,0],[7745769e-12,2797139e-12,0],[7221456e-12,26078e-10,0],[6732475e-12,243122e-11,0],[6276423e-12,2266531e-12,0],[5851304e-12,2113013e-12,0],[5455118e-12,1969943e-12,0],[5085868e-12,18366e-10,0],[4741466e-12,171223e-11,0],[4420236e-12,1596228e-12,0],[4120783e-12,148809e-11,0],[3841716e-12,1387314e-12,0],[3581652e-12,12934e-10,0],[3339127e-12,120582e-11,0],[3112949e-12,1124143e-12,0],[2902121e-12,1048009e-12,0],[2705645e-12,977058e-12,0],[2522525e-12,91093e-11,0],[2351726e-12,849251e-12,0],[2192415e-12,791721e-12,0],[2043902e-12,73809e-11,0],[1905497e-12,68811e-11,0],[1776509e-12,64153e-11,0],[1656215e-12,59809e-11,0],[1544022e-12,557575e-12,0],[143944e-11,519808e-12,0],[1341977e-12,484612e-12,0],[1251141e-12,45181e-11,0]],stepNm:5,d65FirstNm:300,d65:[.0341,1.6643,3.2945,11.7652,20.236,28.6447,37.0535,38.5011,39.9488,42.4302,44.9117,45.775,46.6383,49.3637,52.0891,51.0323,49.9755,52.3118,54.6482,68.7015,82.7549,87.1204,91.486,92.4589,93.4318,90.057,86.6823,95.7736,104.865,110.936,117.008,117.41,117.812,116.336,114.861,115.392,115.923,112.367,108.811,109.082,109.354,108.578,107.802,106.296,104.79,106.239,107.689,106.047,104.405,104.225,104.046,102.023,100,98.1671,96.3342,96.0611,95.788,92.2368,88.6856,89.3459,90.0062,89.8026,89.5991,88.6489,87.6987,85.4936,83.2886,83.4939,83.6992,81.863,80.0268,80.1207,80.2146,81.2462,82.2778,80.281,78.2842,74.0027,69.7213,70.6652,71.6091,72.979,74.349,67.9765,61.604,65.7448,69.8856,72.4863,75.087,69.3398,63.5927,55.0054,46.4182,56.6118,66.8054,65.0941,63.3828],fluorescentFirstNm:380,fluorescent:[[1.87,2.36,2.94,3.47,5.17,19.49,6.13,6.24,7.01,7.79,8.56,43.67,16.94,10.72,11.35,11.89,12.37,12.75,13,13.15,13.23,13.17,13.13,12.85,12.52,12.2,11.83,11.5,11.22,11.05,11.03,11.18,11.53,27.74,17.05,13.55,14.33,15.01,15.52,18.29,19.55,15.48,14.91,14.15,13.22,12.19,11.12,10.03,8.95,7.96,7.02,6.2,5.42,4.73,4.15,3.64,3.2,2.81,2.47,2.18,1.93,1.72,1.67,1.43,1.29,1.19,1.08,.96,.88,.81,.77,.75,.73,.68,.69,.64,.68,.69,.61,.52,.43],[1.18,1.48,1.84,2.15,3.44,15.69,3.85,3.74,4.19,4.62,5.06,34.98,11.81,6.27,6.63,6.93,7.19,7.4,7.54,7.62,7.65,7.62,7.62,7.45,7.28,7.15,7.05,7.04,7.16,7.47,8.04,8.88,10.01,24.88,16.64,14.59,16.16,17.56,18.62,21.47,22.79,19.29,18.66,17.73,16.54,15.21,13.8,12.36,10.95,9.65,8.4,7.32,6.31,5.43,4.68,4.02,3.45,2.96,2.55,2.19,1.89,1.64,1.53,1.27,1.1,.99,.88,.76,.68,.61,.56,.54,.51,.47,.47,.43,.46,.47,.4,.33,.27],[.82,1.02,1.26,1.44,2.57,14.36,2.7,2.45,2.73,3,3.28,31.85,9.47,4.02,4.25,4.44,4.59,4.72,4.8,4.86,4.87,4.85,4.88,4.77,4.67,4.62,4.62,4.73,4.99,5.48,6.25,7.34,8.78,23.82,16.14,14.59,16.63,18.49,19.95,23.11,24.69,21.41,20.85,19.93,18.67,17.22,15.65,14.04,12.45,10.95,9.51,8.27,7.11,6.09,5.22,4.45,3.8,3.23,2.75,2.33,1.99,1.7,1.55,1.27,1.09,.96,.83,.71,.62,.54,.49,.46,.43,.39,.39,.35,.38,.39,.33,.28,.21],[.57,.7,.87,.98,2.01,13.75,1.95,1.59,1.76,1.93,2.1,30.28,8.03,2.55,2.7,2.82,2.91,2.99,3.04,3.08,3.09,3.09,3.14,3.06,3,2.98,3.01,3.14,3.41,3.9,4.69,5.81,7.32,22.59,15.11,13.88,16.33,18.68,20.64,24.28,26.26,23.28,22.94,22.14,20.91,19.43,17.74,16,14.42,12.56,10.93,9.52,8.18,7.01,6,5.11,4.36,3.69,3.13,2.64,2.24,1.91,1.7,1.39,1.18,1.03,.88,.74,.64,.54,.49,.46,.42,.37,.37,.33,.35,.36,.31,.26,.19],[1.87,2.35,2.92,3.45,5.1,18.91,6,6.11,6.85,7.58,8.31,40.76,16.06,10.32,10.91,11.4,11.83,12.17,12.4,12.54,12.58,12.52,12.47,12.2,11.89,11.61,11.33,11.1,10.96,10.97,11.16,11.54,12.12,27.78,17.73,14.47,15.2,15.77,16.1,18.54,19.5,15.39,14.64,13.72,12.69,11.57,10.45,9.35,8.29,7.32,6.41,5.63,4.9,4.26,3.72,3.25,2.83,2.49,2.19,1.93,1.71,1.52,1.48,1.26,1.13,1.05,.96,.85,.78,.72,.68,.67,.65,.61,.62,.59,.62,.64,.55,.47,.4],[1.05,1.31,1.63,1.9,3.11,14.8,3.43,3.3,3.68,4.07,4.45,32.61,10.74,5.48,5.78,6.03,6.25,6.41,6.52,6.58,6.59,6.56,6.56,6.42,6.28,6.2,6.19,6.3,6.6,7.12,7.94,9.07,10.49,25.22,17.46,15.63,17.22,18.53,19.43,21.97,23.01,19.41,18.56,17.42,16.09,14.64,13.15,11.68,10.25,8.95,7.74,6.69,5.71,4.87,4.16,3.55,3.02,2.57,2.2,1.87,1.6,1.37,1.29,1.05,.91,.81,.71,.61,.54,.48,.44,.43,.4,.37,.38,.35,.39,.41,.33,.26,.21],[2.56,3.18,3.84,4.53,6.15,19.37,7.37,7.05,7.71,8.41,9.15,44.14,17.52,11.35,12,12.58,13.08,13.45,13.71,13.88,13.95,13.93,13.82,13.64,13.43,13.25,13.08,12.93,12.78,12.6,12.44,12.33,12.26,29.52,17.05,12.44,12.58,12.72,12.83,15.46,16.75,12.83,12.67,12.45,12.19,11.89,11.6,11.35,11.12,10.95,10.76,10.42,10.11,10.04,10.02,10.11,9.87,8.65,7.27,6.44,5.83,5.41,5.04,4.57,4.12,3.77,3.46,3.08,2.73,2.47,2.25,2.06,1.9,1.75,1.62,1.54,1.45,1.32,1.17,.99,.81],[1.21,1.5,1.81,2.13,3.17,13.08,3.83,3.45,3.86,4.42,5.09,34.1,12.42,7.68,8.6,9.46,10.24,10.84,11.33,11.71,11.98,12.17,12.28,12.32,12.35,12.44,12.55,12.68,12.77,12.72,12.6,12.43,12.22,28.96,16.51,11.79,11.76,11.77,11.84,14.61,16.11,12.34,12.53,12.72,12.92,13.12,13.34,13.61,13.87,14.07,14.2,14.16,14.13,14.34,14.5,14.46,14,12.58,10.99,9.98,9.22,8.62,8.07,7.39,6.71,6.16,5.63,5.03,4.46,4.02,3.66,3.36,3.09,2.85,2.65,2.51,2.37,2.15,1.89,1.61,1.32],[.9,1.12,1.36,1.6,2.59,12.8,3.05,2.56,2.86,3.3,3.82,32.62,10.77,5.84,6.57,7.25,7.86,8.35,8.75,9.06,9.31,9.48,9.61,9.68,9.74,9.88,10.04,10.26,10.48,10.63,10.78,10.96,11.18,27.71,16.29,12.28,12.74,13.21,13.65,16.57,18.14,14.55,14.65,14.66,14.61,14.5,14.39,14.4,14.47,14.62,14.72,14.55,14.4,14.58,14.88,15.51,15.47,13.2,10.57,9.18,8.25,7.57,7.03,6.35,5.72,5.25,4.8,4.29,3.8,3.43,3.12,2.86,2.64,2.43,2.26,2.14,2.02,1.83,1.61,1.38,1.12],[1.11,.8,.62,.57,1.48,12.16,2.12,2.7,3.74,5.14,6.75,34.39,14.86,10.4,10.76,10.67,10.11,9.27,8.29,7.29,7.91,16.64,16.73,10.44,5.94,3.34,2.35,1.88,1.59,1.47,1.8,5.71,40.98,73.69,33.61,8.24,3.38,2.47,2.14,4.86,11.45,14.79,12.16,8.97,6.52,8.31,44.12,34.55,12.09,12.15,10.52,4.43,1.95,2.19,3.19,2.77,2.29,2,1.52,1.35,1.47,1.79,1.74,1.02,1.14,3.32,4.49,2.05,.49,.24,.21,.21,.24,.24,.21,.17,.21,.22,.17,.12,.09],[.91,.63,.46,.37,1.29,12.68,1.59,1.79,2.46,3.33,4.49,33.94,12.13,6.95,7.19,7.12,6.72,6.13,5.46,4.79,5.66,14.29,14.96,8.97,4.72,2.33,1.47,1.1,.89,.83,1.18,4.9,39.59,72.84,32.61,7.52,2.83,1.96,1.67,4.43,11.28,14.76,12.73,9.74,7.33,9.72,55.27,42.58,13.18,13.16,12.26,5.11,2.07,2.34,3.58,3.01,2.48,2.14,1.54,1.33,1.46,1.94,2,1.2,1.35,4.1,5.58,2.51,.57,.27,.23,.21,.24,.24,.2,.24,.32,.26,.16,.12,.09],[.96,.64,.4,.33,1.19,12.48,1.12,.94,1.08,1.37,1.78,29.05,7.9,2.65,2.71,2.65,2.49,2.33,2.1,1.91,3.01,10.83,11.88,6.88,3.43,1.49,.92,.71,.6,.63,1.1,4.56,34.4,65.4,29.48,7.16,3.08,2.47,2.27,5.09,11.96,15.32,14.27,11.86,9.28,12.31,68.53,53.02,14.67,14.38,14.71,6.46,2.57,2.75,4.18,3.44,2.81,2.42,1.64,1.36,1.49,2.14,2.34,1.42,1.61,5.04,6.98,3.19,.71,.3,.26,.23,.28,.28,.21,.17,.21,.19,.15,.1,.05]]};function T0(i,e,t,n){let s=(n-e)/t;if(!(s>=0&&s<=i.length-1))return 0;let r=Math.min(Math.floor(s),i.length-2);return i[r]+(s-r)*(i[r+1]-i[r])}function na(i){let e=i-Ei.observerFirstNm,t=Ei.observer.length-1;if(!(e>=0&&e<=t))return[0,0,0];let n=Math.min(Math.floor(e),t-1),s=e-n,[r,a]=[Ei.observer[n],Ei.observer[n+1]];return[0,1,2].map(o=>r[o]+s*(a[o]-r[o]))}var Gb=(i,e)=>i**-5/Math.expm1(14387769/(i*e)),Hb=i=>{let e=t=>Math.expm1(1435e4/(2848*t));return 100*(560/i)**5*e(560)/e(i)},Wb=i=>{let e=(t,n,s)=>Math.exp(-.5*((i-t)/(i<t?n:s))**2);return e(450,9,11)+.62*e(560,42,65)},Xb=i=>{let e=1/(Math.sin(i*Math.PI/180)+.50572*(i+6.07995)**-1.6364);return t=>{let n=t/1e3;return Gb(t,5778)*Math.exp(-e*.008735*n**-4.08)*1e15}};function ia(i,e,t){switch(i){case"D65":return{label:"D65, daylight",power:n=>T0(Ei.d65,Ei.d65FirstNm,Ei.stepNm,n)};case"A":return{label:"A, incandescent lamp",power:Hb};case"E":return{label:"E, equal power",power:()=>1};case"F11":return{label:"F11, fluorescent lamp",power:n=>T0(Ei.fluorescent[10],Ei.fluorescentFirstNm,Ei.stepNm,n)};case"LED":return{label:"white LED",power:Wb};case"sun":return{label:`sun ${t}° high`,power:Xb(t)};case"laser":return{label:`laser, ${e} nm`,lines:[{nm:e,power:1}]}}}function Rc(i,[e,t],n){if(i.lines)return A0(i.lines.map(f=>f.nm),i.lines.map(f=>na(f.nm).map(h=>h*f.power)));let s=i.power??(()=>1),[r,a]=[1/t,1/e],o=Array.from({length:n},(f,h)=>1/(r+h/(n-1)*(a-r))),l=o.map(()=>[0,0,0]),c=Math.ceil((t-e)/.25),u=(t-e)/c;for(let f=0;f<c;f++){let h=e+(f+.5)*u,d=(1/h-r)/(a-r)*(n-1),g=Math.min(Math.floor(d),n-2),b=d-g,m=s(h)*u;na(h).forEach((p,v)=>{l[g][v]+=(1-b)*m*p,l[g+1][v]+=b*m*p})}return A0(o,l)}function A0(i,e){let t=e.reduce((n,s)=>n+s[1],0);return{nm:i,weights:e.map(n=>n.map(s=>s/t))}}function E0({sigma_nm:i,half_height_range_nm:e,shortest_nm:t,longest_nm:n},s){let r=Math.SQRT2*2*Math.PI*i*s,a=2*Math.PI*e*2,o=1/t-1/n;return Math.min(1024,Math.max(48,Math.ceil(4/3*o*Math.hypot(r,a))))}var Cc=(1n<<64n)-1n;function qb(i,e){let t=BigInt(i)*0x10000n+BigInt(e)&Cc,n=()=>{t=t+0x9e3779b97f4a7c15n&Cc;let s=t;return s=(s^s>>30n)*0xbf58476d1ce4e5b9n&Cc,s=(s^s>>27n)*0x94d049bb133111ebn&Cc,s^=s>>31n,Number(s>>11n)/2**52-1};return[n(),n()]}function R0(i,e){let t=new Float32Array(2*i*e);for(let s=0;s<i;s++)for(let r=0;r<e;r++)t.set(qb(s,r),2*(s*e+r));let n=new mi(t,e,i,Xi,Nt);return n.minFilter=n.magFilter=Mt,n.needsUpdate=!0,n}var C0=`
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
`;var co=2048,P0=`
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
`,Pc=class{constructor(e,t){this.bounds=t;let n=`in vec3 position;
uniform mat4 u_to_light;
void main() { gl_Position = u_to_light * vec4(position, 1.0); }`;this.pass=new $i(Us(n,`precision highp float;
layout(location = 0) out vec4 out_value;
void main() { out_value = vec4(1.0); }`,{u_to_light:this.clip},!0),e),this.uniforms={u_to_light:{value:Array.from({length:4},()=>new dt)},u_texel:{value:2*t.radius/co}};for(let s=0;s<4;s++)this.uniforms[`u_shadow${s}`]={value:null}}bounds;uniforms;targets=[];drawn=[];pass;clip={value:new dt};draw(e,t){let n=t.u_light.value;for(let s=0;s<t.u_lights.value;s++){let{x:r,y:a,z:o}=n[s],l=`${r} ${a} ${o}`;if(this.drawn[s]===l)continue;this.drawn[s]=l;let c=this.lightClip(new Y(r,a,o));this.uniforms.u_to_light.value[s]=c,this.clip.value=c,this.pass.draw(e,this.target(s))}for(let s=0;s<4;s++)this.uniforms[`u_shadow${s}`].value??=this.targets[0].depthTexture}target(e){if(!this.targets[e]){let t=new Ti(co,co,Nt);t.minFilter=t.magFilter=Mt,this.targets[e]=new wn(co,co,{depthTexture:t}),this.uniforms[`u_shadow${e}`].value=t}return this.targets[e]}lightClip(e){let{centre:t,radius:n}=this.bounds,s=new Y(...t),r=s.clone().addScaledVector(e,2*n),a=Math.abs(e.y)<.9?new Y(0,1,0):new Y(1,0,0),o=new dt().lookAt(r,s,a).setPosition(r);return new dt().makeOrthographic(-n,n,n,-n,n,3*n).multiply(o.invert())}};var Yb=52,Gh=.13,Hh=15,$b=1.5,Zi=1400,Bs=60,Ic=2*Math.PI,ms=(i,e,t)=>[i[0]+t*e[0],i[1]+t*e[1],i[2]+t*e[2]],I0=(i,e)=>[i[1]*e[2]-i[2]*e[1],i[2]*e[0]-i[0]*e[2],i[0]*e[1]-i[1]*e[0]];function Zb(){let i=[];for(let t=0;t<=46;t++){let n=2.3*t/46,s=Ic*n-2.2,r=.83-.215*n;i.push([r*Math.cos(s),.95*r*Math.sin(s),Gh+.17*Math.max(n-.55,0)])}let e=i[i.length-1][2];return i.push([.3,.18,e+.08],[.17,.3,e+.15],[-.02,.29,e+.18],[-.18,.19,e+.17],[-.3,.06,e+.14]),i}function Jb(i,e){let t=Math.min(e*(i.length-3),i.length-3-1e-9),n=Math.floor(t),s=t-n;return[(1-s)**3,3*s**3-6*s*s+4,-3*s**3+3*s*s+3*s+1,s**3].reduce((o,l,c)=>ms(o,i[n+c],l/6),[0,0,0])}function Kb(i){let e=(l,c)=>{let u=Math.min(1,Math.max(0,(i-l)/(c-l)));return u*u*(3-2*u)},n=.7+.3*e(.05,.3),s=.16*(1-e(.022,.052)),r=Math.sqrt(Math.max(0,1-(1-Math.min(i/.03,1))**2)),a=Math.min((1-i)/.33,1),o=(a*(2-a))**.85;return[Gh*(n+s)*r*o,.92-.22*(1-e(.015,.052))]}function Qb(){let i=Zb(),e=Array.from({length:Zi+1},(s,r)=>Jb(i,1-r/Zi)),t=[0];for(let s=1;s<=Zi;s++){let r=ms(e[s],e[s-1],-1);t.push(t[s-1]+Math.hypot(...r))}let n=0;return e.map((s,r)=>{let[a,o]=[Math.max(r-1,0),Math.min(r+1,Zi)],[l,c]=Kb(t[r]/t[Zi]),u=.5*$b*Ic*Math.max(l,.3*Gh)/Hh;return n+=(t[r]-t[a])/u,{centre:s,along:Xn(ms(e[o],e[a],-1)),radius:l,height:c,scales:n}})}function uo(i,e){let t=Xn(ms([0,0,1],i.along,-i.along[2])),n=I0(t,i.along),s=ms(i.centre,t,i.radius*i.height*Math.cos(e));return ms(s,n,i.radius*Math.sin(e))}function Vh([i,e,t]){let n=Yb*Math.PI/180,[s,r]=[Math.sin(n),Math.cos(n)];return[i,e*s+t*r,-e*r+t*s]}function jb(){let i=Qb(),e=(Zi+1)*(Bs+1),t={position:new Float32Array(3*e),normal:new Float32Array(3*e),tangent:new Float32Array(3*e),uv:new Float32Array(2*e)};i.forEach((a,o)=>{let[l,c]=[i[Math.max(o-1,0)],i[Math.min(o+1,Zi)]];for(let u=0;u<=Bs;u++){let f=Ic*u/Bs-Math.PI,h=ms(uo(c,f),uo(l,f),-1),d=ms(uo(a,f+1e-4),uo(a,f-1e-4),-1),g=I0(h,d),b=o===0?[-a.along[0],-a.along[1],-a.along[2]]:a.along,m=Xn(Vh(ao(g,g)>0?g:b)),p=Vh(h),v=ms(p,m,-ao(p,m)),E=o*(Bs+1)+u;t.position.set(Vh(uo(a,f)),3*E),t.normal.set(m,3*E),t.tangent.set(ao(v,v)>0?Xn(v):[0,0,0],3*E),t.uv.set([a.scales,Hh*f/Ic],2*E)}});let n=new Uint32Array(6*Zi*Bs),s=0;for(let a=0;a<Zi;a++)for(let o=0;o<Bs;o++){let[l,c]=[a*(Bs+1)+o,(a+1)*(Bs+1)+o];n.set([l,c,c+1,l,c+1,l+1],s),s+=6}let r=new di;r.setIndex(new kn(n,1));for(let[a,o]of Object.entries(t))r.setAttribute(a,new kn(o,a==="uv"?2:3));return{geometry:r,scaleRings:Math.ceil(i[Zi].scales)+2}}var eS=`
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
`,tS=`
${P0}
${C0}
in vec3 v_normal;
in vec3 v_tangent;
in vec2 v_uv;
uniform mat4 u_from_clip;
uniform vec2 u_size;
void main() {
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
`;function L0(){let{geometry:i,scaleRings:e}=jb(),t=new Pc(i,{centre:[0,.1,0],radius:1.25});return{geometry:i,view:bc,vertex:eS,fragment:tS,uniforms:{...t.uniforms,u_chance:{value:R0(e,Hh)}},drawShadows:(n,s)=>t.draw(n,s)}}var Lc={specimen:"",shape:"ball",lights:[{direction:[.3,.2,1],diameter_deg:.53,irradiance:1}],active:0,view:{azimuth_deg:0,elevation_deg:0,zoom:1},exposure:null,tone:"atlas",illuminant:"tables",laser_nm:633,sun_deg:45,turn_deg:0,spin_deg:0,scale:1,tables:null,difference:!1,interpolation:"bilinear",pigment:!0,patch:{width_mm:20,distance_mm:60,tilt_deg:30},screen:{distance_mm:100,width_mm:200,beam_mm:2,incidence_deg:0},light_samples:16,pixel_samples:16,pointer:{x:-.72,y:0},polar_log:!0,motion:"none",size_px:null},Wh=i=>structuredClone(i);function Xh(i){let e=Wh(Lc),t=i.replace(/^#/,"");if(!t)return e;try{return qh(e,JSON.parse(decodeURIComponent(t)))}catch{return e}}function Dc(i){let e=Object.fromEntries(Object.entries(i).filter(([t,n])=>JSON.stringify(n)!==JSON.stringify(Lc[t])));return Object.keys(e).length?`#${encodeURIComponent(JSON.stringify(e))}`:""}var nS={shape:["ball","snake","patch","screen","map","model"],tone:["atlas","clip"],illuminant:["tables","D65","A","E","F11","LED","laser","sun"],interpolation:["bilinear","cubic"],motion:["none","light","turntable"]},iS={exposure:[-20,30],laser_nm:[380,780],sun_deg:[1,90],turn_deg:[-360,360],spin_deg:[-3600,3600],scale:[.25,4],tables:[1,256],light_samples:[1,1024],pixel_samples:[1,1024],size_px:[1,4096],active:[0,3]};function qh(i,e){let t=Wh(i);for(let[s,r]of Object.entries(e)){if(!(s in Lc))continue;let a=t[s],l=typeof a=="object"&&a!==null&&!Array.isArray(a)&&typeof r=="object"?{...a,...r}:r;sS(s,l)&&(t[s]=Wh(l))}let n=t;return n.active=Math.min(n.active,n.lights.length-1),n}function sS(i,e){if(i==="lights")return rS(e);if(e===null)return i==="exposure"||i==="tables"||i==="size_px";let t=nS[i];if(t)return t.includes(e);let n=iS[i];if(n)return typeof e=="number"&&e>=n[0]&&e<=n[1];let s=Lc[i];return typeof e!=typeof s?!1:typeof e!="object"?!0:Object.keys(s).every(r=>Number.isFinite(e[r]))}function rS(i){return!Array.isArray(i)||i.length<1||i.length>4?!1:i.every(e=>{let{direction:t,diameter_deg:n,irradiance:s}=e??{};return Array.isArray(t)&&t.length===3&&t.every(Number.isFinite)&&Math.hypot(...t)>0&&n>=0&&n<=90&&s>=0&&Number.isFinite(s)})}var sa=class extends Error{},D0=192,Nc=class{constructor(e,t,n){this.files=t;this.state=n;let s=e.getContext("webgl2",{antialias:!1,alpha:!1,powerPreference:"high-performance"});if(!s)throw new sa("This page draws with WebGL 2, which this browser does not offer or has switched off.");if(this.renderer=new pc({canvas:e,context:s}),this.renderer.autoClear=!0,this.renderer.setClearColor(0,0),this.floats=s.getExtension("EXT_color_buffer_float")!==null,!this.floats&&s.getExtension("EXT_color_buffer_half_float")===null)throw new sa("This page sums light in floating-point numbers, which this graphics driver cannot draw to.");this.picture=new ps(this.renderer,this.floats?Nt:Ln),this.probe=new Ec(this.renderer)}files;state;renderer;probe;floats;index;loaded=null;model=null;picture;other=null;meter=null;snake=null;metered=null;quadratureKey="";quadratureUniforms={};get size(){return{width:this.picture.width,height:this.picture.height}}get progress(){return{taken:this.picture.samples,whole:ps.samplesOf(this.state)}}async open(){if(this.index=await n0(this.files),!this.index.specimens?.length)throw new Wn("The atlas holds no specimen.")}viewer=null;viewerFile(){return this.viewer??=this.files.optionalJson("viewer.json").catch(()=>null)}async loadSpecimen(e){let t=this.index.specimens.map(s=>s.name),n=t.includes(this.state.specimen)?this.state.specimen:t[0];if(this.loaded?.specimen.name!==n){let s=await i0(this.files,n),r=await Kp(this.files,s,e);this.unload(),this.loaded={specimen:s,packed:r,tables:kh(r),spectral:null},this.metered=null}this.state.specimen=n,this.restart()}async loadSpectral(e){let t=this.loaded;if(!t)return!1;if(!t.spectral){let n=await Qp(this.files,t.specimen,e);if(!n||this.loaded!==t)return!1;t.spectral={packed:n,uploaded:kh(n)},this.restart()}return!0}unload(){this.loaded?.tables.dispose(),this.loaded?.spectral?.uploaded.dispose(),this.loaded=null,this.quadratureKey=""}set(e){let t=this.state;this.state=qh(t,e);let n=({pointer:s,polar_log:r,motion:a,exposure:o,tone:l,...c})=>JSON.stringify(c);n(t)!==n(this.state)&&this.restart()}restart(){this.picture.restart(),this.other?.restart()}wantsSpectral(){return this.state.illuminant!=="tables"||this.state.scale!==1}light(){let{illuminant:e,laser_nm:t,sun_deg:n,scale:s}=this.state;return e==="tables"?s===1?null:ia("D65",t,n):ia(e,t,n)}evaluated(e=!1){let t=this.loaded;if(!t)return null;let n=e?null:this.state.tables,s=this.light();return s&&t.spectral?{source:"spectral",uniforms:{...this.limited(t.spectral.uploaded,n,!1),...this.quadratureFor(s)}}:{source:"tables",uniforms:this.limited(t.tables,n,this.state.pigment)}}spectralEvaluated(){let e=this.loaded;if(!e?.spectral)return null;let t=this.light()??ia("D65",633,45);return{source:"spectral",uniforms:{...this.limited(e.spectral.uploaded,this.state.tables,!1),...this.quadratureFor(t)}}}quadratureOf(e){let t=this.loaded?.specimen.spectral;return t?Rc(e,[t.shortest_nm,t.longest_nm],E0(t,t.usable_radius)):null}limited({uniforms:e},t,n){let s=e[oo[0]].value,r=s.table_scales.map(o=>o.clone());t!==null&&r.forEach((o,l)=>{for(let c=0;c<4;c++)4*l+c>=t&&o.setComponent(c,0)});let a={...s,table_scales:r};return a.pigment&&!n&&(a.pigment=a.pigment.clone().set(0,0,0,0)),{...e,[oo[0]]:{value:a}}}quadratureFor(e){let t=`${this.loaded?.specimen.name} ${e.label} ${this.state.scale}`;if(t!==this.quadratureKey){let n=this.quadratureOf(e);if(!n)return{};let s=this.asks(n.nm),r=n.nm.length,a=new Float32Array(8*r);n.nm.forEach((l,c)=>{a.set([l,...n.weights[c]],4*c),a.set([s[c].index_n,s[c].index_k,s[c].material,0],4*(r+c))});let o=new mi(a,r,2,cn,Nt);o.minFilter=o.magFilter=Mt,o.needsUpdate=!0,this.quadratureUniforms.u_quadrature?.value?.dispose(),this.quadratureKey=t,this.quadratureUniforms={u_quadrature:{value:o},u_wavelengths:{value:r},u_structure_scale:{value:this.state.scale}}}return this.quadratureUniforms}asks(e){let t=this.loaded?.specimen;return e.map(n=>{let s=t?t0(t,n):null;return{nm:n,material:s?.material??0,index_n:s?.index_n??1,index_k:s?.index_k??0}})}lookups(){let{loaded:e}=this;if(!e)return 0;if(this.light()&&e.spectral){let{table_layers:n,cross_layers:s}=e.spectral.packed.params;return(n+s)*Number(this.quadratureUniforms.u_wavelengths?.value??0)}return e.packed.params.table_count+e.packed.params.restricted}body(){return this.state.shape==="snake"?this.snake??=L0():this.state.shape==="model"?this.model:null}exposure(){let{exposure:e}=this.state;return e===null?this.automatic():Math.PI*2**e}automatic(){let{specimen:e,shape:t,illuminant:n,laser_nm:s,scale:r}=this.state,a=JSON.stringify([e,t,n,s,r]),o=this.evaluated();if(this.metered?.key===a||!o||!this.floats)return this.metered?.exposure??1;this.meter??=new ps(this.renderer,Nt),this.meter.resize(D0,D0),this.meter.restart();let l={...this.state,view:{azimuth_deg:0,elevation_deg:0,zoom:1},light_samples:4,pixel_samples:1};for(let c=0;c<ps.samplesOf(l);c++)this.meter.step(l,o,this.body());return this.metered={key:a,exposure:zh(this.meter.values())},this.metered.exposure}remeter(){this.metered=null}resize(e,t){this.renderer.setSize(e,t,!1),this.picture.resize(e,t),this.other?.resize(e,t)}draw(e){let[t,n]=[this.evaluated(),this.body()];if(!t)return!0;let s=ps.samplesOf(this.state),r=performance.now(),a=this.state.difference&&this.state.tables!==null?this.otherPicture():null;for(;this.picture.samples<s&&(this.picture.step(this.state,t,n),a&&a.step(this.state,this.evaluated(!0)??t,n),!(performance.now()-r>e)););return this.picture.show(this.exposure(),this.state.tone,null,a),this.picture.samples>=s}otherPicture(){return this.other||(this.other=new ps(this.renderer,this.floats?Nt:Ln),this.other.resize(this.picture.width,this.picture.height),this.restart()),this.other}pixels(){let{width:e,height:t}=this.size,n=Ac(e,t),s=this.state.difference&&this.state.tables!==null?this.other:null;this.picture.show(this.exposure(),this.state.tone,n,s);let r=new Uint8Array(4*e*t);return this.renderer.readRenderTargetPixels(n,0,0,e,t,r),n.dispose(),{width:e,height:t,data:lo(r,e,t)}}values(){return{...this.size,data:this.picture.values()}}directions(){let e=this.evaluated();return e&&this.floats?this.picture.directionsAt(this.state,e,this.body(),this.state.pointer):null}};function N0([i,e,t]){return[3.2404542*i-1.5371385*e-.4985314*t,-.969266*i+1.8760108*e+.041556*t,.0556434*i-.2040259*e+1.0572252*t]}var F0=i=>i<=.0031308?12.92*i:1.055*i**(1/2.4)-.055;function Fc(i){if(!(i[1]>0))return"rgb(0, 0, 0)";let e=N0(i.map(l=>l/i[1])),t=Math.min(...e),n=t<0?e.map(l=>(l-t)/(1-t)):e,s=Math.max(...n),[r,a,o]=n.map(l=>Math.round(255*F0(l/s)));return`rgb(${r}, ${a}, ${o})`}function ra([i,e,t]){let n=i+e+t;return n>0?[i/n,e/n]:null}function U0(i,e){let[t,n]=[ra(i),ra(e)];if(!t||!n)return null;let s=[t[0]-n[0],t[1]-n[1]];if(Math.hypot(...s)<1e-4)return null;let a=Yh(n,s)??Yh(n,[-s[0],-s[1]]);if(!a)return null;let o=Yh(n,s)===null;return{nm:a.nm,purity:o?NaN:Math.min(1,1/a.factor),complementary:o}}function Yh(i,[e,t]){for(let n=380;n<700;n++){let[s,r]=[ra(na(n)),ra(na(n+1))];if(!s||!r)continue;let[a,o]=[r[0]-s[0],r[1]-s[1]],l=e*-o+a*t;if(Math.abs(l)<1e-12)continue;let[c,u]=[s[0]-i[0],s[1]-i[1]],f=(c*-o+a*u)/l,h=(e*u-t*c)/l;if(f>0&&h>=0&&h<1)return{nm:n+h,factor:f}}return null}function ho(i){let e=na(i),t=Math.min(1,Math.max(.15,e[0]+e[1]+e[2])),n=N0(e),s=Math.min(0,...n),r=n.map(u=>u-s),a=Math.max(...r),[o,l,c]=r.map(u=>Math.round(255*F0(u/a*t)));return`rgb(${o}, ${l}, ${c})`}function $h(i,e){let t=URL.createObjectURL(i),n=document.createElement("a");n.href=t,n.download=e,n.click(),setTimeout(()=>URL.revokeObjectURL(t),1e4)}async function O0(i,e){if(typeof MediaRecorder>"u")return null;let t=["video/webm;codecs=vp9","video/webm;codecs=vp8","video/webm"].find(a=>MediaRecorder.isTypeSupported(a));if(!t)return null;let n=new MediaRecorder(i.captureStream(30),{mimeType:t,videoBitsPerSecond:12e6}),s=[];n.ondataavailable=a=>s.push(a.data);let r=new Promise(a=>n.onstop=a);return n.start(),await new Promise(a=>setTimeout(a,e*1e3)),n.stop(),await r,new Blob(s,{type:t})}var aS="http://www.w3.org/2000/svg";function B0(i,e,t){for(let[n,s]of Object.entries(e))s==null||s===!1||(n.startsWith("on")?i.addEventListener(n.slice(2),s):n in i&&!(i instanceof SVGElement)&&n!=="list"&&n!=="role"?Reflect.set(i,n,s):i.setAttribute(n==="className"?"class":n,s===!0?"":String(s)));for(let n of t)n&&i.append(n)}function pe(i,e={},...t){let n=document.createElement(i);return B0(n,e,t),n}function un(i,e={},...t){let n=document.createElementNS(aS,i);return B0(n,e,t),n}var oS=0,aa=()=>`e${++oS}`;function Ri(i,e=3){if(!Number.isFinite(i))return"–";if(i===0)return"0";let t=Math.abs(i);if(t>=1e5||t<.001){let[n,s]=i.toExponential(e-1).split("e");return`${Number(n)}e${Number(s)}`.replaceAll("-","−")}return String(Number(i.toPrecision(e))).replace("-","−")}function qn(i,e,t){let{label:n,unit:s="",title:r,min:a,max:o,step:l}=i,c=aa(),u=pe("output",{htmlFor:c}),f=pe("input",{type:"range",id:c,min:a,max:o,step:l,title:r,oninput:()=>t(i.set(Number(f.value),e()))}),h=pe("div",{className:"control",title:r},pe("label",{htmlFor:c},n),u,f);return{element:h,update:d=>{let g=i.get(d);f.value=String(g);let b=i.text?.(g,d)??`${Number(g.toFixed(2))}${s}`;u.textContent=b,f.setAttribute("aria-valuetext",b),f.style.setProperty("--filled",`${100*(Number(f.value)-a)/(o-a)}%`),h.hidden=i.when?!i.when(d):!1}}}function fo(i,e){let t=aa(),n=new Map,s=i.choices.map(({value:a,label:o,icon:l,title:c})=>{let u=pe("input",{type:"radio",name:t,value:a,onchange:()=>e(i.set(a))});return n.set(a,u),pe("label",{title:c??o},u,pe("span",{},l?.(),pe("span",{className:"word"},o)))}),r=pe("fieldset",{className:"segments",title:i.title},pe("legend",{},i.label),pe("div",{className:"row"},...s));return{element:r,update:a=>{let o=n.get(i.get(a));if(o)o.checked=!0;else for(let l of n.values())l.checked=!1;r.hidden=i.when?!i.when(a):!1}}}function z0(i,e){let t=aa(),n=pe("select",{id:t,onchange:()=>e(i.set(n.value))},...i.choices.map(({value:r,label:a})=>pe("option",{value:r},a))),s=pe("div",{className:"control list",title:i.title},pe("label",{htmlFor:t},i.label),n);return{element:s,update:r=>{n.value=i.get(r),s.hidden=i.when?!i.when(r):!1}}}function Zh(i,e){let t=pe("input",{type:"checkbox",onchange:()=>e(i.set(t.checked))}),n=pe("label",{className:"toggle",title:i.title},t,pe("span",{},i.label));return{element:n,update:s=>{t.checked=i.get(s),n.hidden=i.when?!i.when(s):!1}}}function ar(i,e,...t){return pe("details",{open:e,className:"section"},pe("summary",{},pe("h2",{},i)),pe("div",{className:"body"},...t))}function Uc(i,e,t,n=""){return pe("button",{type:"button",title:e,onclick:t,className:n},i)}var Nn=(...i)=>()=>un("svg",{viewBox:"0 0 24 24",className:"glyph","aria-hidden":"true"},...i.map(e=>un("path",{d:e}))),Ji=(i,e=12,t=12)=>`M${e-i} ${t}a${i} ${i} 0 1 0 ${2*i} 0a${i} ${i} 0 1 0 ${-2*i} 0`,En={mark:Nn("M4 20V4M8 20V7M12 20V10M16 20V13M20 20V16"),ball:Nn(Ji(8),"M5 9c4 2.5 10 2.5 14 0M5 15c4-2.5 10-2.5 14 0"),snake:Nn("M4 18c6 3 15 1 14-4S7 12 7 8s6-5 11-2l2-1"),flat:Nn("M6 6h12l3 12H3z","M10 6L8.500 18M14 6l1.500 12"),screen:Nn("M4 4h16v12H4z",Ji(1.5,12,10),"M12 16v5"),map:Nn(Ji(8),Ji(4),"M12 4v16M4 12h16"),light:Nn(Ji(4),"M12 2v3M12 19v3M2 12h3M19 12h3M5 5l2 2M17 17l2 2M19 5l-2 2M7 17l-2 2"),orbit:Nn(Ji(3),"M3 12c0-3 4-5 9-5s9 2 9 5-4 5-9 5","M14 14l-2 3 3 2"),spot:Nn(Ji(6),"M12 2v6M12 16v6M2 12h6M16 12h6"),pause:Nn("M9 5v14M15 5v14"),sweep:Nn(Ji(3,18,6),"M4 19C5 11 8 8 14 6.500","M4 19l-1-3M4 19l3-1"),turn:Nn("M4 12a8 8 0 1 0 3-6.200","M3 4l4 1.500L5.500 9.500"),link:Nn("M10 14a4 4 0 0 0 6 0l3-3a4 4 0 0 0-6-6l-1 1","M14 10a4 4 0 0 0-6 0l-3 3a4 4 0 0 0 6 6l1-1"),picture:Nn("M4 5h16v14H4z",Ji(1.5,9,10),"M4 17l5-4 3 2 4-4 4 4"),film:Nn("M4 5h16v14H4z","M10 9l5 3-5 3z"),theme:Nn(Ji(8),"M12 4a8 8 0 0 1 0 16z")};var po=192;function k0(){let i=pe("canvas",{width:po,height:po,role:"img"}),e=un("circle",{r:.035,className:"marker"}),t=un("path",{d:"M-.05 0H.05M0 -.05V.05",className:"mirror"}),n=d=>un("circle",{r:Math.sin(d*Math.PI/180),className:"ring"}),s=un("svg",{viewBox:"-1 -1 2 2","aria-hidden":"true"},n(30),n(60),n(90),un("path",{d:"M-1 0H1M0 -1V1",className:"ring"}),t,e),r=pe("p",{className:"caption"}),a=pe("div",{className:"map",title:"The BRDF for the light at the spot: each point is a viewing direction, the middle looks straight down, the rim along the surface. The cross is the mirror direction, the ring the viewer."},pe("div",{className:"square"},i,s),r),o=i.getContext("2d"),l=null,c="",u={element:a,update:h,onAsk:()=>{}},f=d=>{let g=s.getBoundingClientRect(),[b,m]=[2*(d.clientX-g.left)/g.width-1,1-2*(d.clientY-g.top)/g.height],p=1-b*b-m*m;return p>0?[b,m,Math.sqrt(p)]:null};s.addEventListener("pointermove",d=>u.onAsk(f(d))),s.addEventListener("pointerdown",d=>u.onAsk(f(d))),s.addEventListener("pointerleave",()=>u.onAsk(null));function h(d,g,b){e.style.display=t.style.display=b?"":"none";let m=g.evaluated();if(!b||!m||!o){r.textContent="The spot lies beside the surface, or no light reaches it.";return}let{wi:p,wo:v}=b;e.setAttribute("cx",String(v[0])),e.setAttribute("cy",String(-v[1])),t.setAttribute("transform",`translate(${-p[0]} ${p[1]})`);let[E,S]=[fu(p),fu(v)];r.textContent=`light θ ${E.theta_deg.toFixed(0)}°, φ ${E.phi_deg.toFixed(0)}° · viewer θ ${S.theta_deg.toFixed(0)}°, φ ${S.phi_deg.toFixed(0)}°`,i.setAttribute("aria-label",`Map of the BRDF over viewing directions; ${r.textContent}`);let R=JSON.stringify([p,d.specimen,d.illuminant,d.laser_nm,d.sun_deg,d.scale,d.tables,d.pigment,g.loaded?.spectral!==null]);if(R===c)return;c=R;let{pixels:A}=g.probe.map(m,p,po,null);l??=o.createImageData(po,po),l.data.set(A),o.putImageData(l,0,0)}return u}var Oc=3,V0=.02;function Jh([i,e,t],n,s){let r=ea(Xn([i,e,t]),n),a=s*Math.PI/180,[o,l]=[Math.sin(a),Math.cos(a)];return Xn([r[0],r[1]*l+r[2]*o,r[2]*l-r[1]*o])}function zs(i,e){return{lights:i.lights.map((t,n)=>n===i.active?{...t,...e}:t)}}function G0(i,e){let t=pe("canvas",{tabIndex:0,role:"application","aria-label":"The picture. Arrow keys move the light; with Shift they turn the view; with Control they move the spot that is asked. Plus and minus zoom."}),n=pe("div",{className:"overlay"}),s=pe("div",{className:"spot","aria-hidden":"true"}),a={element:pe("div",{className:"picture"},t,s,n),canvas:t,overlay:n,grip:"light",update:p},o=()=>{let{width:v,height:E}=t.getBoundingClientRect();return{width:v,height:E,extent:jr(v,E)}},l=v=>{let E=t.getBoundingClientRect(),[S,R]=jr(E.width,E.height);return{x:S*(2*(v.clientX-E.left)/E.width-1),y:R*(1-2*(v.clientY-E.top)/E.height)}},c=(v,E)=>{let{view:S}=i();e({view:{...S,azimuth_deg:(S.azimuth_deg-v+540)%360-180,elevation_deg:Math.max(-89,Math.min(89,S.elevation_deg-E))}})},u=(v,E)=>{let S=i();e(zs(S,{direction:Jh(S.lights[S.active].direction,v,E)}))},f=(v,E)=>{let{pointer:S}=i();e({pointer:{x:S.x+v,y:S.y+E}})},h=v=>{let{view:E}=i();e({view:{...E,zoom:Math.max(.5,Math.min(20,E.zoom*v))}})},d=null,g=null,b=new Map;t.addEventListener("pointerdown",v=>{t.setPointerCapture(v.pointerId),b.set(v.pointerId,v);let E=v.shiftKey||v.button===2,S=v.ctrlKey?"spot":E?a.grip==="view"?"light":"view":a.grip;d={x:v.clientX,y:v.clientY,grip:S},e({pointer:l(v)})}),t.addEventListener("pointermove",v=>{if(b.has(v.pointerId)&&b.set(v.pointerId,v),b.size===2){let[A,x]=[...b.values()],T=Math.hypot(A.clientX-x.clientX,A.clientY-x.clientY);g&&h(T/g),g=T;return}if(!d){v.pointerType==="mouse"&&e({pointer:l(v)});return}let E=160/Math.min(o().width,o().height),[S,R]=[(v.clientX-d.x)*E,(d.y-v.clientY)*E];d={...d,x:v.clientX,y:v.clientY},d.grip==="spot"?e({pointer:l(v)}):d.grip==="view"?c(S,R):u(S,R)});let m=v=>{b.delete(v.pointerId),d=null,g=null};t.addEventListener("pointerup",m),t.addEventListener("pointercancel",m),t.addEventListener("contextmenu",v=>v.preventDefault()),t.addEventListener("wheel",v=>{v.preventDefault(),h(Math.exp(-v.deltaY/600))},{passive:!1}),t.addEventListener("keydown",v=>{let S={ArrowLeft:[-1,0],ArrowRight:[1,0],ArrowUp:[0,1],ArrowDown:[0,-1]}[v.key];if(S){let[R,A]=S;v.ctrlKey||v.metaKey||a.grip==="spot"?f(V0*R,V0*A):v.shiftKey!==(a.grip==="view")?c(-Oc*R,-Oc*A):u(Oc*R,Oc*A)}else if(v.key==="+"||v.key==="=")h(1.1);else if(v.key==="-")h(1/1.1);else if(v.key==="Home")e({view:{azimuth_deg:0,elevation_deg:0,zoom:1}});else return;v.preventDefault()});function p(v){let{width:E,height:S,extent:[R,A]}=o();s.style.transform=`translate(${(v.pointer.x/R+1)/2*E}px, ${(1-v.pointer.y/A)/2*S}px)`}return a}function H0(i){let[e,t,n]=Xn(i),s=Math.hypot(e,t),r=Math.SQRT2*Math.sin(.5*Math.atan2(s,n));return s>1e-9?[r*e/s,r*t/s]:[0,0]}function lS(i,e){let t=Math.min(1,Math.hypot(i,e)),n=2*Math.asin(t/Math.SQRT2),s=Math.atan2(e,i);return[Math.sin(n)*Math.cos(s),Math.sin(n)*Math.sin(s),Math.cos(n)]}function W0(i,e){let t=un("g"),n=[30,60].map(l=>un("circle",{r:Math.SQRT2*Math.sin(l*Math.PI/360),className:"ring"})),s=un("svg",{viewBox:"-1.08 -1.08 2.16 2.16","aria-hidden":"true"},un("circle",{r:1,className:"rim"}),...n,un("path",{d:"M-1 0H1M0 -1V1",className:"ring"}),t),r=pe("div",{className:"pad",tabIndex:0,role:"application",title:"Where the lights stand, seen from the camera. Drag, or use the arrow keys.","aria-label":"Light. Arrow keys move it."},s),a=l=>{let c=s.getBoundingClientRect(),u=c.width/2.16;return[(l.clientX-c.left-c.width/2)/u,(c.top+c.height/2-l.clientY)/u]},o=l=>e(zs(i(),{direction:lS(...a(l))}));return r.addEventListener("pointerdown",l=>{r.setPointerCapture(l.pointerId);let[c,u]=a(l),f=i().lights.map(({direction:d})=>{let[g,b]=H0(d);return Math.hypot(g-c,b-u)}),h=f.indexOf(Math.min(...f));f[h]<.15&&e({active:h}),o(l)}),r.addEventListener("pointermove",l=>r.hasPointerCapture(l.pointerId)&&o(l)),r.addEventListener("keydown",l=>{let u={ArrowLeft:[-3,0],ArrowRight:[3,0],ArrowUp:[0,3],ArrowDown:[0,-3]}[l.key];if(!u)return;let f=i();e(zs(f,{direction:Jh(f.lights[f.active].direction,...u)})),l.preventDefault()}),{element:r,update:l=>{t.replaceChildren(...l.lights.map((c,u)=>{let[f,h]=H0(c.direction);return un("circle",{cx:f,cy:-h,r:u===l.active?.085:.06,className:u===l.active?"lamp active":"lamp"})}))}}}var Ki=Math.PI/180;var X0=Array.from({length:357},(i,e)=>(e-178)/2),Kh=5;function q0(i){let e=pe("canvas",{role:"img"}),t=pe("input",{type:"checkbox",onchange:()=>i({polar_log:t.checked})}),n=pe("p",{className:"caption"});return{element:pe("div",{className:"polar",title:"f against the viewing angle in the plane of incidence: the line comes from the light, the dashes point to the mirror direction."},e,pe("label",{className:"toggle"},t,pe("span",{},"logarithmic")),n),update:(r,a,o)=>{t.checked=r.polar_log,uS(e,n,r,a,o)}}}function cS(i){let e=Math.hypot(i[0],i[1]),[t,n]=e>1e-6?[-i[0]/e,-i[1]/e]:[1,0];return X0.map(s=>{let[r,a]=[Math.sin(s*Ki),Math.cos(s*Ki)];return[r*t,r*n,a]})}function uS(i,e,t,n,s){let r=n.evaluated(),a=Math.min(2,devicePixelRatio||1),o=i.clientWidth||340,l=Math.round(o*.54);i.width!==Math.round(o*a)&&(i.width=Math.round(o*a)),i.height!==Math.round(l*a)&&(i.height=Math.round(l*a));let c=i.getContext("2d");if(!c)return;c.setTransform(a,0,0,a,0,0),c.clearRect(0,0,o,l);let u=getComputedStyle(i),[f,h,d]=["--line","--muted","--accent"].map(R=>u.getPropertyValue(R).trim()),[g,b,m]=[o/2,l-16,Math.min(o/2-8,l-26)];if(hS(c,{cx:g,cy:b,radius:m,line:f,text:h}),!s||!r){e.textContent="";return}let p=n.probe.brdf(r,cS(s.wi).map(R=>({wi:s.wi,wo:R}))),v=Math.max(...p.map(R=>R?.[1]??0),1e-30),E=R=>{let A=Math.max(0,R?.[1]??0)/v;return m*(t.polar_log?Math.max(0,1+Math.log10(Math.max(A,1e-30))/Kh):A)};X0.forEach((R,A)=>{let x=p[A],T=E(x);!x||!(T>0)||(c.fillStyle=Fc(x),c.beginPath(),c.moveTo(g,b),c.arc(g,b,T,(R-90.3)*Ki,(R-89.7)*Ki),c.fill())});let S=Math.atan2(Math.hypot(s.wi[0],s.wi[1]),s.wi[2])/Ki;Qh(c,{cx:g,cy:b,radius:m},-S,d,[]),Qh(c,{cx:g,cy:b,radius:m},S,d,[3,4]),e.textContent=`rim: Y = ${Ri(v,3)} /sr${t.polar_log?", rings one decade apart":""}`,i.setAttribute("aria-label",`Polar plot of the BRDF in the plane of incidence; light at ${S.toFixed(0)} degrees, brightest Y ${Ri(v,3)} per steradian`)}function hS(i,{cx:e,cy:t,radius:n,line:s,text:r}){i.strokeStyle=s,i.lineWidth=1;for(let a=1;a<=Kh;a++)i.beginPath(),i.arc(e,t,n*a/Kh,Math.PI,2*Math.PI),i.stroke();i.fillStyle=r,i.font="11px system-ui, sans-serif",i.textAlign="center";for(let a of[-60,-30,0,30,60]){Qh(i,{cx:e,cy:t,radius:n},a,s,[]);let[o,l]=[Math.sin(a*Ki),Math.cos(a*Ki)];i.fillText(`${Math.abs(a)}°`,e+(n+9)*o,t-(n+4)*l+3)}i.beginPath(),i.moveTo(e-n,t),i.lineTo(e+n,t),i.stroke()}function Qh(i,{cx:e,cy:t,radius:n},s,r,a){i.save(),i.strokeStyle=r,i.setLineDash(a),i.beginPath(),i.moveTo(e,t),i.lineTo(e+n*Math.sin(s*Ki),t-n*Math.cos(s*Ki)),i.stroke(),i.restore()}function $0(){let i=pe("img",{alt:"",className:"heights"}),e=pe("p",{className:"caption"}),t=pe("img",{alt:""}),n=un("svg",{viewBox:"-1 -1 2 2","aria-hidden":"true"}),s=pe("div",{className:"square"},t,n),r=pe("p",{className:"caption"}),a=pe("div",{className:"relief"},pe("figure",{title:"The scanned surface, seen from above."},i,e),pe("figure",{title:"Spatial frequencies of the relief. The coloured line are those that send each wavelength from this light to this viewer: the grating equation. Bright spots under it are orders that are seen."},s,r)),o="",l=null,c=async(u,f)=>{let{name:h}=f,d=(await u.viewerFile())?.heights?.[h],g=p=>u.index.files.some(v=>v.path===p),b=d??(g(`${h}/heights.png`)?`${h}/heights.png`:null),m=g(`${h}/spectrum.png`)?`${h}/spectrum.png`:null;o===h&&(l=dS(f),await Y0(u,i,b,"height map",e,fS(f)),i.alt=`Height map of ${h}`,await Y0(u,t,m,"power spectrum",r,""),t.alt=`Power spectrum of the heights of ${h}`,s.hidden=t.hidden)};return{element:a,update:(u,f,h)=>{let d=f.loaded?.specimen;d&&d.name!==o&&(o=d.name,l=null,c(f,d)),!t.hidden&&(n.replaceChildren(...h&&l?mS(h,l):[]),r.textContent=pS(h,l))}}}async function Y0(i,e,t,n,s,r){if(e.hidden=!0,s.textContent=`This atlas holds no ${n} of the specimen.`,!!t)try{e.src=await i.files.url(t),await e.decode(),e.hidden=!1,s.textContent=r}catch{s.textContent=`The atlas's picture ${t} cannot be read.`}}function fS({provenance:i,statistics:e}){let t=i?.[0],n=e?.[0]?.peak_to_valley_nm;return[t?`${Ri(t.size[0]*t.pitch_nm[0]/1e3)} µm across`:"",n?`${n.toFixed(0)} nm from lowest to highest`:""].filter(Boolean).join(" · ")}function dS({provenance:i,statistics:e}){let t=i?.[0];if(!t)return null;let n=(e?.[0]?.dominant_periods??[]).map(({period_nm:o})=>o).filter(o=>o>0),s=Math.max(0,...n.map(o=>1e3/o)),r=500/Math.max(...t.pitch_nm),a=Math.min(t.size[0]*t.pitch_nm[0],t.size[1]*t.pitch_nm[1]);return Math.min(r,Math.max(8e3/a,s>0?3*s:r/2))}function pS(i,e){if(!e)return"This atlas does not say how large its scan is, so nothing is drawn over the spectrum.";let t=`edge ${e.toPrecision(3)} /µm`;if(!i)return t;let n=Math.hypot(i.wi[0]+i.wo[0],i.wi[1]+i.wo[1]);return n<.02?`${t} · mirror direction: no frequency selected`:`${t} · selected: periods of ${(380/n).toFixed(0)} nm (violet) to ${(780/n).toFixed(0)} nm (red)`}function mS({wi:i,wo:e},t){let[n,s]=[-(i[0]+e[0]),-(i[1]+e[1])],r=Math.hypot(n,s),a=c=>[1e3*n/c/t,-1e3*s/c/t],o=[420,550,680].map(c=>un("circle",{r:1e3*r/c/t,stroke:ho(c),className:"selected"})),l=[];for(let c of[1,-1])for(let u=400;u<700;u+=10){let[[f,h],[d,g]]=[a(u),a(u+10)];l.push(un("line",{x1:c*f,y1:c*h,x2:c*d,y2:c*g,stroke:ho(u),className:"bright"}))}return[...o,...l]}var gS="uplot",_S="u-hz",xS="u-vt",vS="u-title",yS="u-wrap",bS="u-under",SS="u-over",MS="u-axis",cr="u-off",wS="u-select",TS="u-cursor-x",AS="u-cursor-y",ES="u-cursor-pt",RS="u-legend",CS="u-live",PS="u-inline",IS="u-series",LS="u-marker",Z0="u-label",DS="u-value",go="width",_o="height";var J0="bottom",oa="left",jh="right",_f="#000",K0=_f+"0",ef="mousemove",Q0="mousedown",tf="mouseup",j0="mouseenter",em="mouseleave",tm="dblclick",NS="resize",FS="scroll",nm="change",Gc="dppxchange",xf="--",pa=typeof window<"u",of=pa?document:null,ca=pa?window:null,US=pa?navigator:null,wt,Bc;function lf(){let i=devicePixelRatio;wt!=i&&(wt=i,Bc&&uf(nm,Bc,lf),Bc=matchMedia(`(min-resolution: ${wt-.001}dppx) and (max-resolution: ${wt+.001}dppx)`),ur(nm,Bc,lf),ca.dispatchEvent(new CustomEvent(Gc)))}function ii(i,e){if(e!=null){let t=i.classList;!t.contains(e)&&t.add(e)}}function cf(i,e){let t=i.classList;t.contains(e)&&t.remove(e)}function Ht(i,e,t){i.style[e]=t+"px"}function Ci(i,e,t,n){let s=of.createElement(i);return e!=null&&ii(s,e),t?.insertBefore(s,n),s}function gi(i,e){return Ci("div",i,e)}var im=new WeakMap;function Qi(i,e,t,n,s){let r="translate("+e+"px,"+t+"px)",a=im.get(i);r!=a&&(i.style.transform=r,im.set(i,r),e<0||t<0||e>n||t>s?ii(i,cr):cf(i,cr))}var sm=new WeakMap;function rm(i,e,t){let n=e+t,s=sm.get(i);n!=s&&(sm.set(i,n),i.style.background=e,i.style.borderColor=t)}var am=new WeakMap;function om(i,e,t,n){let s=e+""+t,r=am.get(i);s!=r&&(am.set(i,s),i.style.height=t+"px",i.style.width=e+"px",i.style.marginLeft=n?-e/2+"px":0,i.style.marginTop=n?-t/2+"px":0)}var vf={passive:!0},OS={...vf,capture:!0};function ur(i,e,t,n){e.addEventListener(i,t,n?OS:vf)}function uf(i,e,t,n){e.removeEventListener(i,t,vf)}pa&&lf();function Pi(i,e,t,n){let s;t=t||0,n=n||e.length-1;let r=n<=2147483647;for(;n-t>1;)s=r?t+n>>1:si((t+n)/2),e[s]<i?t=s:n=s;return i-e[t]<=e[n]-i?t:n}function Fm(i){return(t,n,s)=>{let r=-1,a=-1;for(let o=n;o<=s;o++)if(i(t[o])){r=o;break}for(let o=s;o>=n;o--)if(i(t[o])){a=o;break}return[r,a]}}var Um=i=>i!=null,Om=i=>i!=null&&i>0,Xc=Fm(Um),BS=Fm(Om);function zS(i,e,t,n=0,s=!1){let r=s?BS:Xc,a=s?Om:Um;[e,t]=r(i,e,t);let o=i[e],l=i[e];if(e>-1)if(n==1)o=i[e],l=i[t];else if(n==-1)o=i[t],l=i[e];else for(let c=e;c<=t;c++){let u=i[c];a(u)&&(u<o?o=u:u>l&&(l=u))}return[o??Ft,l??-Ft]}function qc(i,e,t,n){let s=um(i),r=um(e);i==e&&(s==-1?(i*=t,e/=t):(i/=t,e*=t));let a=t==10?gs:Bm,o=s==1?si:_i,l=r==1?_i:si,c=o(a(_n(i))),u=l(a(_n(e))),f=ua(t,c),h=ua(t,u);return t==10&&(c<0&&(f=Ut(f,-c)),u<0&&(h=Ut(h,-u))),n||t==2?(i=f*s,e=h*r):(i=Gm(i,f),e=Yc(e,h)),[i,e]}function yf(i,e,t,n){let s=qc(i,e,t,n);return i==0&&(s[0]=0),e==0&&(s[1]=0),s}var bf=.1,lm={mode:3,pad:bf},vo={pad:0,soft:null,mode:0},kS={min:vo,max:vo};function Hc(i,e,t,n){return $c(t)?cm(i,e,t):(vo.pad=t,vo.soft=n?0:null,vo.mode=n?3:0,cm(i,e,kS))}function bt(i,e){return i??e}function VS(i,e,t){for(e=bt(e,0),t=bt(t,i.length-1);e<=t;){if(i[e]!=null)return!0;e++}return!1}function cm(i,e,t){let n=t.min,s=t.max,r=bt(n.pad,0),a=bt(s.pad,0),o=bt(n.hard,-Ft),l=bt(s.hard,Ft),c=bt(n.soft,Ft),u=bt(s.soft,-Ft),f=bt(n.mode,0),h=bt(s.mode,0),d=e-i,g=gs(d),b=Gn(_n(i),_n(e)),m=gs(b),p=_n(m-g);(d<1e-24||p>10)&&(d=0,(i==0||e==0)&&(d=1e-24,f==2&&c!=Ft&&(r=0),h==2&&u!=-Ft&&(a=0)));let v=d||b||1e3,E=gs(v),S=ua(10,si(E)),R=v*(d==0?i==0?.1:1:r),A=Ut(Gm(i-R,S/10),24),x=i>=c&&(f==1||f==3&&A<=c||f==2&&A>=c)?c:Ft,T=Gn(o,A<x&&i>=x?x:Ii(x,A)),k=v*(d==0?e==0?.1:1:a),N=Ut(Yc(e+k,S/10),24),L=e<=u&&(h==1||h==3&&N>=u||h==2&&N<=u)?u:-Ft,G=Ii(l,N>L&&e<=L?L:Gn(L,N));return T==G&&T==0&&(G=100),[T,G]}var GS=new Intl.NumberFormat(pa?US.language:"en-US"),Sf=i=>GS.format(i),ri=Math,Vc=ri.PI,_n=ri.abs,si=ri.floor,gn=ri.round,_i=ri.ceil,Ii=ri.min,Gn=ri.max,ua=ri.pow,um=ri.sign,gs=ri.log10,Bm=ri.log2,HS=(i,e=1)=>ri.sinh(i)*e,nf=(i,e=1)=>ri.asinh(i/e),Ft=1/0;function hm(i){return(gs((i^i>>31)-(i>>31))|0)+1}function hf(i,e,t){return Ii(Gn(i,e),t)}function zm(i){return typeof i=="function"}function gt(i){return zm(i)?i:()=>i}var WS=()=>{},km=i=>i,Vm=(i,e)=>e,XS=i=>null,fm=i=>!0,dm=(i,e)=>i==e,qS=/\.\d*?(?=9{6,}|0{6,})/gm,hr=i=>{if(Wm(i)||Vs.has(i))return i;let e=`${i}`,t=e.match(qS);if(t==null)return i;let n=t[0].length-1;if(e.indexOf("e-")!=-1){let[s,r]=e.split("e");return+`${hr(s)}e${r}`}return Ut(i,n)};function or(i,e){return hr(Ut(hr(i/e))*e)}function Yc(i,e){return hr(_i(hr(i/e))*e)}function Gm(i,e){return hr(si(hr(i/e))*e)}function Ut(i,e=0){if(Wm(i))return i;let t=10**e,n=i*t*(1+Number.EPSILON);return gn(n)/t}var Vs=new Map;function Hm(i){return((""+i).split(".")[1]||"").length}function bo(i,e,t,n){let s=[],r=n.map(Hm);for(let a=e;a<t;a++){let o=_n(a),l=Ut(ua(i,a),o);for(let c=0;c<n.length;c++){let u=i==10?+`${n[c]}e${a}`:n[c]*l,f=(a>=0?0:o)+(a>=r[c]?0:r[c]),h=i==10?u:Ut(u,f);s.push(h),Vs.set(h,f)}}return s}var yo={},Mf=[],ha=[null,null],ks=Array.isArray,Wm=Number.isInteger,YS=i=>i===void 0;function pm(i){return typeof i=="string"}function $c(i){let e=!1;if(i!=null){let t=i.constructor;e=t==null||t==Object}return e}function $S(i){return i!=null&&typeof i=="object"}var ZS=Object.getPrototypeOf(Uint8Array),Xm="__proto__";function fa(i,e=$c){let t;if(ks(i)){let n=i.find(s=>s!=null);if(ks(n)||e(n)){t=Array(i.length);for(let s=0;s<i.length;s++)t[s]=fa(i[s],e)}else t=i.slice()}else if(i instanceof ZS)t=i.slice();else if(e(i)){t={};for(let n in i)n!=Xm&&(t[n]=fa(i[n],e))}else t=i;return t}function hn(i){let e=arguments;for(let t=1;t<e.length;t++){let n=e[t];for(let s in n)s!=Xm&&($c(i[s])?hn(i[s],fa(n[s])):i[s]=fa(n[s]))}return i}var JS=0,KS=1,QS=2;function jS(i,e,t){for(let n=0,s,r=-1;n<e.length;n++){let a=e[n];if(a>r){for(s=a-1;s>=0&&i[s]==null;)i[s--]=null;for(s=a+1;s<t&&i[s]==null;)i[r=s++]=null}}}function eM(i,e){if(iM(i)){let a=i[0].slice();for(let o=1;o<i.length;o++)a.push(...i[o].slice(1));return sM(a[0])||(a=nM(a)),a}let t=new Set;for(let a=0;a<i.length;a++){let l=i[a][0],c=l.length;for(let u=0;u<c;u++)t.add(l[u])}let n=[Array.from(t).sort((a,o)=>a-o)],s=n[0].length,r=new Map;for(let a=0;a<s;a++)r.set(n[0][a],a);for(let a=0;a<i.length;a++){let o=i[a],l=o[0];for(let c=1;c<o.length;c++){let u=o[c],f=Array(s).fill(void 0),h=e?e[a][c]:KS,d=[];for(let g=0;g<u.length;g++){let b=u[g],m=r.get(l[g]);b===null?h!=JS&&(f[m]=b,h==QS&&d.push(m)):f[m]=b}jS(f,d,s),n.push(f)}}return n}var tM=typeof queueMicrotask>"u"?i=>Promise.resolve().then(i):queueMicrotask;function nM(i){let e=i[0],t=e.length,n=Array(t);for(let r=0;r<n.length;r++)n[r]=r;n.sort((r,a)=>e[r]-e[a]);let s=[];for(let r=0;r<i.length;r++){let a=i[r],o=Array(t);for(let l=0;l<t;l++)o[l]=a[n[l]];s.push(o)}return s}function iM(i){let e=i[0][0],t=e.length;for(let n=1;n<i.length;n++){let s=i[n][0];if(s.length!=t)return!1;if(s!=e){for(let r=0;r<t;r++)if(s[r]!=e[r])return!1}}return!0}function sM(i,e=100){let t=i.length;if(t<=1)return!0;let n=0,s=t-1;for(;n<=s&&i[n]==null;)n++;for(;s>=n&&i[s]==null;)s--;if(s<=n)return!0;let r=Gn(1,si((s-n+1)/e));for(let a=i[n],o=n+r;o<=s;o+=r){let l=i[o];if(l!=null){if(l<=a)return!1;a=l}}return!0}var qm=["January","February","March","April","May","June","July","August","September","October","November","December"],Ym=["Sunday","Monday","Tuesday","Wednesday","Thursday","Friday","Saturday"];function $m(i){return i.slice(0,3)}var rM=Ym.map($m),aM=qm.map($m),oM={MMMM:qm,MMM:aM,WWWW:Ym,WWW:rM};function mo(i){return(i<10?"0":"")+i}function lM(i){return(i<10?"00":i<100?"0":"")+i}var cM={YYYY:i=>i.getFullYear(),YY:i=>(i.getFullYear()+"").slice(2),MMMM:(i,e)=>e.MMMM[i.getMonth()],MMM:(i,e)=>e.MMM[i.getMonth()],MM:i=>mo(i.getMonth()+1),M:i=>i.getMonth()+1,DD:i=>mo(i.getDate()),D:i=>i.getDate(),WWWW:(i,e)=>e.WWWW[i.getDay()],WWW:(i,e)=>e.WWW[i.getDay()],HH:i=>mo(i.getHours()),H:i=>i.getHours(),h:i=>{let e=i.getHours();return e==0?12:e>12?e-12:e},AA:i=>i.getHours()>=12?"PM":"AM",aa:i=>i.getHours()>=12?"pm":"am",a:i=>i.getHours()>=12?"p":"a",mm:i=>mo(i.getMinutes()),m:i=>i.getMinutes(),ss:i=>mo(i.getSeconds()),s:i=>i.getSeconds(),fff:i=>lM(i.getMilliseconds())};function wf(i,e){e=e||oM;let t=[],n=/\{([a-z]+)\}|[^{]+/gi,s;for(;s=n.exec(i);)t.push(s[0][0]=="{"?cM[s[1]]:s[0]);return r=>{let a="";for(let o=0;o<t.length;o++)a+=typeof t[o]=="string"?t[o]:t[o](r,e);return a}}var uM=new Intl.DateTimeFormat().resolvedOptions().timeZone;function hM(i,e){let t;return e=="UTC"||e=="Etc/UTC"?t=new Date(+i+i.getTimezoneOffset()*6e4):e==uM?t=i:(t=new Date(i.toLocaleString("en-US",{timeZone:e})),t.setMilliseconds(i.getMilliseconds())),t}var Zm=i=>i%1==0,Wc=[1,2,2.5,5],fM=bo(10,-32,0,Wc),Jm=bo(10,0,32,Wc),dM=Jm.filter(Zm),lr=fM.concat(Jm),Tf=`
`,Km="{YYYY}",mm=Tf+Km,Qm="{M}/{D}",xo=Tf+Qm,zc=xo+"/{YY}",jm="{aa}",pM="{h}:{mm}",la=pM+jm,gm=Tf+la,_m=":{ss}",At=null;function eg(i){let e=i*1e3,t=e*60,n=t*60,s=n*24,r=s*30,a=s*365,l=(i==1?bo(10,0,3,Wc).filter(Zm):bo(10,-3,0,Wc)).concat([e,e*5,e*10,e*15,e*30,t,t*5,t*10,t*15,t*30,n,n*2,n*3,n*4,n*6,n*8,n*12,s,s*2,s*3,s*4,s*5,s*6,s*7,s*8,s*9,s*10,s*15,r,r*2,r*3,r*4,r*6,a,a*2,a*5,a*10,a*25,a*50,a*100]),c=[[a,Km,At,At,At,At,At,At,1],[s*28,"{MMM}",mm,At,At,At,At,At,1],[s,Qm,mm,At,At,At,At,At,1],[n,"{h}"+jm,zc,At,xo,At,At,At,1],[t,la,zc,At,xo,At,At,At,1],[e,_m,zc+" "+la,At,xo+" "+la,At,gm,At,1],[i,_m+".{fff}",zc+" "+la,At,xo+" "+la,At,gm,At,1]];function u(f){return(h,d,g,b,m,p)=>{let v=[],E=m>=a,S=m>=r&&m<a,R=f(g),A=Ut(R*i,3),x=sf(R.getFullYear(),E?0:R.getMonth(),S||E?1:R.getDate()),T=Ut(x*i,3);if(S||E){let k=S?m/r:0,N=E?m/a:0,L=A==T?A:Ut(sf(x.getFullYear()+N,x.getMonth()+k,1)*i,3),G=new Date(gn(L/i)),H=G.getFullYear(),D=G.getMonth();for(let V=0;L<=b;V++){let Z=sf(H+N*V,D+k*V,1),z=Z-f(Ut(Z*i,3));L=Ut((+Z+z)*i,3),L<=b&&v.push(L)}}else{let k=m>=s?s:m,N=si(g)-si(A),L=T+N+Yc(A-T,k);v.push(L);let G=f(L),H=G.getHours()+G.getMinutes()/t+G.getSeconds()/n,D=m/n,V=h.axes[d]._space,Z=p/V;for(;L=Ut(L+m,i==1?0:3),!(L>b);)if(D>1){let z=si(Ut(H+D,6))%24,Q=f(L).getHours()-z;Q>1&&(Q=-1),L-=Q*n,H=(H+D)%24;let ie=v[v.length-1];Ut((L-ie)/m,3)*Z>=.7&&v.push(L)}else v.push(L)}return v}}return[l,c,u]}var[mM,gM,_M]=eg(1),[xM,vM,yM]=eg(.001);bo(2,-53,53,[1]);function xm(i,e){return i.map(t=>t.map((n,s)=>s==0||s==8||n==null?n:e(s==1||t[8]==0?n:t[1]+n)))}function vm(i,e){return(t,n,s,r,a)=>{let o=e.find(g=>a>=g[0])||e[e.length-1],l,c,u,f,h,d;return n.map(g=>{let b=i(g),m=b.getFullYear(),p=b.getMonth(),v=b.getDate(),E=b.getHours(),S=b.getMinutes(),R=b.getSeconds(),A=m!=l&&o[2]||p!=c&&o[3]||v!=u&&o[4]||E!=f&&o[5]||S!=h&&o[6]||R!=d&&o[7]||o[1];return l=m,c=p,u=v,f=E,h=S,d=R,A(b)})}}function bM(i,e){let t=wf(e);return(n,s,r,a,o)=>s.map(l=>t(i(l)))}function sf(i,e,t){return new Date(i,e,t)}function ym(i,e){return e(i)}var SM="{YYYY}-{MM}-{DD} {h}:{mm}{aa}";function bm(i,e){return(t,n,s,r)=>r==null?xf:e(i(n))}function MM(i,e){let t=i.series[e];return t.width?t.stroke(i,e):t.points.width?t.points.stroke(i,e):null}function wM(i,e){return i.series[e].fill(i,e)}var TM={show:!0,live:!0,isolate:!1,mount:WS,markers:{show:!0,width:2,stroke:MM,fill:wM,dash:"solid"},idx:null,idxs:null,values:[]};function AM(i,e){let t=i.cursor.points,n=gi(),s=t.size(i,e);Ht(n,go,s),Ht(n,_o,s);let r=s/-2;Ht(n,"marginLeft",r),Ht(n,"marginTop",r);let a=t.width(i,e,s);return a&&Ht(n,"borderWidth",a),n}function EM(i,e){let t=i.series[e].points;return t._fill||t._stroke}function RM(i,e){let t=i.series[e].points;return t._stroke||t._fill}function CM(i,e){return i.series[e].points.size}var rf=[0,0];function PM(i,e,t){return rf[0]=e,rf[1]=t,rf}function kc(i,e,t,n=!0){return s=>{s.button==0&&(!n||s.target==e)&&t(s)}}function af(i,e,t,n=!0){return s=>{(!n||s.target==e)&&t(s)}}var IM={show:!0,x:!0,y:!0,lock:!1,move:PM,points:{one:!1,show:AM,size:CM,width:0,stroke:RM,fill:EM},bind:{mousedown:kc,mouseup:kc,click:kc,dblclick:kc,mousemove:af,mouseleave:af,mouseenter:af},drag:{setScale:!0,x:!0,y:!1,dist:0,uni:null,click:(i,e)=>{e.stopPropagation(),e.stopImmediatePropagation()},_x:!1,_y:!1},focus:{dist:(i,e,t,n,s)=>n-s,prox:-1,bias:0},hover:{skip:[void 0],prox:null,bias:0},left:-10,top:-10,idx:null,dataIdx:null,idxs:null,event:null},tg={show:!0,stroke:"rgba(0,0,0,0.07)",width:2},Af=hn({},tg,{filter:Vm}),ng=hn({},Af,{size:10}),ig=hn({},tg,{show:!1}),Ef='12px system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji"',sg="bold "+Ef,rg=1.5,Sm={show:!0,scale:"x",stroke:_f,space:50,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:sg,side:2,grid:Af,ticks:ng,border:ig,font:Ef,lineGap:rg,rotate:0},LM="Value",DM="Time",Mm={show:!0,scale:"x",auto:!1,sorted:1,min:Ft,max:-Ft,idxs:[]};function NM(i,e,t,n,s){return e.map(r=>r==null?"":Sf(r))}function FM(i,e,t,n,s,r,a){let o=[],l=Vs.get(s)||0;t=a?t:Ut(Yc(t,s),l);for(let c=t;c<=n;c=Ut(c+s,l))o.push(Object.is(c,-0)?0:c);return o}function ff(i,e,t,n,s,r,a){let o=[],l=i.scales[i.axes[e].scale].log,c=l==10?gs:Bm,u=si(c(t));s=ua(l,u),l==10&&(s=lr[Pi(s,lr)]);let f=t,h=s*l;l==10&&(h=lr[Pi(h,lr)]);do o.push(f),f=f+s,l==10&&!Vs.has(f)&&(f=Ut(f,Vs.get(s))),f>=h&&(s=f,h=s*l,l==10&&(h=lr[Pi(h,lr)]));while(f<=n);return o}function UM(i,e,t,n,s,r,a){let l=i.scales[i.axes[e].scale].asinh,c=n>l?ff(i,e,Gn(l,t),n,s):[l],u=n>=0&&t<=0?[0]:[];return(t<-l?ff(i,e,Gn(l,-n),-t,s):[l]).reverse().map(h=>-h).concat(u,c)}var ag=/./,OM=/[12357]/,BM=/[125]/,wm=/1/,df=(i,e,t,n)=>i.map((s,r)=>e==4&&s==0||r%n==0&&t.test(s.toExponential()[s<0?1:0])?s:null);function zM(i,e,t,n,s){let r=i.axes[t],a=r.scale,o=i.scales[a],l=i.valToPos,c=r._space,u=l(10,a),f=l(9,a)-u>=c?ag:l(7,a)-u>=c?OM:l(5,a)-u>=c?BM:wm;if(f==wm){let h=_n(l(1,a)-u);if(h<c)return df(e.slice().reverse(),o.distr,f,_i(c/h)).reverse()}return df(e,o.distr,f,1)}function kM(i,e,t,n,s){let r=i.axes[t],a=r.scale,o=r._space,l=i.valToPos,c=_n(l(1,a)-l(2,a));return c<o?df(e.slice().reverse(),3,ag,_i(o/c)).reverse():e}function VM(i,e,t,n){return n==null?xf:e==null?"":Sf(e)}var Tm={show:!0,scale:"y",stroke:_f,space:30,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:sg,side:3,grid:Af,ticks:ng,border:ig,font:Ef,lineGap:rg,rotate:0};function GM(i,e){let t=3+(i||1)*2;return Ut(t*e,3)}function HM(i,e){let{scale:t,idxs:n}=i.series[0],s=i._data[0],r=i.valToPos(s[n[0]],t,!0),a=i.valToPos(s[n[1]],t,!0),o=_n(a-r),l=i.series[e],c=o/(l.points.space*wt);return n[1]-n[0]<=c}var Am={scale:null,auto:!0,sorted:0,min:Ft,max:-Ft},og=(i,e,t,n,s)=>s,Em={show:!0,auto:!0,sorted:0,gaps:og,alpha:1,facets:[hn({},Am,{scale:"x"}),hn({},Am,{scale:"y"})]},Rm={scale:"y",auto:!0,sorted:0,show:!0,spanGaps:!1,gaps:og,alpha:1,points:{show:HM,filter:null},values:null,min:Ft,max:-Ft,idxs:[],path:null,clip:null};function WM(i,e,t,n,s){return t/10}var lg={time:!0,auto:!0,distr:1,log:10,asinh:1,min:null,max:null,dir:1,ori:0},XM=hn({},lg,{time:!1,ori:1}),Cm={};function cg(i,e){let t=Cm[i];return t||(t={key:i,plots:[],sub(n){t.plots.push(n)},unsub(n){t.plots=t.plots.filter(s=>s!=n)},pub(n,s,r,a,o,l,c){for(let u=0;u<t.plots.length;u++)t.plots[u]!=s&&t.plots[u].pub(n,s,r,a,o,l,c)}},i!=null&&(Cm[i]=t)),t}var da=1,pf=2;function fr(i,e,t){let n=i.mode,s=i.series[e],r=n==2?i._data[e]:i._data,a=i.scales,o=i.bbox,l=r[0],c=n==2?r[1]:r[e],u=n==2?a[s.facets[0].scale]:a[i.series[0].scale],f=n==2?a[s.facets[1].scale]:a[s.scale],h=o.left,d=o.top,g=o.width,b=o.height,m=i.valToPosH,p=i.valToPosV;return u.ori==0?t(s,l,c,u,f,m,p,h,d,g,b,Jc,ma,Qc,hg,dg):t(s,l,c,u,f,p,m,d,h,b,g,Kc,ga,Pf,fg,pg)}function Rf(i,e){let t=0,n=0,s=bt(i.bands,Mf);for(let r=0;r<s.length;r++){let a=s[r];a.series[0]==e?t=a.dir:a.series[1]==e&&(a.dir==1?n|=1:n|=2)}return[t,n==1?-1:n==2?1:n==3?2:0]}function qM(i,e,t,n,s){let r=i.mode,a=i.series[e],o=r==2?a.facets[1].scale:a.scale,l=i.scales[o];return s==-1?l.min:s==1?l.max:l.distr==3?l.dir==1?l.min:l.max:0}function _s(i,e,t,n,s,r){return fr(i,e,(a,o,l,c,u,f,h,d,g,b,m)=>{let p=a.pxRound,v=c.dir*(c.ori==0?1:-1),E=c.ori==0?ma:ga,S,R;v==1?(S=t,R=n):(S=n,R=t);let A=p(f(o[S],c,b,d)),x=p(h(l[S],u,m,g)),T=p(f(o[R],c,b,d)),k=p(h(r==1?u.max:u.min,u,m,g)),N=new Path2D(s);return E(N,T,k),E(N,A,k),E(N,A,x),N})}function Zc(i,e,t,n,s,r){let a=null;if(i.length>0){a=new Path2D;let o=e==0?Qc:Pf,l=t;for(let f=0;f<i.length;f++){let h=i[f];if(h[1]>h[0]){let d=h[0]-l;d>0&&o(a,l,n,d,n+r),l=h[1]}}let c=t+s-l,u=10;c>0&&o(a,l,n-u/2,c,n+r+u)}return a}function YM(i,e,t){let n=i[i.length-1];n&&n[0]==e?n[1]=t:i.push([e,t])}function Cf(i,e,t,n,s,r,a){let o=[],l=i.length;for(let c=s==1?t:n;c>=t&&c<=n;c+=s)if(e[c]===null){let f=c,h=c;if(s==1)for(;++c<=n&&e[c]===null;)h=c;else for(;--c>=t&&e[c]===null;)h=c;let d=r(i[f]),g=h==f?d:r(i[h]),b=f-s;d=a<=0&&b>=0&&b<l?r(i[b]):d;let p=h+s;g=a>=0&&p>=0&&p<l?r(i[p]):g,g>=d&&o.push([d,g])}return o}function Pm(i){return i==0?km:i==1?gn:e=>or(e,i)}function ug(i){let e=i==0?Jc:Kc,t=i==0?(s,r,a,o,l,c)=>{s.arcTo(r,a,o,l,c)}:(s,r,a,o,l,c)=>{s.arcTo(a,r,l,o,c)},n=i==0?(s,r,a,o,l)=>{s.rect(r,a,o,l)}:(s,r,a,o,l)=>{s.rect(a,r,l,o)};return(s,r,a,o,l,c=0,u=0)=>{c==0&&u==0?n(s,r,a,o,l):(c=Ii(c,o/2,l/2),u=Ii(u,o/2,l/2),e(s,r+c,a),t(s,r+o,a,r+o,a+l,c),t(s,r+o,a+l,r,a+l,u),t(s,r,a+l,r,a,u),t(s,r,a,r+o,a,c),s.closePath())}}var Jc=(i,e,t)=>{i.moveTo(e,t)},Kc=(i,e,t)=>{i.moveTo(t,e)},ma=(i,e,t)=>{i.lineTo(e,t)},ga=(i,e,t)=>{i.lineTo(t,e)},Qc=ug(0),Pf=ug(1),hg=(i,e,t,n,s,r)=>{i.arc(e,t,n,s,r)},fg=(i,e,t,n,s,r)=>{i.arc(t,e,n,s,r)},dg=(i,e,t,n,s,r,a)=>{i.bezierCurveTo(e,t,n,s,r,a)},pg=(i,e,t,n,s,r,a)=>{i.bezierCurveTo(t,e,s,n,a,r)};function mg(i){return(e,t,n,s,r)=>fr(e,t,(a,o,l,c,u,f,h,d,g,b,m)=>{let{pxRound:p,points:v}=a,E,S;c.ori==0?(E=Jc,S=hg):(E=Kc,S=fg);let R=Ut(v.width*wt,3),A=(v.size-v.width)/2*wt,x=Ut(A*2,3),T=new Path2D,k=new Path2D,{left:N,top:L,width:G,height:H}=e.bbox;Qc(k,N-x,L-x,G+x*2,H+x*2);let D=V=>{if(l[V]!=null){let Z=p(f(o[V],c,b,d)),z=p(h(l[V],u,m,g));E(T,Z+A,z),S(T,Z,z,A,0,Vc*2)}};if(r)r.forEach(D);else for(let V=n;V<=s;V++)D(V);return{stroke:R>0?T:null,fill:T,clip:k,flags:da|pf}})}function gg(i){return(e,t,n,s,r,a)=>{n!=s&&(r!=n&&a!=n&&i(e,t,n),r!=s&&a!=s&&i(e,t,s),i(e,t,a))}}var $M=gg(ma),ZM=gg(ga);function _g(i){let e=bt(i?.alignGaps,0);return(t,n,s,r)=>fr(t,n,(a,o,l,c,u,f,h,d,g,b,m)=>{[s,r]=Xc(l,s,r);let p=a.pxRound,v=H=>p(f(H,c,b,d)),E=H=>p(h(H,u,m,g)),S,R;c.ori==0?(S=ma,R=$M):(S=ga,R=ZM);let A=c.dir*(c.ori==0?1:-1),x={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:da},T=x.stroke,k=!1;if(r-s>=b*4){let H=ue=>t.posToVal(ue,c.key,!0),D=null,V=null,Z,z,le,J=v(o[A==1?s:r]),Q=v(o[s]),ie=v(o[r]),he=H(A==1?Q+1:ie-1);for(let ue=A==1?s:r;ue>=s&&ue<=r;ue+=A){let j=o[ue],xe=(A==1?j<he:j>he)?J:v(j),Ee=l[ue];xe==J?Ee!=null?(z=Ee,D==null?(S(T,xe,E(z)),Z=D=V=z):z<D?D=z:z>V&&(V=z)):Ee===null&&(k=!0):(D!=null&&R(T,J,E(D),E(V),E(Z),E(z)),Ee!=null?(z=Ee,S(T,xe,E(z)),D=V=Z=z):(D=V=null,Ee===null&&(k=!0)),J=xe,he=H(J+A))}D!=null&&D!=V&&le!=J&&R(T,J,E(D),E(V),E(Z),E(z))}else for(let H=A==1?s:r;H>=s&&H<=r;H+=A){let D=l[H];D===null?k=!0:D!=null&&S(T,v(o[H]),E(D))}let[L,G]=Rf(t,n);if(a.fill!=null||L!=0){let H=x.fill=new Path2D(T),D=a.fillTo(t,n,a.min,a.max,L),V=E(D),Z=v(o[s]),z=v(o[r]);A==-1&&([z,Z]=[Z,z]),S(H,z,V),S(H,Z,V)}if(!a.spanGaps){let H=[];k&&H.push(...Cf(o,l,s,r,A,v,e)),x.gaps=H=a.gaps(t,n,s,r,H),x.clip=Zc(H,c.ori,d,g,b,m)}return G!=0&&(x.band=G==2?[_s(t,n,s,r,T,-1),_s(t,n,s,r,T,1)]:_s(t,n,s,r,T,G)),x})}function JM(i){let e=bt(i.align,1),t=bt(i.ascDesc,!1),n=bt(i.alignGaps,0),s=bt(i.extend,!1);return(r,a,o,l)=>fr(r,a,(c,u,f,h,d,g,b,m,p,v,E)=>{[o,l]=Xc(f,o,l);let S=c.pxRound,{left:R,width:A}=r.bbox,x=Q=>S(g(Q,h,v,m)),T=Q=>S(b(Q,d,E,p)),k=h.ori==0?ma:ga,N={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:da},L=N.stroke,G=h.dir*(h.ori==0?1:-1),H=T(f[G==1?o:l]),D=x(u[G==1?o:l]),V=D,Z=D;s&&e==-1&&(Z=R,k(L,Z,H)),k(L,D,H);for(let Q=G==1?o:l;Q>=o&&Q<=l;Q+=G){let ie=f[Q];if(ie==null)continue;let he=x(u[Q]),ue=T(ie);e==1?k(L,he,H):k(L,V,ue),k(L,he,ue),H=ue,V=he}let z=V;s&&e==1&&(z=R+A,k(L,z,H));let[le,J]=Rf(r,a);if(c.fill!=null||le!=0){let Q=N.fill=new Path2D(L),ie=c.fillTo(r,a,c.min,c.max,le),he=T(ie);k(Q,z,he),k(Q,Z,he)}if(!c.spanGaps){let Q=[];Q.push(...Cf(u,f,o,l,G,x,n));let ie=c.width*wt/2,he=t||e==1?ie:-ie,ue=t||e==-1?-ie:ie;Q.forEach(j=>{j[0]+=he,j[1]+=ue}),N.gaps=Q=c.gaps(r,a,o,l,Q),N.clip=Zc(Q,h.ori,m,p,v,E)}return J!=0&&(N.band=J==2?[_s(r,a,o,l,L,-1),_s(r,a,o,l,L,1)]:_s(r,a,o,l,L,J)),N})}function Im(i,e,t,n,s,r,a=Ft){if(i.length>1){let o=null;for(let l=0,c=1/0;l<i.length;l++)if(e[l]!==void 0){if(o!=null){let u=_n(i[l]-i[o]);u<c&&(c=u,a=_n(t(i[l],n,s,r)-t(i[o],n,s,r)))}o=l}}return a}function KM(i){i=i||yo;let e=bt(i.size,[.6,Ft,1]),t=i.align||0,n=i.gap||0,s=i.radius;s=s==null?[0,0]:typeof s=="number"?[s,0]:s;let r=gt(s),a=1-e[0],o=bt(e[1],Ft),l=bt(e[2],1),c=bt(i.disp,yo),u=bt(i.each,d=>{}),{fill:f,stroke:h}=c;return(d,g,b,m)=>fr(d,g,(p,v,E,S,R,A,x,T,k,N,L)=>{let G=p.pxRound,H=t,D=n*wt,V=o*wt,Z=l*wt,z,le;S.ori==0?[z,le]=r(d,g):[le,z]=r(d,g);let J=S.dir*(S.ori==0?1:-1),Q=S.ori==0?Qc:Pf,ie=S.ori==0?u:(Ce,qe,it,Me,Dt,ke,Xe)=>{u(Ce,qe,it,Dt,Me,Xe,ke)},he=bt(d.bands,Mf).find(Ce=>Ce.series[0]==g),ue=he!=null?he.dir:0,j=p.fillTo(d,g,p.min,p.max,ue),me=G(x(j,R,L,k)),xe,Ee,Se,He=N,nt=G(p.width*wt),Ve=!1,lt=null,rt=null,et=null,Wt=null;f!=null&&(nt==0||h!=null)&&(Ve=!0,lt=f.values(d,g,b,m),rt=new Map,new Set(lt).forEach(Ce=>{Ce!=null&&rt.set(Ce,new Path2D)}),nt>0&&(et=h.values(d,g,b,m),Wt=new Map,new Set(et).forEach(Ce=>{Ce!=null&&Wt.set(Ce,new Path2D)})));let{x0:Ot,size:tn}=c;if(Ot!=null&&tn!=null){H=1,v=Ot.values(d,g,b,m),Ot.unit==2&&(v=v.map(it=>d.posToVal(T+it*N,S.key,!0)));let Ce=tn.values(d,g,b,m);tn.unit==2?Ee=Ce[0]*N:Ee=A(Ce[0],S,N,T)-A(0,S,N,T),He=Im(v,E,A,S,N,T,He),Se=He-Ee+D}else He=Im(v,E,A,S,N,T,He),Se=He*a+D,Ee=He-Se;Se<1&&(Se=0),nt>=Ee/2&&(nt=0),Se<5&&(G=km);let Pt=Se>0,xn=He-Se-(Pt?nt:0);Ee=G(hf(xn,Z,V)),xe=(H==0?Ee/2:H==J?0:Ee)-H*J*((H==0?D/2:0)+(Pt?nt/2:0));let xt={stroke:null,fill:null,clip:null,band:null,gaps:null,flags:0},fn=Ve?null:new Path2D,$t=null;if(he!=null)$t=d.data[he.series[1]];else{let{y0:Ce,y1:qe}=c;Ce!=null&&qe!=null&&(E=qe.values(d,g,b,m),$t=Ce.values(d,g,b,m))}let nn=z*Ee,U=le*Ee;for(let Ce=J==1?b:m;Ce>=b&&Ce<=m;Ce+=J){let qe=E[Ce];if(qe==null)continue;if($t!=null){let W=$t[Ce]??0;if(qe-W==0)continue;me=x(W,R,L,k)}let it=S.distr!=2||c!=null?v[Ce]:Ce,Me=A(it,S,N,T),Dt=x(bt(qe,j),R,L,k),ke=G(Me-xe),Xe=G(Gn(Dt,me)),C=G(Ii(Dt,me)),y=Xe-C;if(qe!=null){let W=qe<0?U:nn,ce=qe<0?nn:U;Ve?(nt>0&&et[Ce]!=null&&Q(Wt.get(et[Ce]),ke,C+si(nt/2),Ee,Gn(0,y-nt),W,ce),lt[Ce]!=null&&Q(rt.get(lt[Ce]),ke,C+si(nt/2),Ee,Gn(0,y-nt),W,ce)):Q(fn,ke,C+si(nt/2),Ee,Gn(0,y-nt),W,ce),ie(d,g,Ce,ke-nt/2,C,Ee+nt,y)}}return nt>0?xt.stroke=Ve?Wt:fn:Ve||(xt._fill=p.width==0?p._fill:p._stroke??p._fill,xt.width=0),xt.fill=Ve?rt:fn,xt})}function QM(i,e){let t=bt(e?.alignGaps,0);return(n,s,r,a)=>fr(n,s,(o,l,c,u,f,h,d,g,b,m,p)=>{[r,a]=Xc(c,r,a);let v=o.pxRound,E=z=>v(h(z,u,m,g)),S=z=>v(d(z,f,p,b)),R,A,x;u.ori==0?(R=Jc,x=ma,A=dg):(R=Kc,x=ga,A=pg);let T=u.dir*(u.ori==0?1:-1),k=E(l[T==1?r:a]),N=k,L=[],G=[];for(let z=T==1?r:a;z>=r&&z<=a;z+=T)if(c[z]!=null){let J=l[z],Q=E(J);L.push(N=Q),G.push(S(c[z]))}let H={stroke:i(L,G,R,x,A,v),fill:null,clip:null,band:null,gaps:null,flags:da},D=H.stroke,[V,Z]=Rf(n,s);if(o.fill!=null||V!=0){let z=H.fill=new Path2D(D),le=o.fillTo(n,s,o.min,o.max,V),J=S(le);x(z,N,J),x(z,k,J)}if(!o.spanGaps){let z=[];z.push(...Cf(l,c,r,a,T,E,t)),H.gaps=z=o.gaps(n,s,r,a,z),H.clip=Zc(z,u.ori,g,b,m,p)}return Z!=0&&(H.band=Z==2?[_s(n,s,r,a,D,-1),_s(n,s,r,a,D,1)]:_s(n,s,r,a,D,Z)),H})}function jM(i){return QM(ew,i)}function ew(i,e,t,n,s,r){let a=i.length;if(a<2)return null;let o=new Path2D;if(t(o,i[0],e[0]),a==2)n(o,i[1],e[1]);else{let l=Array(a),c=Array(a-1),u=Array(a-1),f=Array(a-1);for(let h=0;h<a-1;h++)u[h]=e[h+1]-e[h],f[h]=i[h+1]-i[h],c[h]=u[h]/f[h];l[0]=c[0];for(let h=1;h<a-1;h++)c[h]===0||c[h-1]===0||c[h-1]>0!=c[h]>0?l[h]=0:(l[h]=3*(f[h-1]+f[h])/((2*f[h]+f[h-1])/c[h-1]+(f[h]+2*f[h-1])/c[h]),isFinite(l[h])||(l[h]=0));l[a-1]=c[a-2];for(let h=0;h<a-1;h++)s(o,i[h]+f[h]/3,e[h]+l[h]*f[h]/3,i[h+1]-f[h]/3,e[h+1]-l[h+1]*f[h]/3,i[h+1],e[h+1])}return o}var mf=new Set;function Lm(){for(let i of mf)i.syncRect(!0)}pa&&(ur(NS,ca,Lm),ur(FS,ca,Lm,!0),ur(Gc,ca,()=>{Rn.pxRatio=wt}));var tw=_g(),nw=mg();function Dm(i,e,t,n){return(n?[i[0],i[1]].concat(i.slice(2)):[i[0]].concat(i.slice(1))).map((r,a)=>gf(r,a,e,t))}function iw(i,e){return i.map((t,n)=>n==0?{}:hn({},e,t))}function gf(i,e,t,n){return hn({},e==0?t:n,i)}function xg(i,e,t){return e==null?ha:[e,t]}var sw=xg;function rw(i,e,t){return e==null?ha:Hc(e,t,bf,!0)}function vg(i,e,t,n){return e==null?ha:qc(e,t,i.scales[n].log,!1)}var aw=vg;function yg(i,e,t,n){return e==null?ha:yf(e,t,i.scales[n].log,!1)}var ow=yg;function lw(i,e,t,n,s){let r=Gn(hm(i),hm(e)),a=e-i,o=Pi(s/n*a,t);do{let l=t[o],c=n*l/a;if(c>=s&&r+(l<5?Vs.get(l):0)<=17)return[l,c]}while(++o<t.length);return[0,0]}function Nm(i){let e,t;return i=i.replace(/(\d+)px/,(n,s)=>(e=gn((t=+s)*wt))+"px"),[i,e,t]}function cw(i){i.show&&[i.font,i.labelFont].forEach(e=>{let t=Ut(e[2]*wt,1);e[0]=e[0].replace(/[0-9.]+px/,t+"px"),e[1]=t})}function Rn(i,e,t){let n={mode:bt(i.mode,1)},s=n.mode;function r(_,M,P,I){let B=M.valToPct(_);return I+P*(M.dir==-1?1-B:B)}function a(_,M,P,I){let B=M.valToPct(_);return I+P*(M.dir==-1?B:1-B)}function o(_,M,P,I){return M.ori==0?r(_,M,P,I):a(_,M,P,I)}n.valToPosH=r,n.valToPosV=a;let l=!1;n.status=0;let c=n.root=gi(gS);if(i.id!=null&&(c.id=i.id),ii(c,i.class),i.title){let _=gi(vS,c);_.textContent=i.title}let u=Ci("canvas"),f=n.ctx=u.getContext("2d"),h=gi(yS,c);ur("click",h,_=>{_.target===g&&(zt!=vr||Xt!=yr)&&Tn.click(n,_)},!0);let d=n.under=gi(bS,h);h.appendChild(u);let g=n.over=gi(SS,h);i=fa(i);let b=+bt(i.pxAlign,1),m=Pm(b);(i.plugins||[]).forEach(_=>{_.opts&&(i=_.opts(n,i)||i)});let p=i.ms||.001,v=n.series=s==1?Dm(i.series||[],Mm,Rm,!1):iw(i.series||[null],Em),E=n.axes=Dm(i.axes||[],Sm,Tm,!0),S=n.scales={},R=n.bands=i.bands||[];R.forEach(_=>{_.fill=gt(_.fill||null),_.dir=bt(_.dir,-1)});let A=s==2?v[1].facets[0].scale:v[0].scale,x={axes:ns,series:ht},T=(i.drawOrder||["axes","series"]).map(_=>x[_]);function k(_){let M=_.distr==3?P=>gs(P>0?P:_.clamp(n,P,_.min,_.max,_.key)):_.distr==4?P=>nf(P,_.asinh):_.distr==100?P=>_.fwd(P):P=>P;return P=>{let I=M(P),{_min:B,_max:$}=_,ae=$-B;return(I-B)/ae}}function N(_){let M=S[_];if(M==null){let P=(i.scales||yo)[_]||yo;if(P.from!=null){N(P.from);let I=hn({},S[P.from],P,{key:_});I.valToPct=k(I),S[_]=I}else{M=S[_]=hn({},_==A?lg:XM,P),M.key=_;let I=M.time,B=M.range,$=ks(B);if((_!=A||s==2&&!I)&&($&&(B[0]==null||B[1]==null)&&(B={min:B[0]==null?lm:{mode:1,hard:B[0],soft:B[0]},max:B[1]==null?lm:{mode:1,hard:B[1],soft:B[1]}},$=!1),!$&&$c(B))){let ae=B;B=(fe,ye,De)=>ye==null?ha:Hc(ye,De,ae)}M.range=gt(B||(I?sw:_==A?M.distr==3?aw:M.distr==4?ow:xg:M.distr==3?vg:M.distr==4?yg:rw)),M.auto=gt($?!1:M.auto),M.clamp=gt(M.clamp||WM),M._min=M._max=null,M.valToPct=k(M)}}}N("x"),N("y"),s==1&&v.forEach(_=>{N(_.scale)}),E.forEach(_=>{N(_.scale)});for(let _ in i.scales)N(_);let L=S[A],G=L.distr,H,D;L.ori==0?(ii(c,_S),H=r,D=a):(ii(c,xS),H=a,D=r);let V={};for(let _ in S){let M=S[_];(M.min!=null||M.max!=null)&&(V[_]={min:M.min,max:M.max},M.min=M.max=null)}let Z=i.tzDate||(_=>new Date(gn(_/p))),z=i.fmtDate||wf,le=p==1?_M(Z):yM(Z),J=vm(Z,xm(p==1?gM:vM,z)),Q=bm(Z,ym(SM,z)),ie=[],he=n.legend=hn({},TM,i.legend),ue=n.cursor=hn({},IM,{drag:{y:s==2}},i.cursor),j=he.show,me=ue.show,xe=he.markers;he.idxs=ie,xe.width=gt(xe.width),xe.dash=gt(xe.dash),xe.stroke=gt(xe.stroke),xe.fill=gt(xe.fill);let Ee,Se,He,nt=[],Ve=[],lt,rt=!1,et={};if(he.live){let _=v[1]?v[1].values:null;rt=_!=null,lt=rt?_(n,1,0):{_:0};for(let M in lt)et[M]=xf}if(j)if(Ee=Ci("table",RS,c),He=Ci("tbody",null,Ee),he.mount(n,Ee),rt){Se=Ci("thead",null,Ee,He);let _=Ci("tr",null,Se);Ci("th",null,_);for(var Wt in lt)Ci("th",Z0,_).textContent=Wt}else ii(Ee,PS),he.live&&ii(Ee,CS);let Ot={show:!0},tn={show:!1};function Pt(_,M){if(M==0&&(rt||!he.live||s==2))return ha;let P=[],I=Ci("tr",IS,He,He.childNodes[M]);ii(I,_.class),_.show||ii(I,cr);let B=Ci("th",null,I);if(xe.show){let fe=gi(LS,B);if(M>0){let ye=xe.width(n,M);ye&&(fe.style.border=ye+"px "+xe.dash(n,M)+" "+xe.stroke(n,M)),fe.style.background=xe.fill(n,M)}}let $=gi(Z0,B);_.label instanceof HTMLElement?$.appendChild(_.label):$.textContent=_.label,M>0&&(xe.show||($.style.color=_.width>0?xe.stroke(n,M):xe.fill(n,M)),xt("click",B,fe=>{if(ue._lock)return;Ze(fe);let ye=v.indexOf(_);if((fe.ctrlKey||fe.metaKey)!=he.isolate){let De=v.some((Ne,Ue)=>Ue>0&&Ue!=ye&&Ne.show);v.forEach((Ne,Ue)=>{Ue>0&&Fi(Ue,De?Ue==ye?Ot:tn:Ot,!0,on.setSeries)})}else Fi(ye,{show:!_.show},!0,on.setSeries)},!1),Je&&xt(j0,B,fe=>{ue._lock||(Ze(fe),Fi(v.indexOf(_),Sr,!0,on.setSeries))},!1));for(var ae in lt){let fe=Ci("td",DS,I);fe.textContent="--",P.push(fe)}return[I,P]}let xn=new Map;function xt(_,M,P,I=!0){let B=xn.get(M)||{},$=ue.bind[_](n,M,P,I);$&&(ur(_,M,B[_]=$),xn.set(M,B))}function fn(_,M,P){let I=xn.get(M)||{};for(let B in I)(_==null||B==_)&&(uf(B,M,I[B]),delete I[B]);_==null&&xn.delete(M)}let $t=0,nn=0,U=0,Ce=0,qe=0,it=0,Me=qe,Dt=it,ke=U,Xe=Ce,C=0,y=0,W=0,ce=0;n.bbox={};let re=!1,_e=!1,ve=!1,ee=!1,ne=!1,de=!1;function F(_,M,P){(P||_!=n.width||M!=n.height)&&se(_,M),at(!1),ve=!0,_e=!0,Cn()}function se(_,M){n.width=$t=U=_,n.height=nn=Ce=M,qe=it=0,be(),Ge();let P=n.bbox;C=P.left=or(qe*wt,.5),y=P.top=or(it*wt,.5),W=P.width=or(U*wt,.5),ce=P.height=or(Ce*wt,.5)}let te=3;function we(){let _=!1,M=0;for(;!_;){M++;let P=gr(M),I=Ni(M);_=M==te||P&&I,_||(se(n.width,n.height),_e=!0)}}function ge({width:_,height:M}){F(_,M)}n.setSize=ge;function be(){let _=!1,M=!1,P=!1,I=!1;E.forEach((B,$)=>{if(B.show&&B._show){let{side:ae,_size:fe}=B,ye=ae%2,De=B.label!=null?B.labelSize:0,Ne=fe+De;Ne>0&&(ye?(U-=Ne,ae==3?(qe+=Ne,I=!0):P=!0):(Ce-=Ne,ae==0?(it+=Ne,_=!0):M=!0))}}),Li[0]=_,Li[1]=P,Li[2]=M,Li[3]=I,U-=xi[1]+xi[3],qe+=xi[3],Ce-=xi[2]+xi[0],it+=xi[0]}function Ge(){let _=qe+U,M=it+Ce,P=qe,I=it;function B($,ae){switch($){case 1:return _+=ae,_-ae;case 2:return M+=ae,M-ae;case 3:return P-=ae,P+ae;case 0:return I-=ae,I+ae}}E.forEach(($,ae)=>{if($.show&&$._show){let fe=$.side;$._pos=B(fe,$._size),$.label!=null&&($._lpos=B(fe,$.labelSize))}})}if(ue.dataIdx==null){let _=ue.hover,M=_.skip=new Set(_.skip??[]);M.add(void 0);let P=_.prox=gt(_.prox),I=_.bias??=0;ue.dataIdx=(B,$,ae,fe)=>{if($==0)return ae;let ye=ae,De=P(B,$,ae,fe)??Ft,Ne=De>=0&&De<Ft,Ue=L.ori==0?U:Ce,tt=ue.left,St=e[0],yt=e[$];if(M.has(yt[ae])){ye=null;let ft=null,Ye=null,We;if(I==0||I==-1)for(We=ae;ft==null&&We-- >0;)M.has(yt[We])||(ft=We);if(I==0||I==1)for(We=ae;Ye==null&&We++<yt.length;)M.has(yt[We])||(Ye=We);if(ft!=null||Ye!=null)if(Ne){let Vt=ft==null?-1/0:H(St[ft],L,Ue,0),Kt=Ye==null?1/0:H(St[Ye],L,Ue,0),Sn=tt-Vt,It=Kt-tt;Sn<=It?Sn<=De&&(ye=ft):It<=De&&(ye=Ye)}else ye=Ye==null?ft:ft==null?Ye:ae-ft<=Ye-ae?ft:Ye}else Ne&&_n(tt-H(St[ae],L,Ue,0))>De&&(ye=null);return ye}}let Ze=_=>{ue.event=_};ue.idxs=ie,ue._lock=!1;let oe=ue.points;oe.show=gt(oe.show),oe.size=gt(oe.size),oe.stroke=gt(oe.stroke),oe.width=gt(oe.width),oe.fill=gt(oe.fill);let Oe=n.focus=hn({},i.focus||{alpha:.3},ue.focus),Je=Oe.prox>=0,Re=Je&&oe.one,st=[],Bt=[],Fn=[];function _a(_,M){let P=oe.show(n,M);if(P instanceof HTMLElement)return ii(P,ES),ii(P,_.class),Qi(P,-10,-10,U,Ce),g.insertBefore(P,st[M]),P}function dr(_,M){if(s==1||M>0){let P=s==1&&S[_.scale].time,I=_.value;_.value=P?pm(I)?bm(Z,ym(I,z)):I||Q:I||VM,_.label=_.label||(P?DM:LM)}if(Re||M>0){_.width=_.width==null?1:_.width,_.paths=_.paths||tw||XS,_.fillTo=gt(_.fillTo||qM),_.pxAlign=+bt(_.pxAlign,b),_.pxRound=Pm(_.pxAlign),_.stroke=gt(_.stroke||null),_.fill=gt(_.fill||null),_._stroke=_._fill=_._paths=_._focus=null;let P=GM(Gn(1,_.width),1),I=_.points=hn({},{size:P,width:Gn(1,P*.2),stroke:_.stroke,space:P*2,paths:nw,_stroke:null,_fill:null},_.points);I.show=gt(I.show),I.filter=gt(I.filter),I.fill=gt(I.fill),I.stroke=gt(I.stroke),I.paths=gt(I.paths),I.pxAlign=_.pxAlign}if(j){let P=Pt(_,M);nt.splice(M,0,P[0]),Ve.splice(M,0,P[1]),he.values.push(null)}if(me){ie.splice(M,0,null);let P=null;Re?M==0&&(P=_a(_,M)):M>0&&(P=_a(_,M)),st.splice(M,0,P),Bt.splice(M,0,0),Fn.splice(M,0,0)}bn("addSeries",M)}function tu(_,M){M=M??v.length,_=s==1?gf(_,M,Mm,Rm):gf(_,M,{},Em),v.splice(M,0,_),dr(v[M],M)}n.addSeries=tu;function Mo(_){if(v.splice(_,1),j){he.values.splice(_,1),Ve.splice(_,1);let M=nt.splice(_,1)[0];fn(null,M.firstChild),M.remove()}me&&(ie.splice(_,1),st.splice(_,1)[0].remove(),Bt.splice(_,1),Fn.splice(_,1)),bn("delSeries",_)}n.delSeries=Mo;let Li=[!1,!1,!1,!1];function ji(_,M){if(_._show=_.show,_.show){let P=_.side%2,I=S[_.scale];I==null&&(_.scale=P?v[1].scale:A,I=S[_.scale]);let B=I.time;_.size=gt(_.size),_.space=gt(_.space),_.rotate=gt(_.rotate),ks(_.incrs)&&_.incrs.forEach(ae=>{!Vs.has(ae)&&Vs.set(ae,Hm(ae))}),_.incrs=gt(_.incrs||(I.distr==2?dM:B?p==1?mM:xM:lr)),_.splits=gt(_.splits||(B&&I.distr==1?le:I.distr==3?ff:I.distr==4?UM:FM)),_.stroke=gt(_.stroke),_.grid.stroke=gt(_.grid.stroke),_.ticks.stroke=gt(_.ticks.stroke),_.border.stroke=gt(_.border.stroke);let $=_.values;_.values=ks($)&&!ks($[0])?gt($):B?ks($)?vm(Z,xm($,z)):pm($)?bM(Z,$):$||J:$||NM,_.filter=gt(_.filter||(I.distr>=3&&I.log==10?zM:I.distr==3&&I.log==2?kM:Vm)),_.font=Nm(_.font),_.labelFont=Nm(_.labelFont),_._size=_.size(n,null,M,0),_._space=_._rotate=_._incrs=_._found=_._splits=_._values=null,_._size>0&&(Li[M]=!0,_._el=gi(MS,h))}}function es(_,M,P,I){let[B,$,ae,fe]=P,ye=M%2,De=0;return ye==0&&(fe||$)&&(De=M==0&&!B||M==2&&!ae?gn(Sm.size/3):0),ye==1&&(B||ae)&&(De=M==1&&!$||M==3&&!fe?gn(Tm.size/2):0),De}let xa=n.padding=(i.padding||[es,es,es,es]).map(_=>gt(bt(_,es))),xi=n._padding=xa.map((_,M)=>_(n,M,Li,0)),Zt,jt=null,en=null,Di=s==1?v[0].idxs:null,Yn=null,xs=!1;function va(_,M){if(e=_??[],n.data=n._data=e,s==2){Zt=0;for(let P=1;P<v.length;P++)Zt+=e[P][0].length}else{e.length==0&&(n.data=n._data=e=[[]]),Yn=e[0],Zt=Yn.length;let P=e;if(G==2){P=e.slice();let I=P[0]=Array(Zt);for(let B=0;B<Zt;B++)I[B]=B}n._data=e=P}if(at(!0),bn("setData"),G==2&&(ve=!0),M!==!1){let P=L;P.auto(n,xs)?ya():bs(A,P.min,P.max),ee=ee||ue.left>=0,de=!0,Cn()}}n.setData=va;function ya(){xs=!0;let _,M;s==1&&(Zt>0?(jt=Di[0]=0,en=Di[1]=Zt-1,_=e[0][jt],M=e[0][en],G==2?(_=jt,M=en):_==M&&(G==3?[_,M]=qc(_,_,L.log,!1):G==4?[_,M]=yf(_,_,L.log,!1):L.time?M=_+gn(86400/p):[_,M]=Hc(_,M,bf,!0))):(jt=Di[0]=_=null,en=Di[1]=M=null)),bs(A,_,M)}let pr,vs,mr,w,O,K,X,q,Te,Pe;function Ae(_,M,P,I,B,$){_??=K0,P??=Mf,I??="butt",B??=K0,$??="round",_!=pr&&(f.strokeStyle=pr=_),B!=vs&&(f.fillStyle=vs=B),M!=mr&&(f.lineWidth=mr=M),$!=O&&(f.lineJoin=O=$),I!=K&&(f.lineCap=K=I),P!=w&&f.setLineDash(w=P)}function Ie(_,M,P,I){M!=vs&&(f.fillStyle=vs=M),_!=X&&(f.font=X=_),P!=q&&(f.textAlign=q=P),I!=Te&&(f.textBaseline=Te=I)}function ze(_,M,P,I,B=0){if(I.length>0&&_.auto(n,xs)&&(M==null||M.min==null)){let $=bt(jt,0),ae=bt(en,I.length-1),fe=P.min==null?zS(I,$,ae,B,_.distr==3):[P.min,P.max];_.min=Ii(_.min,P.min=fe[0]),_.max=Gn(_.max,P.max=fe[1])}}let Ke={min:null,max:null};function ut(){for(let I in S){let B=S[I];V[I]==null&&(B.min==null||V[A]!=null&&B.auto(n,xs))&&(V[I]=Ke)}for(let I in S){let B=S[I];V[I]==null&&B.from!=null&&V[B.from]!=null&&(V[I]=Ke)}V[A]!=null&&at(!0);let _={};for(let I in V){let B=V[I];if(B!=null){let $=_[I]=fa(S[I],$S);if(B.min!=null)hn($,B);else if(I!=A||s==2)if(Zt==0&&$.from==null){let ae=$.range(n,null,null,I);$.min=ae[0],$.max=ae[1]}else $.min=Ft,$.max=-Ft}}if(Zt>0){v.forEach((I,B)=>{if(s==1){let $=I.scale,ae=V[$];if(ae==null)return;let fe=_[$];if(B==0){let ye=fe.range(n,fe.min,fe.max,$);fe.min=ye[0],fe.max=ye[1],jt=Pi(fe.min,e[0]),en=Pi(fe.max,e[0]),en-jt>1&&(e[0][jt]<fe.min&&jt++,e[0][en]>fe.max&&en--),I.min=Yn[jt],I.max=Yn[en]}else I.show&&I.auto&&ze(fe,ae,I,e[B],I.sorted);I.idxs[0]=jt,I.idxs[1]=en}else if(B>0&&I.show&&I.auto){let[$,ae]=I.facets,fe=$.scale,ye=ae.scale,[De,Ne]=e[B],Ue=_[fe],tt=_[ye];Ue!=null&&ze(Ue,V[fe],$,De,$.sorted),tt!=null&&ze(tt,V[ye],ae,Ne,ae.sorted),I.min=ae.min,I.max=ae.max}});for(let I in _){let B=_[I],$=V[I];if(B.from==null&&($==null||$.min==null)){let ae=B.range(n,B.min==Ft?null:B.min,B.max==-Ft?null:B.max,I);B.min=ae[0],B.max=ae[1]}}}for(let I in _){let B=_[I];if(B.from!=null){let $=_[B.from];if($.min==null)B.min=B.max=null;else{let ae=B.range(n,$.min,$.max,I);B.min=ae[0],B.max=ae[1]}}}let M={},P=!1;for(let I in _){let B=_[I],$=S[I];if($.min!=B.min||$.max!=B.max){$.min=B.min,$.max=B.max;let ae=$.distr;$._min=ae==3?gs($.min):ae==4?nf($.min,$.asinh):ae==100?$.fwd($.min):$.min,$._max=ae==3?gs($.max):ae==4?nf($.max,$.asinh):ae==100?$.fwd($.max):$.max,M[I]=P=!0}}if(P){v.forEach((I,B)=>{s==2?B>0&&M.y&&(I._paths=null):M[I.scale]&&(I._paths=null)});for(let I in M)ve=!0,bn("setScale",I);me&&ue.left>=0&&(ee=de=!0)}for(let I in V)V[I]=null}function Be(_){let M=hf(jt-1,0,Zt-1),P=hf(en+1,0,Zt-1);for(;_[M]==null&&M>0;)M--;for(;_[P]==null&&P<Zt-1;)P++;return[M,P]}function ht(){if(Zt>0){let _=v.some(M=>M._focus)&&Pe!=Oe.alpha;_&&(f.globalAlpha=Pe=Oe.alpha),v.forEach((M,P)=>{if(P>0&&M.show&&(qt(P,!1),qt(P,!0),M._paths==null)){let I=Pe;Pe!=M.alpha&&(f.globalAlpha=Pe=M.alpha);let B=s==2?[0,e[P][0].length-1]:Be(e[P]);M._paths=M.paths(n,P,B[0],B[1]),Pe!=I&&(f.globalAlpha=Pe=I)}}),v.forEach((M,P)=>{if(P>0&&M.show){let I=Pe;Pe!=M.alpha&&(f.globalAlpha=Pe=M.alpha),M._paths!=null&&Et(P,!1);{let B=M._paths!=null?M._paths.gaps:null,$=M.points.show(n,P,jt,en,B),ae=M.points.filter(n,P,$,B);($||ae)&&(M.points._paths=M.points.paths(n,P,jt,en,ae),Et(P,!0))}Pe!=I&&(f.globalAlpha=Pe=I),bn("drawSeries",P)}}),_&&(f.globalAlpha=Pe=1)}}function qt(_,M){let P=M?v[_].points:v[_];P._stroke=P.stroke(n,_),P._fill=P.fill(n,_)}function Et(_,M){let P=M?v[_].points:v[_],{stroke:I,fill:B,clip:$,flags:ae,_stroke:fe=P._stroke,_fill:ye=P._fill,_width:De=P.width}=P._paths;De=Ut(De*wt,3);let Ne=null,Ue=De%2/2;M&&ye==null&&(ye=De>0?"#fff":fe);let tt=P.pxAlign==1&&Ue>0;if(tt&&f.translate(Ue,Ue),!M){let St=C-De/2,yt=y-De/2,ft=W+De,Ye=ce+De;Ne=new Path2D,Ne.rect(St,yt,ft,Ye)}M?Fe(fe,De,P.dash,P.cap,ye,I,B,ae,$):Rt(_,fe,De,P.dash,P.cap,ye,I,B,ae,Ne,$),tt&&f.translate(-Ue,-Ue)}function Rt(_,M,P,I,B,$,ae,fe,ye,De,Ne){let Ue=!1;ye!=0&&R.forEach((tt,St)=>{if(tt.series[0]==_){let yt=v[tt.series[1]],ft=e[tt.series[1]],Ye=(yt._paths||yo).band;ks(Ye)&&(Ye=tt.dir==1?Ye[0]:Ye[1]);let We,Vt=null;yt.show&&Ye&&VS(ft,jt,en)?(Vt=tt.fill(n,St)||$,We=yt._paths.clip):Ye=null,Fe(M,P,I,B,Vt,ae,fe,ye,De,Ne,We,Ye),Ue=!0}}),Ue||Fe(M,P,I,B,$,ae,fe,ye,De,Ne)}let dn=da|pf;function Fe(_,M,P,I,B,$,ae,fe,ye,De,Ne,Ue){Ae(_,M,P,I,B),(ye||De||Ue)&&(f.save(),ye&&f.clip(ye),De&&f.clip(De)),Ue?(fe&dn)==dn?(f.clip(Ue),Ne&&f.clip(Ne),pt(B,ae),sn(_,$,M)):fe&pf?(pt(B,ae),f.clip(Ue),sn(_,$,M)):fe&da&&(f.save(),f.clip(Ue),Ne&&f.clip(Ne),pt(B,ae),f.restore(),sn(_,$,M)):(pt(B,ae),sn(_,$,M)),(ye||De||Ue)&&f.restore()}function sn(_,M,P){P>0&&(M instanceof Map?M.forEach((I,B)=>{f.strokeStyle=pr=B,f.stroke(I)}):M!=null&&_&&f.stroke(M))}function pt(_,M){M instanceof Map?M.forEach((P,I)=>{f.fillStyle=vs=I,f.fill(P)}):M!=null&&_&&f.fill(M)}function ts(_,M,P,I){let B=E[_],$;if(I<=0)$=[0,0];else{let ae=B._space=B.space(n,_,M,P,I),fe=B._incrs=B.incrs(n,_,M,P,I,ae);$=lw(M,P,fe,I,ae)}return B._found=$}function rn(_,M,P,I,B,$,ae,fe,ye,De){let Ne=ae%2/2;b==1&&f.translate(Ne,Ne),Ae(fe,ae,ye,De,fe),f.beginPath();let Ue,tt,St,yt,ft=B+(I==0||I==3?-$:$);P==0?(tt=B,yt=ft):(Ue=B,St=ft);for(let Ye=0;Ye<_.length;Ye++)M[Ye]!=null&&(P==0?Ue=St=_[Ye]:tt=yt=_[Ye],f.moveTo(Ue,tt),f.lineTo(St,yt));f.stroke(),b==1&&f.translate(-Ne,-Ne)}function gr(_){let M=!0;return E.forEach((P,I)=>{if(!P.show)return;let B=S[P.scale];if(B.min==null){P._show&&(M=!1,P._show=!1,at(!1));return}else P._show||(M=!1,P._show=!0,at(!1));let $=P.side,ae=$%2,{min:fe,max:ye}=B,[De,Ne]=ts(I,fe,ye,ae==0?U:Ce);if(Ne==0)return;let Ue=B.distr==2,tt=P._splits=P.splits(n,I,fe,ye,De,Ne,Ue),St=B.distr==2?tt.map(We=>Yn[We]):tt,yt=B.distr==2?Yn[tt[1]]-Yn[tt[0]]:De,ft=P._values=P.values(n,P.filter(n,St,I,Ne,yt),I,Ne,yt);P._rotate=$==2?P.rotate(n,ft,I,Ne):0;let Ye=P._size;P._size=_i(P.size(n,ft,I,_)),Ye!=null&&P._size!=Ye&&(M=!1)}),M}function Ni(_){let M=!0;return xa.forEach((P,I)=>{let B=P(n,I,Li,_);B!=xi[I]&&(M=!1),xi[I]=B}),M}function ns(){for(let _=0;_<E.length;_++){let M=E[_];if(!M.show||!M._show)continue;let P=M.side,I=P%2,B,$,ae=M.stroke(n,_),fe=P==0||P==3?-1:1,[ye,De]=M._found;if(M.label!=null){let Bn=M.labelGap*fe,Jn=gn((M._lpos+Bn)*wt);Ie(M.labelFont[0],ae,"center",P==2?"top":J0),f.save(),I==1?(B=$=0,f.translate(Jn,gn(y+ce/2)),f.rotate((P==3?-Vc:Vc)/2)):(B=gn(C+W/2),$=Jn);let Ws=zm(M.label)?M.label(n,_,ye,De):M.label;f.fillText(Ws,B,$),f.restore()}if(De==0)continue;let Ne=S[M.scale],Ue=I==0?W:ce,tt=I==0?C:y,St=M._splits,yt=Ne.distr==2?St.map(Bn=>Yn[Bn]):St,ft=Ne.distr==2?Yn[St[1]]-Yn[St[0]]:ye,Ye=M.ticks,We=M.border,Vt=Ye.show?Ye.size:0,Kt=gn(Vt*wt),Sn=gn((M.alignTo==2?M._size-Vt-M.gap:M.gap)*wt),It=M._rotate*-Vc/180,Qt=m(M._pos*wt),$n=(Kt+Sn)*fe,On=Qt+$n;$=I==0?On:0,B=I==1?On:0;let ai=M.font[0],vi=M.align==1?oa:M.align==2?jh:It>0?oa:It<0?jh:I==0?"center":P==3?jh:oa,Oi=It||I==1?"middle":P==2?"top":J0;Ie(ai,ae,vi,Oi);let Zn=M.font[1]*M.lineGap,oi=St.map(Bn=>m(o(Bn,Ne,Ue,tt))),yi=M._values;for(let Bn=0;Bn<yi.length;Bn++){let Jn=yi[Bn];if(Jn!=null){I==0?B=oi[Bn]:$=oi[Bn],Jn=""+Jn;let Ws=Jn.indexOf(`
`)==-1?[Jn]:Jn.split(/\n/gm);for(let zn=0;zn<Ws.length;zn++){let Kf=Ws[zn];It?(f.save(),f.translate(B,$+zn*Zn),f.rotate(It),f.fillText(Kf,0,0),f.restore()):f.fillText(Kf,B,$+zn*Zn)}}}Ye.show&&rn(oi,Ye.filter(n,yt,_,De,ft),I,P,Qt,Kt,Ut(Ye.width*wt,3),Ye.stroke(n,_),Ye.dash,Ye.cap);let Bi=M.grid;Bi.show&&rn(oi,Bi.filter(n,yt,_,De,ft),I,I==0?2:1,I==0?y:C,I==0?ce:W,Ut(Bi.width*wt,3),Bi.stroke(n,_),Bi.dash,Bi.cap),We.show&&rn([Qt],[1],I==0?1:0,I==0?1:2,I==1?y:C,I==1?ce:W,Ut(We.width*wt,3),We.stroke(n,_),We.dash,We.cap)}bn("drawAxes")}function at(_){v.forEach((M,P)=>{P>0&&(M._paths=null,_&&(s==1?(M.min=null,M.max=null):M.facets.forEach(I=>{I.min=null,I.max=null})))})}let Jt=!1,Un=!1,Ct=[];function an(){Un=!1;for(let _=0;_<Ct.length;_++)bn(...Ct[_]);Ct.length=0}function Cn(){Jt||(tM(Df),Jt=!0)}function wo(_,M=!1){Jt=!0,Un=M,_(n),Df(),M&&Ct.length>0&&queueMicrotask(an)}n.batch=wo;function Df(){if(re&&(ut(),re=!1),ve&&(we(),ve=!1),_e){if(Ht(d,oa,qe),Ht(d,"top",it),Ht(d,go,U),Ht(d,_o,Ce),Ht(g,oa,qe),Ht(g,"top",it),Ht(g,go,U),Ht(g,_o,Ce),Ht(h,go,$t),Ht(h,_o,nn),u.width=gn($t*wt),u.height=gn(nn*wt),E.forEach(({_el:_,_show:M,_size:P,_pos:I,side:B})=>{if(_!=null)if(M){let $=B===3||B===0?P:0,ae=B%2==1;Ht(_,ae?"left":"top",I-$),Ht(_,ae?"width":"height",P),Ht(_,ae?"top":"left",ae?it:qe),Ht(_,ae?"height":"width",ae?Ce:U),cf(_,cr)}else ii(_,cr)}),pr=vs=mr=O=K=X=q=Te=w=null,Pe=1,Ma(!0),qe!=Me||it!=Dt||U!=ke||Ce!=Xe){at(!1);let _=U/ke,M=Ce/Xe;if(me&&!ee&&ue.left>=0){ue.left*=_,ue.top*=M,_r&&Qi(_r,gn(ue.left),0,U,Ce),xr&&Qi(xr,0,gn(ue.top),U,Ce);for(let P=0;P<st.length;P++){let I=st[P];I!=null&&(Bt[P]*=_,Fn[P]*=M,Qi(I,_i(Bt[P]),_i(Fn[P]),U,Ce))}}if(kt.show&&!ne&&kt.left>=0&&kt.width>0){kt.left*=_,kt.width*=_,kt.top*=M,kt.height*=M;for(let P in ou)Ht(br,P,kt[P])}Me=qe,Dt=it,ke=U,Xe=Ce}bn("setSize"),_e=!1}$t>0&&nn>0&&(f.clearRect(0,0,u.width,u.height),bn("drawClear"),T.forEach(_=>_()),bn("draw")),kt.show&&ne&&(To(kt),ne=!1),me&&ee&&(Hs(null,!0,!1),ee=!1),he.show&&he.live&&de&&(ru(),de=!1),l||(l=!0,n.status=1,bn("ready")),xs=!1,Jt=!1}n.redraw=(_,M)=>{ve=M||!1,_!==!1?bs(A,L.min,L.max):Cn()};function nu(_,M){let P=S[_];if(P.from==null){if(Zt==0){let I=P.range(n,M.min,M.max,_);M.min=I[0],M.max=I[1]}if(M.min>M.max){let I=M.min;M.min=M.max,M.max=I}if(Zt>1&&M.min!=null&&M.max!=null&&M.max-M.min<1e-16)return;_==A&&P.distr==2&&Zt>0&&(M.min=Pi(M.min,e[0]),M.max=Pi(M.max,e[0]),M.min==M.max&&M.max++),V[_]=M,re=!0,Cn()}}n.setScale=nu;let iu,su,_r,xr,Nf,Ff,vr,yr,Uf,Of,zt,Xt,ys=!1,Tn=ue.drag,vn=Tn.x,yn=Tn.y;me&&(ue.x&&(iu=gi(TS,g)),ue.y&&(su=gi(AS,g)),L.ori==0?(_r=iu,xr=su):(_r=su,xr=iu),zt=ue.left,Xt=ue.top);let kt=n.select=hn({show:!0,over:!0,left:0,width:0,top:0,height:0},i.select),br=kt.show?gi(wS,kt.over?g:d):null;function To(_,M){if(kt.show){for(let P in _)kt[P]=_[P],P in ou&&Ht(br,P,_[P]);M!==!1&&bn("setSelect")}}n.setSelect=To;function Pg(_){if(v[_].show)j&&cf(nt[_],cr);else if(j&&ii(nt[_],cr),me){let P=Re?st[0]:st[_];P!=null&&Qi(P,-10,-10,U,Ce)}}function bs(_,M,P){nu(_,{min:M,max:P})}function Fi(_,M,P,I){M.focus!=null&&Fg(_),M.show!=null&&v.forEach((B,$)=>{$>0&&(_==$||_==null)&&(B.show=M.show,Pg($),s==2?(bs(B.facets[0].scale,null,null),bs(B.facets[1].scale,null,null)):bs(B.scale,null,null),Cn())}),P!==!1&&bn("setSeries",_,M),I&&wa("setSeries",n,_,M)}n.setSeries=Fi;function Ig(_,M){hn(R[_],M)}function Lg(_,M){_.fill=gt(_.fill||null),_.dir=bt(_.dir,-1),M=M??R.length,R.splice(M,0,_)}function Dg(_){_==null?R.length=0:R.splice(_,1)}n.addBand=Lg,n.setBand=Ig,n.delBand=Dg;function Ng(_,M){v[_].alpha=M,me&&st[_]!=null&&(st[_].style.opacity=M),j&&nt[_]&&(nt[_].style.opacity=M)}let is,Ss,Gs,Sr={focus:!0};function Fg(_){if(_!=Gs){let M=_==null,P=Oe.alpha!=1;v.forEach((I,B)=>{if(s==1||B>0){let $=M||B==0||B==_;I._focus=M?null:$,P&&Ng(B,$?1:Oe.alpha)}}),Gs=_,P&&Cn()}}j&&Je&&xt(em,Ee,_=>{ue._lock||(Ze(_),Gs!=null&&Fi(null,Sr,!0,on.setSeries))});function Ui(_,M,P){let I=S[M];P&&(_=_/wt-(I.ori==1?it:qe));let B=U;I.ori==1&&(B=Ce,_=B-_),I.dir==-1&&(_=B-_);let $=I._min,ae=I._max,fe=_/B,ye=$+(ae-$)*fe,De=I.distr;return De==3?ua(10,ye):De==4?HS(ye,I.asinh):De==100?I.bwd(ye):ye}function Ug(_,M){let P=Ui(_,A,M);return Pi(P,e[0],jt,en)}n.valToIdx=_=>Pi(_,e[0]),n.posToIdx=Ug,n.posToVal=Ui,n.valToPos=(_,M,P)=>S[M].ori==0?r(_,S[M],P?W:U,P?C:0):a(_,S[M],P?ce:Ce,P?y:0),n.setCursor=(_,M,P)=>{zt=_.left,Xt=_.top,Hs(null,M,P)};function Bf(_,M){Ht(br,oa,kt.left=_),Ht(br,go,kt.width=M)}function zf(_,M){Ht(br,"top",kt.top=_),Ht(br,_o,kt.height=M)}let ba=L.ori==0?Bf:zf,Sa=L.ori==1?Bf:zf;function Og(){if(j&&he.live)for(let _=s==2?1:0;_<v.length;_++){if(_==0&&rt)continue;let M=he.values[_],P=0;for(let I in M)Ve[_][P++].firstChild.nodeValue=M[I]}}function ru(_,M){if(_!=null&&(_.idxs?_.idxs.forEach((P,I)=>{ie[I]=P}):YS(_.idx)||ie.fill(_.idx),he.idx=ie[0]),j&&he.live){for(let P=0;P<v.length;P++)(P>0||s==1&&!rt)&&Bg(P,ie[P]);Og()}de=!1,M!==!1&&bn("setLegend")}n.setLegend=ru;function Bg(_,M){let P=v[_],I=_==0&&G==2?Yn:e[_],B;rt?B=P.values(n,_,M)??et:(B=P.value(n,M==null?null:I[M],_,M),B=B==null?et:{_:B}),he.values[_]=B}function Hs(_,M,P){Uf=zt,Of=Xt,[zt,Xt]=ue.move(n,zt,Xt),ue.left=zt,ue.top=Xt,me&&(_r&&Qi(_r,gn(zt),0,U,Ce),xr&&Qi(xr,0,gn(Xt),U,Ce));let I,B=jt>en;is=Ft,Ss=null;let $=L.ori==0?U:Ce,ae=L.ori==1?U:Ce;if(zt<0||Zt==0||B){I=ue.idx=null;for(let fe=0;fe<v.length;fe++){let ye=st[fe];ye!=null&&Qi(ye,-10,-10,U,Ce)}Je&&Fi(null,Sr,!0,_==null&&on.setSeries),he.live&&(ie.fill(I),de=!0)}else{let fe,ye,De;s==1&&(fe=L.ori==0?zt:Xt,ye=Ui(fe,A),I=ue.idx=Pi(ye,e[0],jt,en),De=H(e[0][I],L,$,0));let Ne=-10,Ue=-10,tt=0,St=0,yt=!0,ft="",Ye="";for(let We=s==2?1:0;We<v.length;We++){let Vt=v[We],Kt=ie[We],Sn=Kt==null?null:s==1?e[We][Kt]:e[We][1][Kt],It=ue.dataIdx(n,We,I,ye),Qt=It==null?null:s==1?e[We][It]:e[We][1][It];if(de=de||Qt!=Sn||It!=Kt,ie[We]=It,We>0&&Vt.show){let $n=It==null?-10:It==I?De:H(s==1?e[0][It]:e[We][0][It],L,$,0),On=Qt==null?-10:D(Qt,s==1?S[Vt.scale]:S[Vt.facets[1].scale],ae,0);if(Je&&Qt!=null){let ai=L.ori==1?zt:Xt,vi=_n(Oe.dist(n,We,It,On,ai));if(vi<is){let Oi=Oe.bias;if(Oi!=0){let Zn=Ui(ai,Vt.scale),oi=Qt>=0?1:-1,yi=Zn>=0?1:-1;yi==oi&&(yi==1?Oi==1?Qt>=Zn:Qt<=Zn:Oi==1?Qt<=Zn:Qt>=Zn)&&(is=vi,Ss=We)}else is=vi,Ss=We}}if(de||Re){let ai,vi;L.ori==0?(ai=$n,vi=On):(ai=On,vi=$n);let Oi,Zn,oi,yi,Bi,Bn,Jn=!0,Ws=oe.bbox;if(Ws!=null){Jn=!1;let zn=Ws(n,We);oi=zn.left,yi=zn.top,Oi=zn.width,Zn=zn.height}else oi=ai,yi=vi,Oi=Zn=oe.size(n,We);if(Bn=oe.fill(n,We),Bi=oe.stroke(n,We),Re)We==Ss&&is<=Oe.prox&&(Ne=oi,Ue=yi,tt=Oi,St=Zn,yt=Jn,ft=Bn,Ye=Bi);else{let zn=st[We];zn!=null&&(Bt[We]=oi,Fn[We]=yi,om(zn,Oi,Zn,Jn),rm(zn,Bn,Bi),Qi(zn,_i(oi),_i(yi),U,Ce))}}}}if(Re){let We=Oe.prox,Vt=Gs==null?is<=We:is>We||Ss!=Gs;if(de||Vt){let Kt=st[0];Kt!=null&&(Bt[0]=Ne,Fn[0]=Ue,om(Kt,tt,St,yt),rm(Kt,ft,Ye),Qi(Kt,_i(Ne),_i(Ue),U,Ce))}}}if(kt.show&&ys)if(_!=null){let[fe,ye]=on.scales,[De,Ne]=on.match,[Ue,tt]=_.cursor.sync.scales,St=_.cursor.drag;if(vn=St._x,yn=St._y,vn||yn){let{left:yt,top:ft,width:Ye,height:We}=_.select,Vt=_.scales[Ue].ori,Kt=_.posToVal,Sn,It,Qt,$n,On,ai=fe!=null&&De(fe,Ue),vi=ye!=null&&Ne(ye,tt);ai&&vn?(Vt==0?(Sn=yt,It=Ye):(Sn=ft,It=We),Qt=S[fe],$n=H(Kt(Sn,Ue),Qt,$,0),On=H(Kt(Sn+It,Ue),Qt,$,0),ba(Ii($n,On),_n(On-$n))):ba(0,$),vi&&yn?(Vt==1?(Sn=yt,It=Ye):(Sn=ft,It=We),Qt=S[ye],$n=D(Kt(Sn,tt),Qt,ae,0),On=D(Kt(Sn+It,tt),Qt,ae,0),Sa(Ii($n,On),_n(On-$n))):Sa(0,ae)}else lu()}else{let fe=_n(Uf-Nf),ye=_n(Of-Ff);if(L.ori==1){let tt=fe;fe=ye,ye=tt}vn=Tn.x&&fe>=Tn.dist,yn=Tn.y&&ye>=Tn.dist;let De=Tn.uni;De!=null?vn&&yn&&(vn=fe>=De,yn=ye>=De,!vn&&!yn&&(ye>fe?yn=!0:vn=!0)):Tn.x&&Tn.y&&(vn||yn)&&(vn=yn=!0);let Ne,Ue;vn&&(L.ori==0?(Ne=vr,Ue=zt):(Ne=yr,Ue=Xt),ba(Ii(Ne,Ue),_n(Ue-Ne)),yn||Sa(0,ae)),yn&&(L.ori==1?(Ne=vr,Ue=zt):(Ne=yr,Ue=Xt),Sa(Ii(Ne,Ue),_n(Ue-Ne)),vn||ba(0,$)),!vn&&!yn&&(ba(0,0),Sa(0,0))}if(Tn._x=vn,Tn._y=yn,_==null){if(P){if(Jf!=null){let[fe,ye]=on.scales;on.values[0]=fe!=null?Ui(L.ori==0?zt:Xt,fe):null,on.values[1]=ye!=null?Ui(L.ori==1?zt:Xt,ye):null}wa(ef,n,zt,Xt,U,Ce,I)}if(Je){let fe=P&&on.setSeries,ye=Oe.prox;Gs==null?is<=ye&&Fi(Ss,Sr,!0,fe):is>ye?Fi(null,Sr,!0,fe):Ss!=Gs&&Fi(Ss,Sr,!0,fe)}}de&&(he.idx=I,ru()),M!==!1&&bn("setCursor")}let Ms=null;Object.defineProperty(n,"rect",{get(){return Ms==null&&Ma(!1),Ms}});function Ma(_=!1){_?Ms=null:(Ms=g.getBoundingClientRect(),bn("syncRect",Ms))}function kf(_,M,P,I,B,$,ae){ue._lock||ys&&_!=null&&_.movementX==0&&_.movementY==0||(au(_,M,P,I,B,$,ae,!1,_!=null),_!=null?Hs(null,!0,!0):Hs(M,!0,!1))}function au(_,M,P,I,B,$,ae,fe,ye){if(Ms==null&&Ma(!1),Ze(_),_!=null)P=_.clientX-Ms.left,I=_.clientY-Ms.top;else{if(P<0||I<0){zt=-10,Xt=-10;return}let[De,Ne]=on.scales,Ue=M.cursor.sync,[tt,St]=Ue.values,[yt,ft]=Ue.scales,[Ye,We]=on.match,Vt=M.axes[0].side%2==1,Kt=L.ori==0?U:Ce,Sn=L.ori==1?U:Ce,It=Vt?$:B,Qt=Vt?B:$,$n=Vt?I:P,On=Vt?P:I;if(yt!=null?P=Ye(De,yt)?o(tt,S[De],Kt,0):-10:P=Kt*($n/It),ft!=null?I=We(Ne,ft)?o(St,S[Ne],Sn,0):-10:I=Sn*(On/Qt),L.ori==1){let ai=P;P=I,I=ai}}ye&&(M==null||M.cursor.event.type==ef)&&((P<=1||P>=U-1)&&(P=or(P,U)),(I<=1||I>=Ce-1)&&(I=or(I,Ce))),fe?(Nf=P,Ff=I,[vr,yr]=ue.move(n,P,I)):(zt=P,Xt=I)}let ou={width:0,height:0,left:0,top:0};function lu(){To(ou,!1)}let Vf,Gf,Hf,Wf;function Xf(_,M,P,I,B,$,ae){ys=!0,vn=yn=Tn._x=Tn._y=!1,au(_,M,P,I,B,$,ae,!0,!1),_!=null&&(xt(tf,of,qf,!1),wa(Q0,n,vr,yr,U,Ce,null));let{left:fe,top:ye,width:De,height:Ne}=kt;Vf=fe,Gf=ye,Hf=De,Wf=Ne}function qf(_,M,P,I,B,$,ae){ys=Tn._x=Tn._y=!1,au(_,M,P,I,B,$,ae,!1,!0);let{left:fe,top:ye,width:De,height:Ne}=kt,Ue=De>0||Ne>0,tt=Vf!=fe||Gf!=ye||Hf!=De||Wf!=Ne;if(Ue&&tt&&To(kt),Tn.setScale&&Ue&&tt){let St=fe,yt=De,ft=ye,Ye=Ne;if(L.ori==1&&(St=ye,yt=Ne,ft=fe,Ye=De),vn&&bs(A,Ui(St,A),Ui(St+yt,A)),yn)for(let We in S){let Vt=S[We];We!=A&&Vt.from==null&&Vt.min!=Ft&&bs(We,Ui(ft+Ye,We),Ui(ft,We))}lu()}else ue.lock&&(ue._lock=!ue._lock,Hs(M,!0,_!=null));_!=null&&(fn(tf,of),wa(tf,n,zt,Xt,U,Ce,null))}function zg(_,M,P,I,B,$,ae){if(ue._lock)return;Ze(_);let fe=ys;if(ys){let ye=!0,De=!0,Ne=10,Ue,tt;L.ori==0?(Ue=vn,tt=yn):(Ue=yn,tt=vn),Ue&&tt&&(ye=zt<=Ne||zt>=U-Ne,De=Xt<=Ne||Xt>=Ce-Ne),Ue&&ye&&(zt=zt<vr?0:U),tt&&De&&(Xt=Xt<yr?0:Ce),Hs(null,!0,!0),ys=!1}zt=-10,Xt=-10,ie.fill(null),Hs(null,!0,!0),fe&&(ys=fe)}function Yf(_,M,P,I,B,$,ae){ue._lock||(Ze(_),ya(),lu(),_!=null&&wa(tm,n,zt,Xt,U,Ce,null))}function $f(){E.forEach(cw),F(n.width,n.height,!0)}ur(Gc,ca,$f);let Mr={};Mr.mousedown=Xf,Mr.mousemove=kf,Mr.mouseup=qf,Mr.dblclick=Yf,Mr.setSeries=(_,M,P,I)=>{let B=on.match[2];P=B(n,M,P),P!=-1&&Fi(P,I,!0,!1)},me&&(xt(Q0,g,Xf),xt(ef,g,kf),xt(j0,g,_=>{Ze(_),Ma(!1)}),xt(em,g,zg),xt(tm,g,Yf),mf.add(n),n.syncRect=Ma);let Ao=n.hooks=i.hooks||{};function bn(_,M,P){Un?Ct.push([_,M,P]):_ in Ao&&Ao[_].forEach(I=>{I.call(null,n,M,P)})}(i.plugins||[]).forEach(_=>{for(let M in _.hooks)Ao[M]=(Ao[M]||[]).concat(_.hooks[M])});let Zf=(_,M,P)=>P,on=hn({key:null,setSeries:!1,filters:{pub:fm,sub:fm},scales:[A,v[1]?v[1].scale:null],match:[dm,dm,Zf],values:[null,null]},ue.sync);on.match.length==2&&on.match.push(Zf),ue.sync=on;let Jf=on.key,cu=cg(Jf);function wa(_,M,P,I,B,$,ae){on.filters.pub(_,M,P,I,B,$,ae)&&cu.pub(_,M,P,I,B,$,ae)}cu.sub(n);function kg(_,M,P,I,B,$,ae){on.filters.sub(_,M,P,I,B,$,ae)&&Mr[_](null,M,P,I,B,$,ae)}n.pub=kg;function Vg(){cu.unsub(n),mf.delete(n),xn.clear(),uf(Gc,ca,$f),c.remove(),Ee?.remove(),bn("destroy")}n.destroy=Vg;function uu(){bn("init",i,e),va(e||i.data,!1),V[A]?nu(A,V[A]):ya(),ne=kt.show&&(kt.width>0||kt.height>0),ee=de=!0,F(i.width,i.height)}return v.forEach(dr),E.forEach(ji),t?t instanceof HTMLElement?(t.appendChild(c),uu()):t(n,uu):uu(),n}Rn.assign=hn;Rn.fmtNum=Sf;Rn.rangeNum=Hc;Rn.rangeLog=qc;Rn.rangeAsinh=yf;Rn.orient=fr;Rn.pxRatio=wt;Rn.join=eM;Rn.fmtDate=wf,Rn.tzDate=hM;Rn.sync=cg;{Rn.addGap=YM,Rn.clipGaps=Zc;let i=Rn.paths={points:mg};i.linear=_g,i.stepped=JM,i.bars=KM,i.spline=jM}function If(i,e){return Array.from({length:201},(t,n)=>i+n/200*(e-i))}function bg(){let i=pe("div",{className:"plot",role:"img"}),e=pe("div",{className:"patch"}),t=pe("dl",{className:"facts"}),n=pe("p",{className:"caption"}),s=pe("div",{className:"spectrum"},i,pe("div",{className:"colour"},e,t),n),r=null,a="",o=()=>{let l=getComputedStyle(s),[c,u,f]=["--muted","--line","--accent"].map(d=>l.getPropertyValue(d).trim()),h={stroke:c,grid:{stroke:u,width:1},ticks:{stroke:u,width:1},font:"11px system-ui, sans-serif"};return new Rn({width:i.clientWidth||340,height:168,legend:{show:!1},cursor:{y:!1,points:{size:6}},scales:{x:{time:!1},y:{range:(d,g,b)=>[Math.min(0,g),b>0?b*1.08:1]}},axes:[{...h,size:34,values:(d,g)=>g.map(b=>`${b}`),label:"wavelength, nm",labelSize:16,labelFont:"11px system-ui, sans-serif"},{...h,size:52,values:(d,g)=>g.map(b=>Ri(b,2))}],series:[{},{stroke:f,width:1.5,fill:fw,points:{show:!1}}],hooks:{drawClear:[]}},[[],[]],i)};return new ResizeObserver(()=>r?.setSize({width:i.clientWidth,height:168})).observe(i),{element:s,update:(l,c,u)=>{let f=document.documentElement.dataset.theme??"";r&&f!==a&&(r.destroy(),r=null),a=f,r??=o();let h=u?.spectrum;i.hidden=!h,h&&r.setData([h.nm,Array.from(h.values,d=>Number.isNaN(d)?null:d)]),n.textContent=uw(l,c,u),n.hidden=n.textContent==="",e.style.background=u?.xyz?Fc(u.xyz):"transparent",t.replaceChildren(...hw(u).flatMap(([d,g,b])=>[pe("dt",{title:b},d),pe("dd",{},g)])),i.setAttribute("aria-label",`Spectrum at the spot. ${t.textContent??""}`)}}}function uw(i,e,t){return e.floats?t?e.loaded?.specimen.spectral?t.spectrum?"":"Reading the spectral tables …":"This specimen has no spectral tables; its colour comes from those of XYZ.":"Point at the surface to ask it for its spectrum.":"This browser cannot draw to 32-bit floats, so numbers are not to be had."}function hw(i){let e=i?.xyz;if(!i||!e)return[["f","–","The BRDF in 1/sr."]];let t=ra(e),{dominant:n}=i,s=n?`${n.complementary?"c ":""}${n.nm.toFixed(0)} nm${n.complementary?"":`, ${(100*n.purity).toFixed(0)} %`}`:"–";return[["X Y Z",e.map(r=>Ri(r,3)).join("  "),"The BRDF as CIE XYZ in 1/sr, under the light of the picture."],["x y",t?t.map(r=>r.toFixed(3)).join("  "):"–","Chromaticity, CIE 1931."],["dominant",s,'The pure wavelength of the same hue, and the excitation purity. "c" is the complementary wavelength of a purple.']]}function fw(i){let{left:e,width:t}=i.bbox,n=i.ctx.createLinearGradient(e,0,e+t,0),[s,r]=[i.scales.x.min??380,i.scales.x.max??780];for(let a=0;a<=40;a++)n.addColorStop(a/40,ho(s+a/40*(r-s)).replace("rgb","rgba").replace(")",", 0.75)"));return n}function Sg(i){let{change:e,current:t}=i,n=G0(t,e),s=k0(),[r,a,o]=[bg(),q0(e),$0()],l=[s,r,a,o],c=[],u=x=>(c.push(x),x.element),f=pe("div",{className:"specimens",role:"radiogroup","aria-label":"Specimen"}),h=pe("p",{className:"status",role:"status"}),d=pe("p",{className:"badge",hidden:!0}),g=pe("progress",{max:1,value:0,"aria-label":"Reading the atlas"}),b=pe("p",{className:"caption"});n.overlay.append(d,h);let m=dw(n),p=matchMedia("(min-width: 760px)").matches,v=pe("aside",{className:"controls","aria-label":"Controls"},ar("Specimen",!0,f,b),ar("Shape",!0,u(mw(e)),...gw(t,e).map(u)),ar("Light",p,u(W0(t,e)),..._w(t,e).map(u),xw(t,e)),ar("Surface",!1,...vw(t,e).map(u)),ar("Picture",p,...yw(t,e,i).map(u)),ar("Trust",!1,...bw(t,e).map(u))),E=(x,T)=>pe("section",{className:"card"},pe("h2",{},x),T.element),S=pe("aside",{className:"views","aria-label":"Linked views"},E("Spectrum at the spot",r),E("All viewing directions",s),E("Plane of incidence",a),E("Relief and its frequencies",o)),R=pe("header",{},pe("div",{className:"brand"},En.mark(),pe("h1",{},"Diffraction atlas"),pe("span",{className:"atlas-name"})),pe("nav",{"aria-label":"Picture"},jc(En.link,"Copy link","Copies a link that restores this view.",i.copyLink),jc(En.picture,"PNG","Saves the picture as PNG.",i.savePng),jc(En.film,"WebM","Records the motion for five seconds as WebM.",i.record),jc(En.theme,"Theme","Light or dark page.",i.theme)),g);return{element:pe("div",{className:"page"},R,v,pe("main",{className:"stage"},n.element,pe("div",{className:"under"},m,pw(e,u))),S),stage:n,map:s,views:l,controls:c,specimens:f,status:h,badge:d,loading:g,facts:b}}var jc=(i,e,t,n)=>pe("button",{type:"button",title:t,onclick:n,className:"icon"},i(),pe("span",{className:"word"},e));function dw(i){let e=fo({label:"Dragging moves",title:"What a drag on the picture moves, and the arrow keys. With Shift it is the other of light and view.",choices:[{value:"light",label:"light",icon:En.light},{value:"view",label:"view",icon:En.orbit},{value:"spot",label:"spot",icon:En.spot}],get:()=>i.grip,set:t=>(i.grip=t,{})},()=>{});return e.update({}),e.element}function pw(i,e){return e(fo({label:"Motion",title:"What moves by itself.",choices:[{value:"none",label:"still",icon:En.pause},{value:"light",label:"light",icon:En.sweep},{value:"turntable",label:"object",icon:En.turn}],get:t=>t.motion,set:t=>({motion:t})},i))}function mw(i){return fo({label:"Shape",title:"What wears the structure.",choices:[{value:"ball",label:"ball",icon:En.ball,title:"A ball: every orientation at once."},{value:"snake",label:"snake",icon:En.snake,title:"A snake with scales."},{value:"patch",label:"flat",icon:En.flat,title:"A flat sample, tilted."},{value:"screen",label:"screen",icon:En.screen,title:"A beam through a hole in a screen, thrown back on it."},{value:"map",label:"map",icon:En.map,title:"The BRDF itself over all viewing directions."}],get:e=>e.shape,set:e=>({shape:e,view:{azimuth_deg:0,elevation_deg:0,zoom:1},spin_deg:0})},i)}function gw(i,e){let t=s=>s.shape==="screen",n=s=>s.shape==="patch";return[qn({label:"Incidence",unit:"°",title:"Turns the sample about the vertical.",min:0,max:40,step:1,get:s=>s.screen.incidence_deg,set:(s,r)=>({screen:{...r.screen,incidence_deg:s}}),when:t},i,e),qn({label:"Distance",unit:" mm",title:"From the screen to the sample.",min:30,max:300,step:5,get:s=>s.screen.distance_mm,set:(s,r)=>({screen:{...r.screen,distance_mm:s}}),when:t},i,e),qn({label:"Beam",unit:" mm",title:"Diameter of the beam and of the hole.",min:.5,max:10,step:.5,get:s=>s.screen.beam_mm,set:(s,r)=>({screen:{...r.screen,beam_mm:s}}),when:t},i,e),qn({label:"Tilt",unit:"°",title:"Leans the upper edge of the sample away.",min:0,max:80,step:1,get:s=>s.patch.tilt_deg,set:(s,r)=>({patch:{...r.patch,tilt_deg:s}}),when:n},i,e)]}function _w(i,e){let t=r=>r.lights[r.active],n=r=>{let[a,o,l]=t(r).direction;return{theta:Math.atan2(Math.hypot(a,o),l)*180/Math.PI,phi:Math.atan2(o,a)*180/Math.PI}},s=(r,a)=>{let[o,l]=[r*Math.PI/180,a*Math.PI/180];return[Math.sin(o)*Math.cos(l),Math.sin(o)*Math.sin(l),Math.cos(o)]};return[qn({label:"Angle",unit:"°",title:"Angle of the light from the line of sight at rest.",min:0,max:175,step:.5,get:r=>n(r).theta,set:(r,a)=>zs(a,{direction:s(Math.max(r,.01),n(a).phi)}),text:r=>`${r.toFixed(1)}°`},i,e),qn({label:"Azimuth",unit:"°",title:"Where the light stands around the line of sight; 0 is to the right.",min:-180,max:180,step:1,get:r=>n(r).phi,set:(r,a)=>zs(a,{direction:s(n(a).theta,r)}),text:r=>`${r.toFixed(0)}°`},i,e),qn({label:"Size",unit:"°",title:"Full angle of the light’s disc: 0 is a point, 0.53° the sun.",min:0,max:30,step:.01,get:r=>t(r).diameter_deg,set:(r,a)=>zs(a,{diameter_deg:r})},i,e),z0({label:"Spectrum",title:"The light’s spectrum. All but the first need spectral tables.",choices:[{value:"tables",label:"as in the tables"},{value:"D65",label:"D65, daylight"},{value:"A",label:"A, incandescent"},{value:"F11",label:"F11, fluorescent"},{value:"LED",label:"white LED"},{value:"sun",label:"sun at a height"},{value:"laser",label:"laser line"},{value:"E",label:"E, equal power"}],get:r=>r.illuminant,set:r=>({illuminant:r})},e),qn({label:"Wavelength",unit:" nm",title:"Wavelength of the laser.",min:400,max:700,step:1,get:r=>r.laser_nm,set:r=>({laser_nm:r}),when:r=>r.illuminant==="laser"},i,e),qn({label:"Sun’s height",unit:"°",title:"Height of the sun above the horizon: low suns are red.",min:1,max:90,step:1,get:r=>r.sun_deg,set:r=>({sun_deg:r}),when:r=>r.illuminant==="sun"},i,e)]}function xw(i,e){let t=()=>{let s=i();if(s.lights.length>=4)return;let[r,a,o]=s.lights[s.active].direction,l={...s.lights[s.active],direction:[-r-.2,a+.1,o]};e({lights:[...s.lights,l],active:s.lights.length})},n=()=>{let s=i();s.lights.length>1&&e({lights:s.lights.filter((r,a)=>a!==s.active),active:0})};return pe("div",{className:"buttons"},Uc("Add a light","Up to four lights at once.",t),Uc("Remove it","Removes the light that is chosen on the disc.",n))}function vw(i,e){return[qn({label:"Orientation",unit:"°",title:"Turns the structure on the surface.",min:-90,max:90,step:1,get:t=>t.turn_deg,set:t=>({turn_deg:t})},i,e),qn({label:"Scale",title:"Enlarges the structure in all directions, heights too. Needs spectral tables.",min:.5,max:2,step:.01,get:t=>t.scale,set:t=>({scale:t}),text:t=>`× ${t.toFixed(2)}`},i,e),Zh({label:"pigment below the structure",title:"Where the specimen has a pigment.",get:t=>t.pigment,set:t=>({pigment:t})},e)]}function yw(i,e,t){let n=Uc("Auto","Meters the exposure anew: the brightest half percent comes to white.",()=>{e({exposure:null}),t.remeter()}),s=qn({label:"Exposure",title:"In stops. 0 shows a white wall facing the light as white.",min:-8,max:14,step:.1,get:r=>r.exposure??Math.log2(Mg()/Math.PI),set:r=>({exposure:r}),text:(r,a)=>`${r>=0?"+":"−"}${Math.abs(r).toFixed(1)}${a.exposure===null?" auto":""}`},i,e);return s.element.append(n),[s,fo({label:"Bright and saturated colours",title:"What becomes of colours that no display shows.",choices:[{value:"atlas",label:"keep the hue"},{value:"clip",label:"cut channels"}],get:r=>r.tone,set:r=>({tone:r})},e)]}var Mg=()=>Math.PI;function wg(i){Mg=()=>i.exposure()}function bw(i,e){let t=8;return[qn({label:"Tables used",title:"How many tables of the expansion are summed.",min:1,max:16,step:1,get:n=>n.tables??t,set:n=>({tables:n>=t?null:n}),text:(n,s)=>s.tables===null?"all":`${n}`},i,e),Zh({label:"show the difference",title:"The difference of luminance from all tables, ten times enlarged, in place of the picture.",get:n=>n.difference,set:n=>({difference:n}),when:n=>n.tables!==null},e)]}async function Tg(i,e){let t=aa();return Promise.all(i.index.specimens.map(async({name:n,species:s},r)=>{let a=i.state.specimen?n===i.state.specimen:r===0,o=pe("input",{type:"radio",name:t,value:n,checked:a,onchange:()=>e(n)}),l=`${n}/preview.png`,c=i.index.files.some(f=>f.path===l),u=pe("img",{alt:"",loading:"lazy",src:c?await i.files.url(l):""});return c||(u.hidden=!0),pe("label",{className:"specimen",title:s??n},o,u,pe("span",{},n.replaceAll("_"," ")))}))}var Ag="diffraction-atlas-theme",Sw=()=>{try{return localStorage.getItem(Ag)}catch{return null}},Mw=()=>matchMedia("(prefers-color-scheme: light)").matches?"light":"dark";function Eg(){let i=()=>document.documentElement.dataset.theme=Sw()??Mw();i(),matchMedia("(prefers-color-scheme: light)").addEventListener("change",i)}function Rg(){let i=document.documentElement.dataset.theme==="dark"?"light":"dark";document.documentElement.dataset.theme=i;try{localStorage.setItem(Ag,i)}catch{}}var ww=70,Tw=400,eu=class{constructor(e,t,n){this.fault=n;this.page=Sg({change:r=>this.set(r),current:()=>this.engine.state,savePng:()=>this.savePng(),record:()=>{this.record()},copyLink:()=>{this.copyLink()},theme:()=>{Rg(),this.stale.views=!0},remeter:()=>{this.engine.remeter(),this.stale.picture=this.stale.controls=!0}}),this.engine=new Nc(this.page.stage.canvas,t,Xh(location.hash)),wg(this.engine),e.replaceChildren(this.page.element),this.page.map.onAsk=r=>{this.asked=r,this.stale.views=!0};let{canvas:s}=this.page.stage;s.addEventListener("webglcontextlost",r=>{r.preventDefault(),this.fault(new Error("The graphics driver took its memory back (the WebGL context was lost). Load the page again."))}),new ResizeObserver(()=>this.fit()).observe(this.page.stage.element),addEventListener("hashchange",()=>{location.hash!==Dc(this.engine.state)&&this.set(Xh(location.hash))})}fault;engine;page;pending=Promise.resolve();asked=null;stale={picture:!0,views:!0,controls:!0,address:!1};last={views:0,address:0,tick:0};frameMs=0;opened=!1;async start(){let{engine:e,page:t}=this;await e.open();let n=t.element.querySelector(".atlas-name");n&&(n.textContent=e.index.name),document.title=`${e.index.name} – diffraction atlas`,t.specimens.append(...await Tg(e,r=>this.set({specimen:r}))),await this.load(),this.opened=!0,this.fit(),e.draw(0),t.element.classList.add("ready");let s=r=>{try{this.tick(r),requestAnimationFrame(s)}catch(a){this.fault(a)}};requestAnimationFrame(s),this.load(!0)}set(e){let t=this.engine.state;this.engine.set(e);let n=this.engine.state;if(e.pointer&&(this.asked=null),this.stale={picture:!0,views:!0,controls:!0,address:!0},t.size_px!==n.size_px&&this.fit(),!this.opened)return;let s=this.engine.wantsSpectral()&&!this.engine.loaded?.spectral;(t.specimen!==n.specimen||s)&&(this.pending=this.pending.then(()=>this.load()))}async load(e=!1){let{engine:t,page:n}=this,s=r=>{n.loading.value=r,n.loading.hidden=r>=1};try{s(.02),await t.loadSpecimen(s),(e||t.wantsSpectral()||this.opened)&&await t.loadSpectral(s),s(1)}catch(r){if(s(1),this.fault(r),!this.opened)throw r}this.stale={picture:!0,views:!0,controls:!0,address:!0}}fit(){let{size_px:e}=this.engine.state,t=this.page.stage.element.getBoundingClientRect(),n=Math.min(2,devicePixelRatio||1),[s,r]=e?[e,e]:[Math.round(t.width*n),Math.round(t.height*n)];s<1||r<1||(this.engine.resize(s,r),this.stale.picture=this.stale.views=!0)}tick(e){let{engine:t,page:n,stale:s}=this;if(this.move(e),s.controls){s.controls=!1;for(let r of n.controls)r.update(t.state);n.stage.update(t.state),n.facts.textContent=this.specimenFacts()}if(s.picture){let r=performance.now();s.picture=!t.draw(0),this.frameMs=.8*this.frameMs+.2*(performance.now()-r),this.updateStatus()}s.views&&e-this.last.views>ww&&(s.views=!1,this.last.views=e,this.updateViews()),s.address&&e-this.last.address>Tw&&(s.address=!1,this.last.address=e,t.state.motion==="none"&&history.replaceState(null,"",Dc(t.state)||location.pathname+location.search))}move(e){let t=Math.min(.1,(e-this.last.tick)/1e3);this.last.tick=e;let{state:n}=this.engine;if(n.motion==="light"){let s=n.lights.map(r=>({...r,direction:Aw(r.direction,40*t)}));this.set({lights:s})}else n.motion==="turntable"&&this.set({spin_deg:(n.spin_deg+30*t)%360})}updateViews(){let e=this.answer();for(let t of this.page.views)t.update(this.engine.state,this.engine,e);this.updateBadge(e),this.updateStatus()}answer(){let{engine:e}=this,t=e.directions(),n=e.evaluated();if(!t||!n)return null;let s={wi:t.wi,wo:this.asked??t.wo},[r]=e.probe.brdf(n,[s]),a=e.light()??ia("D65",633,45),o=Ew(a),l=e.spectralEvaluated(),c=e.loaded?.specimen.spectral,u=null;if(l&&c){let f=If(c.shortest_nm,c.longest_nm);u={nm:f,values:e.probe.spectrum(l,s,e.asks(f))}}return{...s,xyz:r,white:o,dominant:r?U0(r,o):null,spectrum:u}}updateBadge(e){let{badge:t}=this.page,n=this.engine.loaded?.specimen.tables.usable_radius??2,s=e?Math.hypot(e.wi[0]+e.wo[0],e.wi[1]+e.wo[1]):0,r=e&&!e.xyz?"the tables do not cover the spot":s>n?"the spot lies beyond the scan’s sampling":"";t.textContent=r,t.hidden=r===""}updateStatus(){let{engine:e}=this,{taken:t,whole:n}=e.progress;this.page.status.textContent=`${Math.min(t,n)} / ${n} samples · ${e.size.width} × ${e.size.height} · ${e.lookups()} look-ups · ${Ri(this.frameMs,2)} ms`}specimenFacts(){let e=this.engine.loaded?.specimen;if(!e)return"";let{sigma_nm:t}=e.optics;return`${e.species??e.name} · coherence σ ${Ri(t/1e3)} µm`}savePng(){this.engine.draw(1/0),this.page.stage.canvas.toBlob(e=>e&&$h(e,`${this.engine.state.specimen}.${this.engine.state.shape}.png`))}async record(){let{state:e}=this.engine;e.motion==="none"&&this.set({motion:"light"});let t=await O0(this.page.stage.canvas,5);e.motion==="none"&&this.set({motion:"none"}),t&&$h(t,`${e.specimen}.${e.shape}.webm`)}async copyLink(){history.replaceState(null,"",Dc(this.engine.state)||location.pathname+location.search);try{await navigator.clipboard.writeText(location.href),this.page.status.textContent="The link is copied."}catch{this.page.status.textContent="The link stands in the address bar."}}api(e,t){let{engine:n}=this,s=(a,o,l,c)=>({wi:hu(a,o),wo:hu(l,c)}),r=async()=>{await e,await this.pending};return{ready:e,errors:t,set:a=>this.set(a),state:()=>structuredClone(n.state),frame:async()=>{await r(),n.draw(1/0),this.updateViews()},pixels:()=>n.pixels(),xyz:()=>n.values(),exposure:()=>n.exposure(),brdfXyz:async(...a)=>{await r();let o=n.evaluated();return o?n.probe.brdf(o,[s(...a)])[0]:null},spectrumAt:async(a,o,l,c,u)=>{await r();let f=n.loaded?.specimen.spectral;if(!f||!await n.loadSpectral(()=>{}))throw new Error("the specimen has no spectral tables");let h=u??If(f.shortest_nm,f.longest_nm),d=n.spectralEvaluated();if(!d)throw new Error("the specimen has no spectral tables");let g=n.probe.spectrum(d,s(a,o,l,c),n.asks(h));return{wavelengths_nm:h,values:Array.from(g)}}}}};function Aw([i,e,t],n){let[s,,r]=ea([i,0,e],n);return[s,r,t]}var Cg=new Map;function Ew(i){let e=Cg.get(i.label);if(!e){let t=Rc(i,[380,780],401).weights.reduce((n,s)=>n.map((r,a)=>r+s[a]),[0,0,0]);Cg.set(i.label,e=t)}return e}var So=[];addEventListener("error",i=>So.push(i.message));addEventListener("unhandledrejection",i=>So.push(String(i.reason)));function Lf(i){let[e,t]=i instanceof sa?["This page cannot draw here",`${i.message} Try another browser, or switch on hardware acceleration.`]:i instanceof Wn?["The atlas cannot be shown",i.message]:["Something went wrong",String(i)];So.push(`${e}: ${t}`),document.querySelector(".fault")?.remove(),document.body.append(pe("div",{className:"fault",role:"alert"},pe("div",{},pe("h2",{},e),pe("p",{},t))))}Eg();var Rw=document.getElementById("app")??document.body;try{let i=new eu(Rw,zp(document),Lf),e=i.start().catch(t=>{throw Lf(t),t});e.catch(()=>{}),Object.assign(window,{atlasViewer:i.api(e,So)})}catch(i){Lf(i);let e=Promise.reject(i);e.catch(()=>{}),Object.assign(window,{atlasViewer:{ready:e,errors:So}})}})();
/*! Bundled license information:

three/build/three.core.js:
three/build/three.module.js:
  (**
   * @license
   * Copyright 2010-2026 Three.js Authors
   * SPDX-License-Identifier: MIT
   *)
*/
