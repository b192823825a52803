"""Zips written byte by byte, with names as no library would write them."""

from __future__ import annotations

import struct
import zlib
from collections.abc import Sequence
from dataclasses import dataclass, field

UTF8 = 1 << 11
FAT, UNIX = 0, 3


def unicode_path(raw: bytes, name: bytes, crc: int | None = None) -> bytes:
    """Info-ZIP's extra field 0x7075, which says a name in UTF-8 beside that of the header."""
    content = struct.pack("<BI", 1, zlib.crc32(raw) if crc is None else crc) + name
    return struct.pack("<HH", 0x7075, len(content)) + content


@dataclass(frozen=True)
class Member:
    name: bytes
    text: bytes = b"x"
    flags: int = 0
    extra: bytes = b""
    #: What the archive's directory says, where it is not what the header says.
    central_name: bytes | None = None
    central_extra: bytes | None = None
    system: int = UNIX
    attributes: int = field(default=0o100644 << 16)


def zip_bytes(members: Sequence[Member], *, large: bool = False) -> bytes:
    """`large` has the directory say every place in 64 bits."""
    data, directory = b"", b""
    for member in members:
        offset, size = len(data), len(member.text)
        said = struct.pack("<HHHHIII", member.flags, 0, 0, 33, zlib.crc32(member.text), size, size)
        lengths = struct.pack("<HH", len(member.name), len(member.extra))
        data += b"PK\3\4" + struct.pack("<H", 20) + said + lengths
        data += member.name + member.extra + member.text
        name = member.name if member.central_name is None else member.central_name
        extra = member.extra if member.central_extra is None else member.central_extra
        if large:
            extra = struct.pack("<HHQ", 1, 8, offset) + extra
            offset = 0xFFFFFFFF
        directory += b"PK\1\2" + struct.pack("<BBH", 20, member.system, 20) + said
        directory += struct.pack("<HHHHH", len(name), len(extra), 0, 0, 0)
        directory += struct.pack("<II", member.attributes, offset) + name + extra
    count, size, offset = len(members), len(directory), len(data)
    end = b""
    if large:
        end += b"PK\6\6" + struct.pack("<QHHIIQQQQ", 44, 45, 45, 0, 0, count, count, size, offset)
        end += b"PK\6\7" + struct.pack("<IQI", 0, offset + size, 1)
        size, offset = 0xFFFFFFFF, 0xFFFFFFFF
    end += b"PK\5\6" + struct.pack("<HHHHIIH", 0, 0, count, count, size, offset, 0)
    return data + directory + end
