"""Uploads that mean harm, by what is wrong with them; each starts from a sound cell."""

from __future__ import annotations

import io
import stat
import struct
import zipfile
from collections.abc import Callable
from pathlib import Path

from tests.core.robot.mesh_bytes import BAD

CELL = Path(__file__).parents[2] / "cells" / "lwr4_bench"
Files = dict[str, bytes]


def sound() -> Files:
    return {file.name: file.read_bytes() for file in sorted(CELL.iterdir())}


def zipped(files: Files, method: int = zipfile.ZIP_DEFLATED) -> bytes:
    whole = io.BytesIO()
    with zipfile.ZipFile(whole, "w", method) as archive:
        for name, content in files.items():
            archive.writestr(name, content)
    return whole.getvalue()


def _with(**changes: bytes) -> bytes:
    return zipped(sound() | changes)


def _extra(name: str, content: bytes = b"x") -> Callable[[], bytes]:
    return lambda: zipped(sound() | {name: content})


def _swapped(file: str, old: str, new: str) -> Callable[[], bytes]:
    def make() -> bytes:
        files = sound()
        text = files[file].decode()
        assert old in text, old
        return zipped(files | {file: text.replace(old, new, 1).encode()})

    return make


def _toml(old: str, new: str) -> Callable[[], bytes]:
    return _swapped("cell.toml", old, new)


def _urdf(old: str, new: str) -> Callable[[], bytes]:
    return _swapped("robot.urdf", old, new)


def _declared(declarations: str, use: str = "") -> Callable[[], bytes]:
    """A document type before the robot, and an entity in its name."""

    def make() -> bytes:
        text = sound()["robot.urdf"].decode()
        body = text[text.index("<robot") :].replace('<robot name="', f'<robot name="{use}', 1)
        return _with(**{"robot.urdf": f"<?xml version='1.0'?>\n<!DOCTYPE robot [{declarations}]>\n{body}".encode()})

    return make


def _mesh(name: str, content: bytes | None = None, file: str = "hand.stl", of: str = "collision") -> Callable[[], bytes]:
    """The first link's shape for collisions, or its looks, is a mesh."""

    def make() -> bytes:
        files = sound()
        text = files["robot.urdf"].decode()
        begin = text.index("<geometry>", text.index(f"<{of}>")) + len("<geometry>")
        text = text[:begin] + f'<mesh filename="{name}"/>' + text[text.index("</geometry>", begin) :]
        return zipped(files | {"robot.urdf": text.encode()} | ({} if content is None else {file: content}))

    return make


def _special(kind: int, name: str, content: bytes) -> Callable[[], bytes]:
    """A sound cell in which one file is a link or a device."""

    def make() -> bytes:
        whole = io.BytesIO()
        with zipfile.ZipFile(whole, "w") as archive:
            for each, text in sound().items():
                if each != name:
                    archive.writestr(each, text)
            entry = zipfile.ZipInfo(name)
            entry.create_system, entry.external_attr = 3, (kind | 0o777) << 16
            archive.writestr(entry, content)
        return whole.getvalue()

    return make


def _twice() -> bytes:
    whole = io.BytesIO(zipped(sound()))
    with zipfile.ZipFile(whole, "a") as archive:
        entry = zipfile.ZipInfo("CELL.toml")
        archive.writestr(entry, sound()["cell.toml"])
    return whole.getvalue()


def _nested_zip() -> bytes:
    inner = zipped({f"{k}.txt": bytes(1_000_000) for k in range(20)})
    return zipped(sound() | {"inner.zip": zipped({"a.zip": inner, "b.zip": inner})})


def _lying_size() -> bytes:
    """The directory says that cell.toml is short; the stream holds 80 MB."""
    whole = bytearray(zipped(sound() | {"notes.txt": bytes(80_000_000)}))
    for mark, at in ((b"PK\x03\x04", 22), (b"PK\x01\x02", 24)):
        start = whole.rfind(mark)
        whole[start + at : start + at + 4] = struct.pack("<I", 10)
    return bytes(whole)


def _encrypted() -> bytes:
    whole = bytearray(zipped(sound()))
    for mark, at in ((b"PK\x03\x04", 6), (b"PK\x01\x02", 8)):
        whole[whole.find(mark) + at] |= 1
    return bytes(whole)


