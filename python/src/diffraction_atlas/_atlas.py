"""An atlas on disk."""

from __future__ import annotations

import hashlib
import json
from pathlib import Path
from typing import Any, Iterator, Mapping

from ._images import AtlasError
from ._specimen import SCHEMAS, Specimen, read_about


class Atlas(Mapping[str, Specimen]):
    """One version of an atlas: a mapping from names to specimens, which are read when they are first asked for."""

    def __init__(self, folder: Path, index: dict[str, Any], check_digests: bool):
        #: Folder of the version.
        self.folder = folder
        #: What atlas.json holds.
        self.index = index
        self._digests = {file["path"]: file for file in index["files"]} if check_digests else None
        self._read: dict[str, Specimen] = {}

    @property
    def name(self) -> str:
        """Its name in the manifest."""
        return self.index["name"]

    @property
    def names(self) -> list[str]:
        """Names of the specimens, in the order of the manifest."""
        return [entry["name"] for entry in self.index["specimens"]]

    def __getitem__(self, name: str) -> Specimen:
        if name not in self._read:
            if name not in self.names:
                raise KeyError(f"{self.folder} holds no specimen {name!r}; it holds {', '.join(self.names)}")
            if self._digests is not None:
                self._check(name)
            self._read[name] = Specimen(self.folder / name)
        return self._read[name]

    def __iter__(self) -> Iterator[str]:
        return iter(self.names)

    def __len__(self) -> int:
        return len(self.names)

    def __repr__(self) -> str:
        return f"<Atlas {self.name!r} at {self.folder}: {', '.join(self.names)}>"

    def _check(self, name: str) -> None:
        """Whether the files of a specimen's tables are those that were published."""
        about = read_about(self.folder / name)
        for file in ["specimen.json", *_files(about)]:
            relative, path = f"{name}/{file}", self.folder / name / file
            listed = self._digests.get(relative)
            if listed is None:
                raise AtlasError(f"atlas.json does not list {path}; restore the atlas, or run the pipeline again")
            try:
                digest = hashlib.sha256(path.read_bytes()).hexdigest()
            except OSError as error:
                raise AtlasError(f"{path} cannot be read: {error}. Restore it, or run the pipeline again") from error
            if digest != listed["sha256"]:
                raise AtlasError(
                    f"{path} is not the file that was published: its digest differs. Restore it, run the pipeline again, or open the "
                    "atlas with check_digests=False"
                )


def _files(part: Any) -> Iterator[str]:
    """Names of the images that specimen.json names under `tables` and `spectral`."""
    if isinstance(part, dict):
        if isinstance(part.get("file"), str) and "scale" in part:
            yield part["file"]
        for key in part:
            if key not in ("check_values", "provenance"):
                yield from _files(part[key])
    elif isinstance(part, list):
        for value in part:
            yield from _files(value)


def open(path: str | Path, *, check_digests: bool = True) -> Atlas:  # noqa: A001
    """An atlas: the folder that a run writes, whose newest version is taken, or the folder of one version.

    Specimens are `atlas["name"]`, their names `atlas.names`. With `check_digests`, files are held against their digests in atlas.json when a specimen is read.
    """
    folder = Path(path)
    if not folder.is_dir():
        raise AtlasError(f"there is no folder {folder}")
    latest = folder / "latest"
    if latest.is_file():
        folder = folder / latest.read_text(encoding="utf-8").strip()
    if (folder / "specimen.json").is_file():
        raise AtlasError(f"{folder} is the folder of a specimen: use Specimen({str(folder)!r}), or open the folder above")
    if not (folder / "atlas.json").is_file():
        raise AtlasError(f'{path} is no atlas: it has neither a file "latest", which names a version, nor "atlas.json" of one')
    try:
        index = json.loads((folder / "atlas.json").read_text(encoding="utf-8"))
    except (OSError, ValueError) as error:
        raise AtlasError(f"{folder / 'atlas.json'} cannot be read: {error}. Restore it, or run the pipeline again") from error
    if index.get("schema") not in SCHEMAS:
        raise AtlasError(f"{folder} has the schema {index.get('schema')}; this version of diffraction_atlas reads {SCHEMAS[0]} to {SCHEMAS[-1]}")
    return Atlas(folder, index, check_digests)
