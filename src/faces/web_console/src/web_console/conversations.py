"""What was said to the robot and what came of it, with a person's verdict, in a SQLite file; and files made of it."""

import json
import sqlite3
from dataclasses import asdict, dataclass, replace
from typing import Any, Dict, List, Sequence, Tuple

import yaml

from roboframenet_ros.sqlite_file import SqliteFile

#: Written into the file; another number is a file of another program or version.
SCHEMA = 1
#: How many conversations are kept; the oldest are forgotten.
MOST_KEPT = 10000
RIGHT, WRONG = "right", "wrong"
#: Of a frame: its name, and its elements with their arguments.
Frame = Tuple[str, Tuple[Tuple[str, str], ...]]
#: Replies to what was not understood, or was not to be done: a test of the sentence names the code.
_WITHOUT_FRAMES = frozenset(("REFUSED", "NEEDS_INFORMATION"))

_TEST_HEADER = """# Sentences that persons said to a robot, and their verdict: 'rfn test' reads each of them.
# "frames" and "code" are what was right; "means" is another sentence that has to be read in the same way.
"""


@dataclass(frozen=True)
class Conversation:
    """A sentence and its reply.

    Attributes:
        id: of the command
        stamp_s: when it was said, seconds since 1970
        text: the sentence
        frames: the best reading of each clause
        outcome: of the reply, "DONE"
        code: of the reply
        sentence: of the reply
        verdict: of a person: right, wrong, or nothing
        meant: in other words, when it was wrong
    """

    id: str
    stamp_s: float
    text: str
    frames: Tuple[Frame, ...]
    outcome: str
    code: str
    sentence: str
    verdict: str = ""
    meant: str = ""


def _create(connection: sqlite3.Connection) -> None:
    connection.execute(
        "CREATE TABLE IF NOT EXISTS said (id TEXT PRIMARY KEY, stamp_s REAL NOT NULL, words TEXT NOT NULL, "
        "entry TEXT NOT NULL)"
    )
    connection.execute("CREATE INDEX IF NOT EXISTS by_stamp ON said (stamp_s)")


class ConversationFile:
    """The file. One thread at a time uses it.

    Attributes:
        problems: what was wrong with the file when it was opened; it was set aside
    """

    def __init__(self, path: str, *, most: int = MOST_KEPT) -> None:
        """Open the file, or make a new one. A file that cannot be read is renamed, and a new one takes its place.

        Args:
            path: of the file; ":memory:" keeps nothing
            most: how many conversations are kept
        Raises:
            StoreError: no file can be made there
        """
        self._file = SqliteFile(path, schema=SCHEMA, create=_create, is_every_change_synced=False)
        self._most = most
        self.problems = self._file.problems

    def keep(self, conversation: Conversation) -> None:
        """Add a conversation, or replace it.

        Raises:
            StoreError: it was not stored
        """
        texts = (conversation.text, conversation.sentence, conversation.meant, conversation.id)
        words = "\n".join(texts).lower()
        row = (conversation.id, conversation.stamp_s, words, json.dumps(asdict(conversation)))
        with self._file.change() as connection:
            connection.execute("INSERT OR REPLACE INTO said VALUES (?, ?, ?, ?)", row)
            connection.execute(
                "DELETE FROM said WHERE stamp_s < (SELECT stamp_s FROM said ORDER BY stamp_s DESC LIMIT 1 OFFSET ?)",
                (self._most - 1,),
            )

    def judge(self, command_id: str, verdict: str, meant: str) -> bool:
        """Keep the verdict of a person; returns whether there is such a conversation.

        Raises:
            StoreError: it was not stored
        """
        with self._file.reading() as connection:
            rows = connection.execute("SELECT entry FROM said WHERE id = ?", (command_id,)).fetchall()
        found = _conversations(rows)
        for conversation in found:
            self.keep(replace(conversation, verdict=verdict, meant=meant))
        return bool(found)

    def find(self, words: str = "", *, before_s: float = 0.0, most: int = MOST_KEPT) -> Tuple[Conversation, ...]:
        """Return the conversations in which all of some words stand, the newest first.

        Args:
            words: parts of words, or "right" and "wrong" with a colon before them: what has this verdict
            before_s: only what was said earlier; 0 for all
            most: how many
        Raises:
            StoreError: the file cannot be read
        """
        query = "SELECT entry FROM said WHERE (? <= 0 OR stamp_s < ?)"
        values: List[Any] = [before_s, before_s]
        for word in words.lower().split():
            is_verdict = word in (f":{RIGHT}", f":{WRONG}")
            query += f" AND instr({'entry' if is_verdict else 'words'}, ?)"
            values.append(f'"verdict": "{word[1:]}"' if is_verdict else word)
        with self._file.reading() as connection:
            rows = connection.execute(f"{query} ORDER BY stamp_s DESC LIMIT ?", (*values, most)).fetchall()
        return _conversations(rows)

    def close(self) -> None:
        """Close the file."""
        self._file.close()


