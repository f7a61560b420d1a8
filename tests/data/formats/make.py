#!/usr/bin/env python3
"""Makes the files of this folder: one small surface in the formats of many instruments, written by other programs' libraries where they
can write, else laid out by hand here; then reads each with other programs' readers, and fails where one does not find the surface.

    python3 make.py          # writes the files and truth.json, then reads them
    python3 make.py --check  # reads the files that are there

Wants numpy, gwyfile, SurfaceTopography, surfalize, igor2, NSFopen, tifffile and imagecodecs from PyPI. `tests/scans/instruments.rs` reads the same files.
"""

import json
import struct
import sys
import warnings
import zipfile
from pathlib import Path

import numpy as np

warnings.filterwarnings("ignore")
HERE = Path(__file__).resolve().parent
NX, NY = 12, 9
PITCH_NM = (25.0, 40.0)
EXTENT_M = (NX * PITCH_NM[0] * 1e-9, NY * PITCH_NM[1] * 1e-9)
MISSING = [(3, 4), (6, 1)]  # row and column, row 0 at +y


def surface_nm():
    """Heights in nm, row 0 at +y; no mirror or turn maps them onto themselves."""
    y, x = np.mgrid[0:NY, 0:NX]
    return np.round(3.0 * x - 5.0 * y + x * y / 7.0 + 20.0 * np.sin(0.9 * x + 0.3 * y) + 0.2 * x**2, 2)


def counts(values, low, span, bits, signed=True):
    """Values as integers whose whole range spans `span` from `low` on."""
    steps = np.round((values - low) / span * 2.0**bits - (2.0 ** (bits - 1) if signed else 0.0))
    return steps.astype(f"<{'i' if signed else 'u'}{bits // 8}")


def amplitude():
    return surface_nm()[::-1, ::-1] * 1e-3


# --- written by other programs' libraries -------------------------------------------------------------------------------


def with_gwyfile(path):
    from gwyfile.objects import GwyContainer, GwyDataField, GwySIUnit

    box = GwyContainer()
    metre = lambda: GwySIUnit(unitstr="m")
    for number, (title, values, unit) in enumerate([
        ("Phase", amplitude() * 1e3, "deg"),
        ("Height", surface_nm() * 1e-9, "m"),
        ("Amplitude", amplitude(), "V"),
    ]):
        field = GwyDataField(values.astype(float), xreal=EXTENT_M[0], yreal=EXTENT_M[1], si_unit_xy=metre(), si_unit_z=GwySIUnit(unitstr=unit))
        box[f"/{number}/data"] = field
        box[f"/{number}/data/title"] = title
        box[f"/{number}/data/visible"] = True
    box["/filename"] = "made by gwyfile"
    box.tofile(str(path))


def topography(missing=False):
    import SurfaceTopography

    values = surface_nm() * 1e-9
    if missing:
        mask = np.zeros_like(values, bool)
        for place in MISSING:
            mask[place] = True
        values = np.ma.masked_array(values, mask)
    return SurfaceTopography.Topography(values.T, EXTENT_M, unit="m")


def with_topography_x3p(path, dtype, missing):
    from SurfaceTopography.IO.X3P import write_x3p

    write_x3p(topography(missing), str(path), dtype=dtype)


def with_surfalize(path, missing, **options):
    import surfalize

    values = surface_nm() * 1e-3
    if missing:
        for place in MISSING:
            values[place] = np.nan
    surfalize.Surface(values, PITCH_NM[0] * 1e-3, PITCH_NM[1] * 1e-3).save(path, **options)


def with_tifffile(path, values, **options):
    import tifffile

    text = f"zunit = nm\npixel_width_nm = {PITCH_NM[0]}\npixel_height_nm = {PITCH_NM[1]}"
    tifffile.imwrite(path, values, photometric="minisblack", description=text, metadata=None, rowsperstrip=4, **options)


def with_mask(path, planar):
    opacity = np.ones((NY, NX))
    for place in MISSING:
        opacity[place] = 0.0
    values = np.stack([surface_nm(), opacity], axis=0 if planar else 2)
    options = {"planarconfig": "separate"} if planar else {"planarconfig": "contig", "compression": "zlib", "predictor": 3}
    with_tifffile(path, values, extrasamples=["unassalpha"], **options)


# --- laid out by hand ----------------------------------------------------------------------------------------------------


