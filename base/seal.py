"""Files that show whether they are damaged: a checksum, and below it the content."""

from __future__ import annotations

import hashlib

_DIGEST_SIZE = hashlib.sha256().digest_size


def sealed(data: bytes) -> bytes:
    """The content of a file that shows whether it is damaged."""
    return hashlib.sha256(data).digest() + data


def unsealed(content: bytes) -> bytes | None:
    """What was sealed; None when it is damaged."""
    digest, data = content[:_DIGEST_SIZE], content[_DIGEST_SIZE:]
    return data if hashlib.sha256(data).digest() == digest else None


def below_seal(content: bytes) -> memoryview:
    """What was sealed, in a file that is known to be whole."""
    return memoryview(content)[_DIGEST_SIZE:]
