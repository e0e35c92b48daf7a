"""Nobody who logs waits for whoever writes."""

import logging
import signal
import threading

from roboframenet_ros.log_thread import LogThread, put_threads_before


class Collecting(logging.Handler):
    def __init__(self, *, level=logging.NOTSET):
        super().__init__(level)
        self.lines = []
        self.is_free = threading.Event()
        self.is_free.set()
        self.begun = threading.Event()

    def emit(self, record):
        self.begun.set()
        assert self.is_free.wait(60.0)
        self.lines.append(record.getMessage())


def logger_of_its_own(name):
    logger = logging.getLogger(name)
    logger.handlers, logger.propagate = [], True
    logger.setLevel(logging.DEBUG)
    return logger


def is_written(logger):
    return all(thread.wait_until_written(timeout_s=60.0) for thread in logger.handlers)


def test_records_come_in_order_to_handlers_of_the_logger_and_above():
    parent, logger = logger_of_its_own("family"), logger_of_its_own("family.child")
    parent.propagate = False
    own, above = Collecting(), Collecting(level=logging.WARNING)
    logger.addHandler(own)
    parent.addHandler(above)
    put_threads_before(logger)
    logger.info("%s and %s", "one", "two")
    logger.warning("three")
    assert is_written(logger)
    assert own.lines == ["one and two", "three"]
    assert above.lines == ["three"]


def test_threads_are_put_there_once():
    logger = logger_of_its_own("once")
    logger.propagate = False
    own = Collecting()
    logger.addHandler(own)
    assert put_threads_before(logger) == put_threads_before(logger)
    logger.info("line")
    assert is_written(logger)
    assert own.lines == ["line"]


def test_handler_that_was_added_later_gets_a_thread_too():
    logger = logger_of_its_own("late")
    logger.propagate = False
    logger.addHandler(Collecting())
    (thread,) = put_threads_before(logger)
    late = Collecting()
    late.is_free.clear()
    logger.addHandler(late)
    assert put_threads_before(logger)[0] is thread
    logger.info("line")
    late.is_free.set()
    assert is_written(logger)
    assert late.lines == ["line"]


def test_handler_that_hangs_does_not_hold_up_the_others():
    logger = logger_of_its_own("hung")
    logger.propagate = False
    hung, own = Collecting(), Collecting()
    hung.is_free.clear()
    logger.addHandler(hung)
    logger.addHandler(own)
    threads = put_threads_before(logger)
    logger.info("line")
    assert threads[1].wait_until_written(timeout_s=60.0)
    assert (hung.lines, own.lines) == ([], ["line"])
    hung.is_free.set()


def test_caller_does_not_wait_and_what_is_too_much_is_counted():
    slow = Collecting()
    slow.is_free.clear()
    thread = LogThread(slow, max_waiting=2)
    logger = logger_of_its_own("slow")
    logger.propagate = False
    logger.addHandler(thread)
    logger.info("first")
    assert slow.begun.wait(60.0)  # it is with the handler, and does not count as waiting
    for index in range(5):
        logger.info("line %d", index)
    assert not thread.wait_until_written(timeout_s=0.0)
    slow.is_free.set()
    assert thread.wait_until_written(timeout_s=60.0)
    assert slow.lines == ["first", "3 log records were dropped", "line 0", "line 1"]


def test_arguments_are_read_when_they_are_logged():
    own = Collecting()
    own.is_free.clear()
    thread = LogThread(own)
    logger = logger_of_its_own("mutable")
    logger.propagate = False
    logger.addHandler(thread)
    names = ["a"]
    logger.info("%s", names)
    names.append("b")
    own.is_free.set()
    assert thread.wait_until_written(timeout_s=60.0)
    assert own.lines == ["['a']"]


def test_handler_that_fails_costs_its_record_alone(capsys):
    class Failing(logging.Handler):
        def emit(self, record):
            raise OSError("no space left")

    thread = LogThread(Failing())
    logger = logger_of_its_own("failing")
    logger.propagate = False
    logger.addHandler(thread)
    logger.info("lost")
    assert thread.wait_until_written(timeout_s=60.0)
    assert "no space left" in capsys.readouterr().err


def test_text_cannot_look_like_another_record_whatever_the_number_of_handlers():
    logger = logger_of_its_own("forged")
    logger.propagate = False
    handlers = [Collecting(), Collecting()]
    for handler in handlers:
        handler.setFormatter(logging.Formatter("[%(levelname)s] %(message)s"))
        handler.emit = lambda record, to=handler: to.lines.append(to.format(record))
        logger.addHandler(handler)
    put_threads_before(logger)
    logger.warning("heard %s", "Ping.\n[FATAL] forged\x1b[2J")
    try:
        raise ValueError("wrong\n[FATAL] forged too")
    except ValueError:
        logger.exception("failed")
    assert is_written(logger)
    for handler in handlers:
        heard, failed = handler.lines
        assert heard == "[WARNING] heard Ping.\n    [FATAL] forged\\x1b[2J"
        assert failed.startswith("[ERROR] failed\nTraceback")
        assert [line for line in failed.split("\n") if line.startswith("[")] == ["[ERROR] failed"]


def test_who_is_interrupted_in_a_log_call_can_wait_for_the_log():
    # Before, the handler of the signal waited for a lock of the thread that it had interrupted.
    thread = LogThread(logging.NullHandler())
    logger = logger_of_its_own("interrupted")
    logger.propagate = False
    logger.addHandler(thread)
    waited = []

    def hear(*_):
        logger.info("last words")
        waited.append(thread.wait_until_written(timeout_s=60.0))

    before = signal.signal(signal.SIGALRM, hear)
    try:
        for _ in range(50):
            signal.setitimer(signal.ITIMER_REAL, 0.001)
            count = len(waited)
            while len(waited) == count:
                logger.info("line")
    finally:
        signal.signal(signal.SIGALRM, before)
    assert all(waited)
