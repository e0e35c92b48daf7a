"""Reads files that come again and again in a latched message, each once."""

from typing import Callable, Dict, Generic, Iterable, List, Tuple, TypeVar, Union

from checked_files.problem import FileRefused

Content = TypeVar("Content")


class ReadOnce(Generic[Content]):
    """The contents of the files of the last message.

    A file that is added or changed is read; the others are known, and so are those that were refused. A thousand files
    that are added one by one are a thousand readings, not half a million.
    """

    def __init__(self, load: Callable[[str, str], Content]) -> None:
        """
        Args:
            load: returns what a text and a path hold; raises FileRefused
        """
        self._load = load
        self._known: Dict[Tuple[str, str], Union[Content, FileRefused]] = {}

    def contents(self, files: Iterable[Tuple[str, str]]) -> Tuple[List[Content], List[FileRefused]]:
        """Return what the files hold, in their order; and why files that are new were refused.

        Args:
            files: path and text of each; files that are not among them are forgotten
        """
        known: Dict[Tuple[str, str], Union[Content, FileRefused]] = {}
        refused = []
        for path, text in files:
            if (path, text) in self._known:
                known[path, text] = self._known[path, text]
                continue
            try:
                known[path, text] = self._load(text, path)
            except FileRefused as reason:
                known[path, text] = reason
                refused.append(reason)
        self._known = known
        return [content for content in known.values() if not isinstance(content, FileRefused)], refused