def nanoscope(path, version, value_bytes, sample_bytes, unit_line, sensor):
    """Two to three channels; bottom line first. `value_bytes` is what `Bytes/pixel` says."""
    span_volt = 16.0
    nm_per_volt = 25.0
    bits = 8 * value_bytes
    channels = [("Deflection", "DeflectionError", "Sens. DeflSens", amplitude() * 1e2, "Trace")]
    channels += [("Height", "Height", "Sens. Zsens", surface_nm() / nm_per_volt, "Retrace")]
    if sensor:
        channels += [("ZSensor", "Height Sensor", "Sens. ZsensSens", surface_nm() / nm_per_volt, "Trace")]
    at = 4096
    lists = ["\\*File list", f"\\Version: {version}", "\\Date: 10:12:13 AM Tue Mar 05 2019", "\\Data length: 4096",
             "\\*Equipment list", "\\Description: made by hand", "\\*Scanner list", "\\@Sens. Zsens: V 25.00000 nm/V",
             "\\*Ciao scan list", "\\Operating mode: Image", f"\\Samps/line: {NX}", f"\\Lines: {NY}", "\\Rotate Ang.: 0.5235987755982988",
             "\\@Sens. DeflSens: V 55.00000 nm/V", "\\@Sens. ZsensSens: V 25.00000 nm/V"]
    if sensor:
        lists += ["\\Scan Size: 300.000 nm", "\\Slow Axis Size: 360.000 nm"]
    data = b""
    for kind, name, sens, volts, direction in channels:
        block = np.round(volts[::-1] / span_volt * 2.0**bits).astype(f"<i{sample_bytes}").tobytes()
        lists += ["\\*Ciao image list", f"\\Data offset: {at + len(data)}", f"\\Data length: {len(block)}",
                  f"\\Bytes/pixel: {value_bytes}", f"\\Samps/line: {NX}", f"\\Number of lines: {NY}",
                  f"\\Scan Size: {unit_line}", "\\Aspect Ratio: 1:1", f"\\Line Direction: {direction}",
                  f'\\@2:Image Data: S [{kind}] "{name}"',
                  f"\\@2:Z scale: V [{sens}] ({span_volt / 2**bits:.12f} V/LSB) {span_volt:.4f} V"]
        data += block
    head = ("\r\n".join(lists) + "\r\n\\*File list end\r\n").encode("latin-1") + b"\x1a"
    assert len(head) <= at, len(head)
    path.write_bytes(head.ljust(at, b"\0") + data)


ASYLUM_NOTE = "\r".join(["ScanSize: 3e-07", f"FastScanSize: {EXTENT_M[0]!r}", f"SlowScanSize: {EXTENT_M[1]!r}", f"ScanPoints: {NX}",
                         f"ScanLines: {NY}", "ScanAngle: -90", "MicroscopeModel: made by hand", ""]).encode()


def checksummed(head, at, order):
    """The 16-bit words of both headers add up to nothing."""
    total = sum(struct.unpack(f"{order}{len(head) // 2}H", head)) & 0xFFFF
    return head[:at] + struct.pack(f"{order}H", -total & 0xFFFF) + head[at + 2:]


def igor_5(path, order):
    layers = [("HeightRetrace", surface_nm() * 1e-9), ("AmplitudeRetrace", amplitude()), ("PhaseRetrace", amplitude())]
    # Column by column of (x, y, layer): x runs fastest, the bottom row first.
    samples = b"".join(values[::-1].astype(f"{order}f4").tobytes() for _, values in layers)
    labels = b"".join(name.encode().ljust(32, b"\0") for name in [""] + [name for name, _ in layers])
    sides = [NX, NY, len(layers), 0]
    wave = struct.pack(f"{order}IIIIhh6sh32sIi4I4d4d4s16shhdd", 0, 3600000000, 3600000000, NX * NY * len(layers), 2, 0, b"", 1,
                       b"made", 0, 0, *sides, PITCH_NM[0] * 1e-9, PITCH_NM[1] * 1e-9, 1.0, 1.0, 0.0, 0.0, 0.0, 0.0, b"m",
                       b"m\0\0\0m\0\0\0", 0, 0, 0.0, 0.0)
    wave = wave.ljust(320, b"\0")
    head = struct.pack(f"{order}hHiiii4i4iiii", 5, 0, 320 + len(samples), 0, len(ASYLUM_NOTE), 0, 0, 0, 0, 0, 0, 0, len(labels), 0, 0, 0, 0)
    head = checksummed(head + wave, 2, order)
    path.write_bytes(head + samples + ASYLUM_NOTE + labels)