def _huge_stl(triangles: int, held: int) -> bytes:
    return bytes(80) + struct.pack("<I", triangles) + bytes(50 * held)


def _many_links(count: int) -> bytes:
    links = "".join(f'<link name="extra{k}"/>' for k in range(count))
    joints = "".join(f'<joint name="fix{k}" type="fixed"><parent link="base"/><child link="extra{k}"/></joint>' for k in range(count))
    text = sound()["robot.urdf"].decode()
    return _with(**{"robot.urdf": text.replace("</robot>", links + joints + "</robot>").encode()})


def _many_boxes(count: int) -> bytes:
    box = '[[obstacles]]\nname = "o{}"\nshape = {{ kind = "box", size_m = [0.1, 0.1, 0.1], pose.xyz_m = [5.0, 5.0, 5.0] }}\n'
    text = sound()["cell.toml"] + b"\n" + "".join(box.format(k % 7) for k in range(count)).encode()
    return _with(**{"cell.toml": text})


LAUGHS = "".join(f'<!ENTITY l{k + 1} "{f"&l{k};" * 10}">' for k in range(9))

HOSTILE: dict[str, Callable[[], bytes]] = {
    "XXE of a file": _declared('<!ENTITY x SYSTEM "file:///etc/passwd">', "&x;"),
    "XXE of an address": _declared('<!ENTITY x SYSTEM "http://127.0.0.1:9/x">', "&x;"),
    "XXE by a parameter": _declared('<!ENTITY % x SYSTEM "file:///etc/passwd"> %x;'),
    "an external document type": lambda: _with(
        **{"robot.urdf": b'<!DOCTYPE robot SYSTEM "file:///etc/passwd"><robot name="r"><link name="base"/></robot>'}
    ),
    "billion laughs": _declared(f'<!ENTITY l0 "lol">{LAUGHS}', "&l9;"),
    "quadratic blow-up": _declared(f'<!ENTITY big "{"a" * 100_000}">', "&big;" * 1000),
    "document type in UTF-16": lambda: _with(
        **{"robot.urdf": '<?xml version="1.0" encoding="utf-16"?><!DOCTYPE robot [<!ENTITY x "y">]><robot name="&x;"/>'.encode("utf-16")}
    ),
    "../ in the zip": _extra("../evil.txt"),
    "../ deep in the zip": _extra("meshes/../../evil.txt"),
    "absolute in the zip": _extra("/tmp/evil.txt"),
    "a drive in the zip": _extra("C:/evil.txt"),
    "backslashes in the zip": _extra("..\\evil.txt"),
    "NUL in a name": lambda: _extra("evil_.so.txt")().replace(b"evil_", b"evil\0"),
    "a new line in a name": _extra("evil\n.txt"),
    "a hidden file": _extra(".bashrc.txt"),
    "a very long name": _extra("a" * 300 + ".txt"),
    "folders without end": _extra("a/" * 50 + "evil.txt"),
    "a program": _extra("sitecustomize.py"),
    "a shared library": _extra("libc.so"),
    "a twin with an effect that there is not": _extra("twin.json", b'{"effects": [{"effect": "haunting"}]}'),
    "a twin that is no JSON": _extra("twin.json", b"\x00{"),
    "an empty zip": lambda: zipped({}),
    "no cell.toml": lambda: zipped({"robot.urdf": sound()["robot.urdf"]}),
    "no URDF": lambda: zipped({"cell.toml": sound()["cell.toml"]}),
    "wrong case": lambda: zipped({"Cell.toml": sound()["cell.toml"], "robot.urdf": sound()["robot.urdf"]}),
    "the same name in two cases": _twice,
    "no zip": lambda: b"MZ" + bytes(5000),
    "a zip that breaks off": lambda: zipped(sound())[:-40],
    "a zip with a wrong checksum": lambda: zipped(sound(), zipfile.ZIP_STORED).replace(b"KUKA LWR", b"KUKA XXX", 1),
    "an encrypted zip": _encrypted,
    "a zip in the zip": _nested_zip,
    "a zip bomb": _extra("notes.txt", bytes(200_000_000)),
    "a zip bomb that lies": _lying_size,
    "a bomb by another method": lambda: zipped(sound() | {"notes.txt": bytes(2_000_000)}, zipfile.ZIP_LZMA),
    "a huge cell.toml": lambda: _with(**{"cell.toml": sound()["cell.toml"] + b"#" * 3_000_000}),
    "thousands of files": lambda: zipped(sound() | {f"f{k}.txt": b"" for k in range(5000)}),
    "a link to a file": _special(stat.S_IFLNK, "robot.urdf", b"/etc/passwd"),
    "a link to a folder": _special(stat.S_IFLNK, "meshes.txt", b"/etc"),
    "a pipe": _special(stat.S_IFIFO, "pipe.txt", b""),
    "a device": _special(stat.S_IFCHR, "zero.txt", b""),
    "robot.urdf with ../": _toml("[robot]", '[robot]\nurdf = "../../../../etc/passwd"'),
    "robot.urdf absolute": _toml("[robot]", '[robot]\nurdf = "/etc/passwd"'),
    "mesh with ../": _mesh("../../../../etc/passwd"),
    "mesh absolute": _mesh("/etc/passwd"),
    "mesh by package://": _mesh("package://heft/../../etc/passwd"),
    "mesh by file://": _mesh("file:///etc/passwd"),
    "mesh by http://": _mesh("http://127.0.0.1:9/hand.stl"),
    "mesh with backslashes": _mesh("..\\..\\hand.stl"),
    "mesh in the wrong case": _mesh("Hand.stl", _huge_stl(1, 1)),
    "mesh that names files": _mesh("hand.dae", b"<COLLADA/>", "hand.dae"),
    "mesh that says it is huge": _mesh("hand.stl", _huge_stl(2**32 - 1, 2)),
    "mesh that is huge": _mesh("hand.stl", _huge_stl(1_100_000, 1_100_000)),
    "mesh that is text": _mesh("hand.stl", b"solid x\n" + b"facet normal nan nan nan\n" * 10),
    "looks that say they are huge": _mesh("hand.stl", _huge_stl(2**32 - 1, 2), of="visual"),
    "looks that break off": _mesh("hand.stl", _huge_stl(1000, 2), of="visual"),
    **{f"mesh that is {what}": _mesh(file, content, file) for what, (file, content, scale, _) in BAD.items() if scale == "1 1 1"},
    "include": _urdf("</robot>", '<include filename="robot.urdf"/></robot>'),
    "xacro include": _urdf("</robot>", '<xacro:include xmlns:xacro="http://x" filename="/etc/passwd"/></robot>'),
    "XInclude": _urdf("</robot>", '<xi:include xmlns:xi="http://www.w3.org/2001/XInclude" href="/etc/passwd"/></robot>'),
    "a mass that is NaN": _urdf('mass value="', 'mass value="nan'),
    "a negative mass": _urdf('mass value="', 'mass value="-'),
    "an endless mass": _urdf('mass value="', 'mass value="1e999'),
    "a name twice": _urdf("</robot>", '<link name="base"/></robot>'),
    "a loop of links": _urdf("</robot>", '<joint name="loop" type="fixed"><parent link="ft_sensor"/><child link="base"/></joint></robot>'),
    "XML without end": _urdf("</robot>", "<a>" * 100_000),
    "XML too deep": _urdf("</robot>", "<a>" * 5000 + "</a>" * 5000 + "</robot>"),
    "URDF not UTF-8": lambda: _with(**{"robot.urdf": b"\xff\xfe\xfa" + sound()["robot.urdf"]}),
    "TOML not UTF-8": lambda: _with(**{"cell.toml": b'name = "\xff"'}),
    "TOML too deep": lambda: _with(**{"cell.toml": b"a = " + b"[" * 100_000}),
    "a clearance that is NaN": _toml("clearance_m = 0.03", "clearance_m = nan"),
    "an endless clearance": _toml("clearance_m = 0.03", "clearance_m = inf"),
    "a key that nobody knows": _toml("[limits]", "[limits]\nno_limits = true"),
    "a name that leads outside": _toml('name = "lwr4_bench"', 'name = "../lwr4_bench"'),
    "tens of thousands of links": lambda: _many_links(30_000),
    "thousands of names twice": lambda: _many_boxes(500),
}
