"""Cuts an uncompressed, one-strip TIFF (or a GSF) down to its first rows, and leaves every other byte as its program wrote it.

    python cut_rows.py IN OUT ROWS
"""

import pathlib
import struct
import sys


def cut_tiff(data, rows):
    """The file with the height, rows per strip and bytes per strip of fewer rows; its strip must end the file."""
    order = "<" if data[:2] == b"II" else ">"
    assert struct.unpack(order + "H", data[2:4])[0] == 42, "classic TIFF only"
    start, = struct.unpack(order + "I", data[4:8])
    count, = struct.unpack(order + "H", data[start : start + 2])
    tags = {}
    for n in range(count):
        at = start + 2 + 12 * n
        tag, kind, number = struct.unpack(order + "HHI", data[at : at + 8])
        if number == 1 and kind in (3, 4):
            tags[tag] = (at + 8, order + "HI"[kind - 3])
    value = {tag: struct.unpack_from(form, data, at)[0] for tag, (at, form) in tags.items()}
    assert value.get(259, 1) == 1, "uncompressed only"
    row_bytes = value[256] * value.get(277, 1) * value.get(258, 8) // 8
    old = row_bytes * value[257]
    end = value[273] + old
    data = bytearray(data)
    for tag, (at, form) in tags.items():
        if tag in (257, 278):
            struct.pack_into(form, data, at, rows)
        if tag == 279:
            # As wrong as it was: one program counts bits.
            struct.pack_into(form, data, at, value[279] * rows // value[257])
    tail = data[end:]
    assert not tail.strip(b"\0"), f"{len(tail)} bytes follow the strip"
    return bytes(data[: value[273] + row_bytes * rows])


def cut_gsf(data, rows):
    """The field with fewer rows and as much less of its length along y."""
    header = data[: data.index(b"\0")].decode()
    fields = {key.strip(): text for key, _, text in (line.partition("=") for line in header.splitlines())}
    columns, old = int(fields["XRes"]), int(fields["YRes"])
    samples = data[-4 * columns * old :][: 4 * columns * rows]
    lines = []
    for line in header.splitlines():
        key, _, text = line.partition("=")
        if key.strip() == "YRes":
            line = f"YRes = {rows}"
        if key.strip() == "YReal":
            line = f"YReal = {float(text) * rows / old!r}"
        lines.append(line)
    text = ("\n".join(lines) + "\n").encode()
    return text + b"\0" * (4 - len(text) % 4) + samples


def main():
    source, target, rows = sys.argv[1:]
    data = pathlib.Path(source).read_bytes()
    cut = cut_gsf if source.endswith(".gsf") else cut_tiff
    pathlib.Path(target).write_bytes(cut(data, int(rows)))


if __name__ == "__main__":
    main()