def igor_2(path):
    order = "<"
    samples = (surface_nm() * 1e-9)[::-1].astype("<f8").tobytes()
    wave = struct.pack("<hi20shhi4s4sihddhhhddccii4s", 4, 0, b"Height", 0, 0, 0, b"m", b"m", NX * NY, 0, PITCH_NM[0] * 1e-9, 0.0, 0, 0, 0, 0.0,
                       0.0, b"\0", b"\0", 0, 0, b"")
    wave = wave.ljust(110, b"\0")
    head = struct.pack("<hiiih", 2, 110 + len(samples) + 16, len(ASYLUM_NOTE), 0, 0)
    head = checksummed(head + wave, 14, order)
    path.write_bytes(head + samples + bytes(16) + ASYLUM_NOTE)


def nanosurf(path, bits, signed):
    span, low = 4e-7, -1.5e-7
    sets = [("0:0", "Scan forward", "Deflection", "m", 2e-3, -1e-3, amplitude() * 1e-3),
            ("0:1", "Scan forward", "Z-Axis", "m", span, low, surface_nm() * 1e-9),
            ("1:1", "Scan backward", "Z-Axis", "m", span, low, surface_nm()[:, ::-1] * 1e-9)]
    lines = ["[DataSet]", "Version=2", "GroupCount=2", "Gr0-Name=Scan forward", "Gr0-ID=0", "Gr0-Count=8", "Gr1-Name=Scan backward", "Gr1-ID=0",
             "Gr1-Count=8", "Gr0-Ch0=DataSet-0:0", "Gr0-Ch1=DataSet-0:1", "Gr1-Ch1=DataSet-1:1", "SetInfos=DataSet-Info", "", "[DataSet-Info]",
             "-- Scan --=--------", "Image size=300nm", "Rotation=15 °", "Date=28-11-2016", "Time=17:04:03", "Software ver.=3.7.2.2", ""]
    data = b""
    for name, frame, channel, unit, span_of, low_of, values in sets:
        lines += [f"[DataSet-{name}]", "Version=2", f"Points={NX}", f"Lines={NY}", f"Frame={frame}", "CurLine=0", "Dim0Name=X*", "Dim0Unit=m",
                  f"Dim0Range={EXTENT_M[0]!r}", "Dim0Min=0", "Dim1Name=Y*", "Dim1Unit=m", f"Dim1Range={EXTENT_M[1]!r}", "Dim1Min=0",
                  f"Dim2Name={channel}", f"Dim2Unit={unit}", f"Dim2Range={span_of!r}", f"Dim2Min={low_of!r}", "SaveMode=Binary",
                  f"SaveBits={bits}", f"SaveSign={'Signed' if signed else 'Unsigned'}", "SaveOrder=Intel", ""]
        data += counts(values[::-1], low_of, span_of, bits, signed).tobytes()
    path.write_bytes("\r\n".join(lines).encode("latin-1") + b"\r\n\r\n#!" + data)


def wsxm(path, kind):
    values = surface_nm()
    stored = values if kind == "double" else np.round((values - values.min()) / np.ptp(values) * 60000 - 30000)
    stored = stored[::-1, ::-1].astype("<f8" if kind == "double" else "<i2")
    body = ["[Control]", "", "    Signal Gain: 1", f"    X Amplitude: {NX * PITCH_NM[0]} nm", f"    Y Amplitude: {NY * PITCH_NM[1]} nm", "",
            "[General Info]", "", "    Acquisition channel: Topography", "    Head type: AFM", f"    Image Data Type: {kind}",
            f"    Number of columns: {NX}", f"    Number of rows: {NY}", f"    Z Amplitude: {np.ptp(values)!r} nm".replace("np.float64(", "").replace(")", ""), "",
            "[Miscellaneous]", "", "    Comments: made by hand", f"    Maximum: {float(stored.max())}", f"    Minimum: {float(stored.min())}", "", "[Header end]", ""]
    first = ["WSxM file copyright UAM", "SxM Image file"]
    size = 0
    for _ in range(3):  # Its own length stands in it.
        text = "\r\n".join(first + [f"Image header size: {size}", ""] + body).encode("latin-1")
        size = len(text)
    path.write_bytes(text + stored.tobytes())


