"""Fetch a package pinned in tools/pinned_packages.tsv and unpack it, for the catalogue builders.

Builders are run by hand; nothing of the build, the tests or the program downloads anything. Debian
packages come through `apt-get download`, npm packages through `npm pack`; the archive's SHA-256 must be
the pinned one. Unpacked trees are kept in ~/.cache/antumbra (or $ANTUMBRA_CACHE).

    from pinned_package import unpacked
    folder = unpacked("three-globe")        # holds package/… (npm) or usr/… (Debian)
"""
import csv
import hashlib
import os
import pathlib
import subprocess
import sys
import tempfile

PINS = pathlib.Path(__file__).with_name("pinned_packages.tsv")
CACHE = pathlib.Path(os.environ.get("ANTUMBRA_CACHE", pathlib.Path.home() / ".cache/antumbra"))


def pin(name):
    with PINS.open() as file:
        for row in csv.DictReader(file, delimiter="\t"):
            if row["package"] == name:
                return row
    raise SystemExit(f"{PINS.name}: no package '{name}'")


def unpacked(name):
    row = pin(name)
    folder = CACHE / f"{name.replace('/', '_')}-{row['sha256'][:16]}"
    if folder.exists():
        return folder
    CACHE.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory(dir=CACHE) as work:
        work = pathlib.Path(work)
        print(f"fetching {row['registry']} {name} {row['version']}", file=sys.stderr)
        command = (["apt-get", "download", "-q", f"{name}={row['version']}"]
                   if row["registry"] == "deb" else
                   ["npm", "pack", "--silent", f"{name}@{row['version']}"])
        subprocess.run(command, cwd=work, check=True, stdout=sys.stderr)
        archive, = work.iterdir()
        found = hashlib.sha256(archive.read_bytes()).hexdigest()
        if found != row["sha256"]:
            raise SystemExit(f"{name} {row['version']}: found SHA-256 {found}, pinned {row['sha256']}")
        tree = work / "tree"
        tree.mkdir()
        unpack = (["dpkg-deb", "-x", archive, tree] if row["registry"] == "deb" else
                  ["tar", "-xzf", archive, "-C", tree])
        subprocess.run(unpack, check=True)
        tree.rename(folder)
    return folder
