"""Bytes as text of a page: the counterpart of web/src/packed.ts."""

from __future__ import annotations

from base64 import b85encode


def digits(data: bytes) -> str:
    """Five digits of base 85 (RFC 1924) for four bytes, with `,` for `<`: no digits are markup."""
    return b85encode(data).decode().replace("<", ",")