def x3p_list(path):
    """The samples in the XML, an empty one for what is missing."""
    rows = surface_nm() * 1e-9
    data = "".join("<Datum/>" if (row, column) in MISSING else f"<Datum>{rows[row, column]!r}</Datum>".replace("np.float64(", "").replace(")", "")
                   for row in range(NY) for column in range(NX))
    axis = lambda name, kind, step: f"<{name}><AxisType>{kind}</AxisType><DataType>D</DataType><Increment>{step}</Increment><Offset>0</Offset></{name}>"
    main = ('<?xml version="1.0" encoding="UTF-8"?><p:ISO5436_2 xmlns:p="http://www.opengps.eu/2008/ISO5436_2"><Record1><Revision>ISO5436 - 2000'
            "</Revision><FeatureType>SUR</FeatureType><Axes>" + axis("CX", "I", PITCH_NM[0] * 1e-9) + axis("CY", "I", PITCH_NM[1] * 1e-9)
            + axis("CZ", "A", 1) + "</Axes></Record1><Record3><MatrixDimension><SizeX>%d</SizeX><SizeY>%d</SizeY><SizeZ>1</SizeZ>"
            "</MatrixDimension><DataList>%s</DataList></Record3></p:ISO5436_2>" % (NX, NY, data))
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as archive:
        archive.writestr("main.xml", main)


def gwyddion_text(path, comma):
    lines = ["# Channel: Height", "# Width: 300 nm", "# Height: 360 nm", "# Value units: m"]
    lines += ["\t".join(f"{value * 1e-9:.11e}" for value in row) for row in surface_nm()]
    text = "\n".join(lines) + "\n"
    path.write_text(text.replace(".", ",") if comma else text)


# --- what each must be ---------------------------------------------------------------------------------------------------

# Name, how it is made, format, page, channel, number of missing samples, largest difference in nm, angle, reader that checks it.
STEP_16 = 16.0 * 25.0 / 2**16
TABLE = [
    ("gwyfile.gwy", with_gwyfile, "Gwyddion", 1, "Height", 0, 0.0, None, "topography"),
    ("nanoscope_16.spm", lambda p: nanoscope(p, "0x05120000", 2, 2, "0.3 0.36 ~m", False), "Nanoscope", 1, "Height (retrace)", 0, STEP_16, 30, "topography"),
    ("nanoscope_32.001", lambda p: nanoscope(p, "0x09400000", 4, 4, "300 360 nm", True), "Nanoscope", 2, "Height Sensor (trace)", 0, 1e-6, 30, "topography"),
    ("nanoscope_16_in_32.spm", lambda p: nanoscope(p, "0x09700127", 2, 4, "300 300 nm", True), "Nanoscope", 2, "Height Sensor (trace)", 0, STEP_16, 30, "topography"),
    ("asylum_little.ibw", lambda p: igor_5(p, "<"), "Igor binary wave", 0, "HeightRetrace", 0, 1e-5, -90, "topography"),
    ("asylum_big.ibw", lambda p: igor_5(p, ">"), "Igor binary wave", 0, "HeightRetrace", 0, 1e-5, -90, "topography"),
    ("asylum_2.ibw", igor_2, "Igor binary wave", 0, None, 0, 0.0, -90, "igor"),
    ("nanosurf_32.nid", lambda p: nanosurf(p, 32, True), "Nanosurf", 1, "Z-Axis (forward)", 0, 1e-6, 15, "nsfopen"),
    ("nanosurf_16.nid", lambda p: nanosurf(p, 16, False), "Nanosurf", 1, "Z-Axis (forward)", 0, 400.0 / 2**16, 15, "topography"),
    ("surfalize.sur", lambda p: with_surfalize(p, True), "Digital Surf", 0, "Z", 2, 1e-4, None, "topography"),
    ("surfalize_packed.sur", lambda p: with_surfalize(p, False, compressed=True), "Digital Surf", 0, "Z", 0, 1e-4, None, "surfalize"),
    ("topography.x3p", lambda p: with_topography_x3p(p, "D", False), "X3P", 0, None, 0, 0.0, None, "topography"),
    ("topography_16.x3p", lambda p: with_topography_x3p(p, "I", True), "X3P", 0, None, 2, 200.0 / 2**16, None, "topography"),
    ("surfalize.x3p", lambda p: with_surfalize(p, False), "X3P", 0, None, 0, 0.0, None, "topography"),
    ("list.x3p", x3p_list, "X3P", 0, None, 2, 0.0, None, None),
    ("wsxm_16.stp", lambda p: wsxm(p, "short"), "WSxM", 0, "Topography", 0, 200.0 / 60000, None, "topography"),
    ("wsxm_64.top", lambda p: wsxm(p, "double"), "WSxM", 0, "Topography", 0, 0.0, None, "topography"),
    ("zstd_predictor_3.tif", lambda p: with_tifffile(p, surface_nm(), compression="zstd", predictor=3), "TIFF", 0, None, 0, 0.0, None, "tifffile"),
    ("mask.tif", lambda p: with_mask(p, False), "TIFF", 0, None, 2, 0.0, None, "tifffile"),
    ("mask_planar.tif", lambda p: with_mask(p, True), "TIFF", 0, None, 2, 0.0, None, "tifffile"),
    ("gwyddion.txt", lambda p: gwyddion_text(p, False), "text matrix", 0, "Height", 0, 0.0, None, None),
    ("gwyddion_comma.txt", lambda p: gwyddion_text(p, True), "text matrix", 0, "Height", 0, 0.0, None, None),
]


