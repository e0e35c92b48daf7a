"""A log handler whose callers never wait: a thread writes the records."""

import logging
import queue
import sys
import threading
import time
from typing import List, Optional

from roboframenet_ros.bounded_text import as_log_lines

_FORMATTER = logging.Formatter()
# Who logs is often about to pass something on, and the threads of a Python process run one at a time: what is less than
# a warning is written this much later.
_GATHER_S = 0.02
_LOOK_PERIOD_S = 0.005


class _LogLines(str):
    """The message of a record that is fit for a log."""


class LogThread(logging.Handler):
    """Hands each record to another handler, in a thread of its own.

    Handlers may wait for a disk, for a halted terminal, or for a master that hangs. Callers of log functions must not
    wait with them. When too many records are queued, further ones are dropped and counted. What people say and servers
    send is logged too: nothing in it can look like another record, or control the terminal.
    """

    def __init__(self, handler: logging.Handler, *, max_waiting: int = 10_000) -> None:
        """Start the thread.

        Args:
            handler: writes the records
            max_waiting: most records in the queue
        """
        super().__init__(handler.level)
        self._handler = handler
        # Ctrl-C may come while the main thread puts a record there, and its hooks log, too: no lock may be held.
        self._records: queue.SimpleQueue[logging.LogRecord] = queue.SimpleQueue()
        self._max_waiting = max_waiting
        self._put = self._written = self._dropped = 0
        # A daemon: a handler that hangs must not keep the process alive.
        self._thread = threading.Thread(target=self._write_on, name="log", daemon=True)
        self._thread.start()

    def emit(self, record: logging.LogRecord) -> None:
        """Take a record; returns at once."""
        # The arguments may change before the thread formats them.
        if record.args or not isinstance(record.msg, _LogLines):
            # A record passes through here once for each handler.
            record.msg, record.args = _LogLines(as_log_lines(record.getMessage())), None
        if record.exc_info and not record.exc_text:
            # Formatters use the text if there is one.
            record.exc_text = as_log_lines(_FORMATTER.formatException(record.exc_info))
        if self._records.qsize() < self._max_waiting:
            # Counted first: whoever waits must not overlook it.
            self._put += 1
            self._records.put(record)
        else:
            self._dropped += 1

    def wait_until_written(self, *, timeout_s: float) -> bool:
        """Wait until all records so far are written; returns whether they are."""
        end_s = time.monotonic() + timeout_s
        while self._written < self._put:
            if time.monotonic() >= end_s:
                return False
            time.sleep(_LOOK_PERIOD_S)
        return True

    def _write_on(self) -> None:
        while True:
            record = self._records.get()
            if record.levelno < logging.WARNING and self._records.empty():
                time.sleep(_GATHER_S)
            try:
                dropped, self._dropped = self._dropped, 0
                if dropped:
                    self._handler.handle(
                        logging.LogRecord(
                            record.name, logging.WARNING, __file__, 0, f"{dropped} log records were dropped", None, None
                        )
                    )
                self._handler.handle(record)
            except Exception as error:  # boundary: a handler may fail in any way; to log that would never end
                sys.stderr.write(f"a log record is lost: {type(error).__name__}: {error}\n")
            self._written += 1


def put_threads_before(logger: logging.Logger) -> List[LogThread]:
    """Put a `LogThread` before each handler of a logger, and of the loggers above it.

    One for each, so that the terminal does not wait for the handler that calls the master. A second call only covers
    handlers that were added meanwhile.
    """
    handlers: List[logging.Handler] = []
    above: Optional[logging.Logger] = logger
    while above is not None:
        handlers += above.handlers
        above = above.parent if above.propagate else None
    threads = [handler if isinstance(handler, LogThread) else LogThread(handler) for handler in handlers]
    logger.handlers = list(threads)
    logger.propagate = False
    return threads
