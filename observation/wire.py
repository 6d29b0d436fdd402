"""TCPROS: fields of a connection and messages, each behind its length."""

from __future__ import annotations

import socket
import struct
from collections.abc import Mapping

_LENGTH = struct.Struct("<I")
LONGEST = 1 << 30
"""A message of more bytes is none."""


class WireError(Exception):
    """A connection that broke, or something else than TCPROS on it."""


def packed_fields(fields: Mapping[str, str]) -> bytes:
    """Fields as they are at the head of a connection, without the length of all."""
    items = [f"{name}={value}".encode() for name, value in fields.items()]
    return b"".join(_LENGTH.pack(len(item)) + item for item in items)


def unpacked_fields(data: bytes) -> dict[str, bytes]:
    """The fields in `data`.

    Raises:
        WireError: these are no fields.
    """
    fields, at = {}, 0
    while at < len(data):
        if at + 4 > len(data):
            raise WireError("a field without a length")
        (length,) = _LENGTH.unpack_from(data, at)
        name, found, value = data[at + 4 : at + 4 + length].partition(b"=")
        at += 4 + length
        if not found or at > len(data):
            raise WireError("a field that is cut off" if at > len(data) else "a field without `=`")
        fields[name.decode("utf-8", "replace")] = value
    return fields


def send_block(connection: socket.socket, data: bytes) -> None:
    """Send something behind its length."""
    connection.sendall(_LENGTH.pack(len(data)) + data)


def receive_block(connection: socket.socket) -> bytes:
    """What comes behind its length.

    Raises:
        WireError: the connection was closed, or what comes is too long.
    """
    (length,) = _LENGTH.unpack(receive(connection, 4))
    if length > LONGEST:
        raise WireError(f"{length} bytes announced")
    return receive(connection, length)


def receive(connection: socket.socket, count: int) -> bytes:
    """The next `count` bytes.

    Raises:
        WireError: the connection was closed before.
    """
    parts = bytearray()
    while len(parts) < count:
        part = connection.recv(min(count - len(parts), 1 << 16))
        if not part:
            raise WireError("connection closed")
        parts += part
    return bytes(parts)


def receive_fields(connection: socket.socket) -> dict[str, str]:
    """The fields at the head of a connection."""
    return {name: value.decode("utf-8", "replace") for name, value in unpacked_fields(receive_block(connection)).items()}
