"""The messages of an MCAP file, from the first to the last and never more than a chunk of them in memory."""

from __future__ import annotations

import io
import struct
import zlib
from collections.abc import Iterator
from pathlib import Path
from typing import BinaryIO

import lz4.frame
import numpy as np
import zstandard
from mcap.exceptions import McapError
from mcap.opcode import Opcode
from mcap.records import Channel, Chunk, Message, Schema
from mcap.stream_reader import StreamReader
from rosbags.typesys import TypesysError, get_types_from_idl, get_types_from_msg

from core.errors import BadRecording
from core.recording.bags.kernels import find_records
from core.recording.bags.layout import Fields
from core.recording.bags.topic import MessageBatch, Topic

MOST_CHUNK_BYTES = 512_000_000
MOST_TOPICS = 2000
LOOSE = 5000
"""Messages outside of chunks that are gathered to a batch."""
BROKEN = (McapError, ValueError, EOFError, RuntimeError, MemoryError, OSError, struct.error, zstandard.ZstdError)
"""What `mcap` and the compressions say of a file that is broken; ValueError has those of checksums and texts."""


class _BoundedFile:
    """A file of which nobody asks for more than is there: a length in a broken file is not worth gigabytes."""

    def __init__(self, file: BinaryIO, size: int) -> None:
        self.file, self.left = file, size

    def read(self, size: int = -1) -> bytes:
        if size < 0 or size > self.left:
            raise EOFError("the file ends within a record")
        self.left -= size
        return self.file.read(size)


class McapFile:
    """One file."""

    def __init__(self, file: Path) -> None:
        self.file = file
        self._schemas: dict[int, Schema] = {}
        self._topics: dict[int, Topic | None] = {}

    def batches(self) -> Iterator[MessageBatch]:
        """All messages in CDR whose definition is known, by topic and in the order of the file.

        Raises:
            BadRecording: it is truncated or damaged.
        """
        try:
            with self.file.open("rb") as stream:
                yield from self._read(stream)
        except BROKEN as error:
            raise BadRecording(str(self.file), "bag-broken", reason=" ".join(str(error).split())[:160] or type(error).__name__) from error

    def _read(self, stream: BinaryIO) -> Iterator[MessageBatch]:
        size = self.file.stat().st_size
        reader = StreamReader(_BoundedFile(stream, size), emit_chunks=True, record_size_limit=size)  # type: ignore[arg-type]  # it only reads
        loose: list[Message] = []
        for record in reader.records:
            match record:
                case Chunk():
                    yield from self._split(_unpack(record))
                case Schema() | Channel():
                    self._learn(record)
                case Message():
                    loose.append(record)
                    if len(loose) >= LOOSE:
                        yield from self._gather(loose)
                        loose = []
        yield from self._gather(loose)

    def _split(self, content: bytes) -> Iterator[MessageBatch]:
        """The messages of a chunk; schemas and channels stand before the first message that needs them."""
        data = np.frombuffer(content, dtype=np.uint8)
        found = find_records(data)
        for _, _, begin, size in found[found[:, 0] < 0].tolist():
            if content[begin] in {Opcode.SCHEMA, Opcode.CHANNEL}:
                self._learn(next(iter(StreamReader(io.BytesIO(content[begin : begin + size]), skip_magic=True).records)))
        for channel in np.unique(found[found[:, 0] >= 0, 0]):
            if (topic := self._topic(int(channel))) is not None:
                of_it = found[found[:, 0] == channel]
                yield MessageBatch(topic, 1e-9 * of_it[:, 1], data, of_it[:, 2].copy(), of_it[:, 3].copy())

    def _gather(self, messages: list[Message]) -> Iterator[MessageBatch]:
        for channel in sorted({each.channel_id for each in messages}):
            if (topic := self._topic(channel)) is not None:
                yield MessageBatch.of(topic, [(each.log_time, each.data) for each in messages if each.channel_id == channel])

    def _learn(self, record: object) -> None:
        if isinstance(record, Schema):
            self._schemas[record.id] = record
        elif isinstance(record, Channel) and record.id not in self._topics:
            if len(self._topics) >= MOST_TOPICS:
                raise ValueError(f"more than {MOST_TOPICS} channels")
            self._topics[record.id] = self._describe(record)

    def _describe(self, channel: Channel) -> Topic | None:
        schema = self._schemas.get(channel.schema_id)
        fields = None if channel.message_encoding != "cdr" or schema is None else _parse(schema)
        return None if fields is None or schema is None else Topic(channel.topic, schema.name, fields)

    def _topic(self, channel: int) -> Topic | None:
        if channel not in self._topics:
            raise ValueError(f"a message of channel {channel}, which is not described")
        return self._topics[channel]


def _parse(schema: Schema) -> Fields | None:
    """The types in a definition; None where it is in no language that is known, and its messages are passed over."""
    text = schema.data.decode(errors="replace")
    try:
        return dict(get_types_from_idl(text) if schema.encoding == "ros2idl" else get_types_from_msg(text, schema.name))
    except (TypesysError, RecursionError):
        return None


def _unpack(chunk: Chunk) -> bytes:
    """The records of a chunk; no more is unpacked than it says."""
    size = chunk.uncompressed_size
    if size > MOST_CHUNK_BYTES:
        raise ValueError(f"a chunk of {size} bytes")
    if chunk.compression == "zstd":
        with zstandard.ZstdDecompressor().stream_reader(io.BytesIO(chunk.data)) as packed:
            content = packed.read(size + 1)
    elif chunk.compression == "lz4":
        content = lz4.frame.LZ4FrameDecompressor().decompress(chunk.data, max_length=size + 1)
    elif chunk.compression == "":
        content = chunk.data
    else:
        raise ValueError(f"compression {chunk.compression[:40]!r}")
    if len(content) != size:
        raise ValueError("a chunk of another size than it says")
    if chunk.uncompressed_crc and zlib.crc32(content) != chunk.uncompressed_crc:
        raise ValueError("a chunk whose checksum is wrong")
    return content
