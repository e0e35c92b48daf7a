"""The past conversations of a page: a thread keeps and finds them, so that nothing else waits for the disk."""

from concurrent.futures import Future, ThreadPoolExecutor
from typing import Callable, Optional

from roboframenet_ros.sqlite_file import StoreError
from web_console.conversations import Conversation, ConversationFile, as_list, as_records, as_sentences, as_teaching

#: Files that a browser may ask for: what they are made of.
FILES = {"sentences.yaml": as_sentences, "teaching.txt": as_teaching, "said.jsonl": as_records}
#: The list that the page shows.
LIST = "past.json"
_MOST_SHOWN = 30


class Past:
    """The file of the past conversations, and its thread. Every method returns at once."""

    def __init__(self, path: str, *, on_problem: Callable[[str], None]) -> None:
        """Open the file; without one, conversations are kept as long as this object is there.

        Args:
            path: of the file
            on_problem: called with a sentence when the file is of no use; from any thread
        """
        self._on_problem = on_problem
        self._thread = ThreadPoolExecutor(max_workers=1, thread_name_prefix="conversations")
        self._file: Optional[ConversationFile] = None
        self._thread.submit(self._open, path)

    def _open(self, path: str) -> None:
        try:
            self._file = ConversationFile(path)
        except StoreError as error:
            self._on_problem(str(error))
            self._file = ConversationFile(":memory:")
        for problem in self._file.problems:
            self._on_problem(problem)

    def keep(self, conversation: Conversation) -> None:
        """Keep a conversation."""
        self._thread.submit(self._change, lambda file: file.keep(conversation))

    def judge(self, command_id: str, verdict: str, meant: str) -> None:
        """Keep a person's verdict of a conversation."""
        self._thread.submit(self._change, lambda file: file.judge(command_id, verdict, meant))

    def _change(self, change: Callable[[ConversationFile], object]) -> None:
        assert self._file is not None
        try:
            change(self._file)
        except StoreError as error:
            self._on_problem(str(error))

    def text(self, name: str, words: str, before_s: float) -> "Future[str]":
        """Return what a browser asked for, once it has been found.

        Args:
            name: of the list or of a file
            words: what has to stand in it
            before_s: only what was said earlier; 0 for all
        """
        return self._thread.submit(self._find, name, words, before_s)

    def _find(self, name: str, words: str, before_s: float) -> str:
        assert self._file is not None
        if name == LIST:
            return as_list(self._file.find(words, before_s=before_s, most=_MOST_SHOWN + 1), most=_MOST_SHOWN)
        return FILES[name](self._file.find(words))

    def close(self) -> None:
        """End the thread, when it has kept what it was given."""
        self._thread.submit(self._close)
        self._thread.shutdown(wait=False)

    def _close(self) -> None:
        if self._file is not None:
            self._file.close()
