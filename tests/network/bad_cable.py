"""A cable that delays and loses frames, for kernels without network emulation.

    bad_cable.py FROM TO DELAY_MS LOSS_PERCENT

It passes Ethernet frames between two interfaces. Those from the first to the second are delayed, and some are lost; the
others are passed on at once. It runs until it is killed.
"""

import array
import contextlib
import fcntl
import heapq
import itertools
import random
import select
import socket
import struct
import sys
import time
from typing import List, Tuple

_ALL_PROTOCOLS = 3
_LONGEST = 65_536
_SIOCETHTOOL = 0x8946
#: Of ethtool: checksums and segments are left to the hardware, which a frame between two sockets never sees.
_OFFLOADS = (0x17, 0x1F, 0x24, 0x2C)


def without_offloads(interface: str) -> None:
    """Make the kernel finish each frame that it sends through an interface.

    Raises:
        OSError: it refuses
    """
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as control:
        for command in _OFFLOADS:
            value = array.array("I", (command, 0))
            fcntl.ioctl(control, _SIOCETHTOOL, struct.pack("16sP", interface.encode(), value.buffer_info()[0]))


def _opened(interface: str) -> socket.socket:
    found = socket.socket(socket.AF_PACKET, socket.SOCK_RAW, socket.htons(_ALL_PROTOCOLS))
    found.bind((interface, 0))
    found.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, 4 << 20)
    return found


def pass_on(source: str, sink: str, *, delay_s: float, loss: float) -> None:
    """Pass frames on between two interfaces until the process ends."""
    chance, number = random.Random(1), itertools.count()
    first, second = _opened(source), _opened(sink)
    waiting: List[Tuple[float, int, bytes]] = []
    while True:
        wait_s = max(0.0, waiting[0][0] - time.monotonic()) if waiting else None
        readable, _, _ = select.select([first, second], [], [], wait_s)
        for interface in readable:
            frame, address = interface.recvfrom(_LONGEST)
            if address[2] == socket.PACKET_OUTGOING:
                continue
            if interface is second:
                _send(first, frame)
            elif chance.random() >= loss:
                heapq.heappush(waiting, (time.monotonic() + delay_s, next(number), frame))
        while waiting and waiting[0][0] <= time.monotonic():
            _send(second, heapq.heappop(waiting)[2])


def _send(interface: socket.socket, frame: bytes) -> None:
    # Where the interface is down, or its queue full, a cable would lose it as well.
    with contextlib.suppress(OSError):
        interface.send(frame)


if __name__ == "__main__":
    if sys.argv[1] == "--without-offloads":
        without_offloads(sys.argv[2])
    else:
        pass_on(sys.argv[1], sys.argv[2], delay_s=float(sys.argv[3]) / 1e3, loss=float(sys.argv[4]) / 100.0)