def make():
    rows = []
    for name, maker, form, page, channel, missing, tolerance, angle, _ in TABLE:
        maker(HERE / name)
        rows.append({"file": name, "format": form, "page": page, "channel": channel, "missing": missing, "tolerance_nm": tolerance, "angle_deg": angle})
    truth = {"pitch_nm": PITCH_NM, "missing": MISSING, "heights_nm": surface_nm().tolist(), "files": rows}
    (HERE / "truth.json").write_text(json.dumps(truth, indent=1) + "\n")


def found(name, reader, channel):
    """Heights in nm with row 0 at +y and pitch in nm, as another program reads them."""
    path = str(HERE / name)
    if reader == "igor":
        import igor2

        wave = igor2.binarywave.load(path)["wave"]
        return wave["wData"].reshape(NY, NX)[::-1] * 1e9, (wave["wave_header"]["hsA"] * 1e9, PITCH_NM[1])
    if reader == "nsfopen":
        import NSFopen

        file = NSFopen.read(path)
        return np.asarray(file.data["Image"]["Forward"]["Z-Axis"])[::-1] * 1e9, PITCH_NM
    if reader == "surfalize":
        import surfalize

        surface = surfalize.Surface.load(path)
        return surface.data * 1e3, (surface.step_x * 1e3, surface.step_y * 1e3)
    if reader == "tifffile":
        import tifffile

        values = tifffile.imread(path)
        if values.ndim == 3:
            values, opacity = values if values.shape[0] == 2 else np.moveaxis(values, 2, 0)
            values = np.where(opacity > 0.0, values, np.nan)
        return values, PITCH_NM
    import SurfaceTopography.IO as io

    opened = io.open_topography(path)
    wanted = (channel or "").split(" (")[0]
    names = [one.name for one in opened.channels]
    kinds = {"Height Sensor": "ZSensor", "Z-Axis": "Scan forward (Z-Axis)"}
    index = next((i for i, one in enumerate(names) if one in (wanted, kinds.get(wanted))), 0)
    read = opened.topography(channel_index=index)
    # surfalize writes units of .sur in UTF-8, this reader takes them for Latin-1.
    nm = {"m": 1e9, "nm": 1.0, "µm": 1e3, "Âµm": 1e3}[read.unit]
    extent = read.physical_sizes
    return np.ma.filled(np.ma.masked_invalid(read.heights()), np.nan).T * nm, (extent[0] / NX * nm, extent[1] / NY * nm)


def check():
    truth = surface_nm()
    for name, _, _, _, channel, missing, tolerance, _, reader in TABLE:
        if reader is None:
            continue
        heights, pitch = found(name, reader, channel)
        # Differences from the mean: programs keep or drop a constant.
        known = np.isfinite(heights)
        difference = np.abs((heights - truth - np.mean((heights - truth)[known]))[known]).max()
        assert (~known).sum() == missing, (name, (~known).sum())
        assert difference <= 2.0 * tolerance + 1e-5, (name, reader, difference)
        assert np.allclose(pitch, PITCH_NM, rtol=1e-6), (name, reader, pitch)
        print(f"{name}: {reader} agrees to {difference:.2g} nm")


if __name__ == "__main__":
    if "--check" not in sys.argv[1:]:
        make()
    check()