def _conversations(rows: Sequence[Tuple[str]]) -> Tuple[Conversation, ...]:
    """Read rows; what another program wrote is left out."""
    found: List[Conversation] = []
    for (text,) in rows:
        try:
            entry: Dict[str, Any] = json.loads(text)
            frames = tuple(
                (str(name), tuple((str(one), str(said)) for one, said in pairs)) for name, pairs in entry["frames"]
            )
            found.append(Conversation(**{**entry, "frames": frames}))
        except (ValueError, TypeError, KeyError):
            continue
    return tuple(found)


def as_list(found: Sequence[Conversation], *, most: int) -> str:
    """Return conversations for a page, as JSON: at most so many, and whether there are more."""
    shown = [
        {**asdict(one), "frames": None, "teaching": one.meant and teaching(one.text, one.meant)} for one in found[:most]
    ]
    return json.dumps({"said": shown, "more": len(found) > most})


def as_records(found: Sequence[Conversation]) -> str:
    """Return conversations as ``rfn record`` writes them, the oldest first: for ``rfn replay`` and ``rfn unknown``."""
    lines: List[str] = []
    for one in reversed(found):
        frames = [
            {"name": name, "frame_elements": [{"name": element, "argument": words} for element, words in said]}
            for name, said in one.frames
        ]
        reply = {"outcome": one.outcome, "code": one.code, "sentence": one.sentence}
        lines.append(json.dumps({"text": one.text, "frames": frames, "reply": reply}, ensure_ascii=False) + "\n")
    return "".join(lines)


def as_sentences(found: Sequence[Conversation]) -> str:
    """Return a file for ``rfn test`` of all that has a verdict; the newest verdict about a sentence counts."""
    entries: List[str] = []
    told = set()
    for one in found:
        key = " ".join(one.text.lower().split())
        if not one.verdict or key in told:
            continue
        told.add(key)
        entry: Dict[str, Any] = {"text": one.text}
        if one.verdict == WRONG and one.meant:
            entry["means"] = one.meant
        elif one.verdict == RIGHT and one.frames and one.outcome not in _WITHOUT_FRAMES:
            entry["frames"] = [{name: dict(said)} for name, said in one.frames]
        elif one.verdict == RIGHT and one.outcome in _WITHOUT_FRAMES:
            entry["code"] = one.code
        if len(entry) == 1:
            entries.append(f"# {one.verdict}, and nobody has said what is right: {json.dumps(one.text)}\n")
            continue
        remark = f"{one.verdict}; the reply was [{one.code}] {one.sentence}"
        lines = yaml.safe_dump([entry], sort_keys=False, allow_unicode=True, width=1000)
        entries.append(f"# {' '.join(remark.split())}\n{lines}")
    return _TEST_HEADER + "".join(entries)


def teaching(text: str, meant: str) -> str:
    """Return the sentence that teaches the robot what some words mean."""
    said = text.strip(" .!?,;")
    act = meant.strip(" .!?,;")
    return f"When I say {said[:1].lower()}{said[1:]}, {act[:1].lower()}{act[1:]}."


def as_teaching(found: Sequence[Conversation]) -> str:
    """Return the sentences that teach what was meant, each once, for a person to say to a robot."""
    lines = [teaching(one.text, one.meant) for one in found if one.verdict == WRONG and one.meant]
    return "".join(f"{line}\n" for line in dict.fromkeys(lines))
