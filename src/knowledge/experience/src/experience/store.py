"""Keeps what was tried, and the rules, in a bounded SQLite file."""

import json
import sqlite3
from dataclasses import asdict
from typing import Any, Dict, Iterable, List, Sequence, Tuple

from experience.rules import Rule, RuleKind
from experience.trial import Circumstances, Judgement, Outcome, Trial
from roboframenet_ros.sqlite_file import SqliteFile

#: Written into the file; another number is a file of another program or version.
SCHEMA = 1
#: Rules are few; so many are an error of somebody.
MOST_RULES = 200
_COLUMNS = (
    "command_id, said, began_s, frame, server, sequence, kinds, referents, place, robot, took_s, outcome, reason,"
    " judgement"
)


def _create(connection: sqlite3.Connection) -> None:
    connection.execute(
        "CREATE TABLE IF NOT EXISTS trials (number INTEGER PRIMARY KEY AUTOINCREMENT, command_id TEXT NOT NULL,"
        " said TEXT NOT NULL, began_s REAL NOT NULL, frame TEXT NOT NULL, server TEXT NOT NULL, sequence TEXT NOT NULL,"
        " kinds TEXT NOT NULL, referents TEXT NOT NULL, place TEXT NOT NULL, robot TEXT NOT NULL, took_s REAL NOT NULL,"
        " outcome INTEGER NOT NULL, reason TEXT NOT NULL, judgement INTEGER NOT NULL)"
    )
    connection.execute("CREATE INDEX IF NOT EXISTS of_command ON trials (command_id)")
    connection.execute("CREATE TABLE IF NOT EXISTS rules (id TEXT PRIMARY KEY, entry TEXT NOT NULL)")


class Store:
    """The file. One thread at a time uses it.

    Trials are not synced one by one: a power cut may lose the last ones, which no person was promised; a killed process
    loses nothing that was written, and in both cases the file stays whole.

    Attributes:
        problems: what was wrong with the file when it was opened, and entries that were left out
    """

    def __init__(self, path: str, *, most_trials: int = 10_000) -> None:
        """Open the file, or make a new one. A file that cannot be read is renamed, and a new one takes its place.

        Args:
            path: of the file; ":memory:" keeps nothing
            most_trials: the oldest trials above this number are deleted
        Raises:
            StoreError: no file can be made there
        """
        self._file = SqliteFile(path, schema=SCHEMA, create=_create, is_every_change_synced=False)
        self._most_trials = most_trials
        self.problems = self._file.problems

    def trials(self) -> Tuple[Trial, ...]:
        """Return the trials, oldest first; one that cannot be read is left out and becomes a problem.

        Raises:
            StoreError: the file cannot be read
        """
        with self._file.reading() as connection:
            rows = connection.execute(f"SELECT number, {_COLUMNS} FROM trials ORDER BY number").fetchall()
        found: List[Trial] = []
        for number, *row in rows:
            try:
                found.append(trial_from_row(row))
            except (ValueError, TypeError) as error:
                self.problems += (f"{self._file.path}: trial {number} is left out: {error}",)
        return tuple(found)

    def rules(self) -> Tuple[Rule, ...]:
        """Return the rules, oldest first; one that cannot be read is left out and becomes a problem.

        Raises:
            StoreError: the file cannot be read
        """
        with self._file.reading() as connection:
            rows = connection.execute("SELECT id, entry FROM rules").fetchall()
        found: List[Rule] = []
        for name, entry in rows:
            try:
                found.append(rule_from_text(entry))
            except (ValueError, TypeError, KeyError) as error:
                self.problems += (f"{self._file.path}: the rule {name!r} is left out: {error}",)
        return tuple(sorted(found, key=lambda rule: rule.stamp_s))

    def add(self, trials: Iterable[Trial]) -> None:
        """Store trials, and delete the oldest ones above the limit.

        Raises:
            StoreError: they were not stored
        """
        rows = [row_of(trial) for trial in trials]
        with self._file.change() as connection:
            connection.executemany(f"INSERT INTO trials ({_COLUMNS}) VALUES ({','.join('?' * 14)})", rows)
            connection.execute(
                "DELETE FROM trials WHERE number <= (SELECT max(number) FROM trials) - ?", (self._most_trials,)
            )

    def judge(self, command_id: str, judgement: Judgement) -> None:
        """Store what a person said of a command: of what succeeded in it.

        Raises:
            StoreError: it was not stored
        """
        with self._file.change() as connection:
            connection.execute(
                "UPDATE trials SET judgement = ? WHERE command_id = ? AND outcome = ?",
                (int(judgement), command_id, int(Outcome.SUCCEEDED)),
            )

    def write_rules(self, kept: Sequence[Rule], dropped: Iterable[str] = ()) -> None:
        """Store rules, and delete others by their ids.

        Raises:
            StoreError: they were not stored
        """
        with self._file.change() as connection:
            connection.executemany(
                "INSERT OR REPLACE INTO rules VALUES (?, ?)", [(rule.rule_id, rule_to_text(rule)) for rule in kept]
            )
            connection.executemany("DELETE FROM rules WHERE id = ?", [(name,) for name in dropped])

    def delete_everything(self) -> None:
        """Delete all trials and all rules, also from the free pages and the journal of the file.

        Raises:
            StoreError: it was not done
        """
        with self._file.change() as connection:
            connection.execute("DELETE FROM trials")
            connection.execute("DELETE FROM rules")
        with self._file.reading() as connection:
            connection.execute("VACUUM")
            connection.execute("PRAGMA wal_checkpoint(TRUNCATE)").fetchall()

    def close(self) -> None:
        """Close the file."""
        self._file.close()


def row_of(trial: Trial) -> Tuple[object, ...]:
    """Return a trial as a row."""
    about = trial.circumstances
    return (
        trial.command_id,
        trial.said,
        trial.began_s,
        trial.frame,
        trial.server,
        trial.sequence,
        about.kinds,
        about.referents,
        about.place,
        about.robot,
        trial.took_s,
        int(trial.outcome),
        trial.reason,
        int(trial.judgement),
    )


def trial_from_row(row: Sequence[Any]) -> Trial:
    """Read a row.

    Raises:
        ValueError, TypeError: it is malformed
    """
    command_id, said, began_s, frame, server, sequence, kinds, referents, place, robot, took_s, *end = row
    outcome, reason, judgement = end
    texts = (command_id, said, frame, server, sequence, kinds, referents, place, robot, reason)
    if not all(isinstance(text, str) for text in texts) or not frame or not server:
        raise ValueError("it lacks a text")
    return Trial(
        command_id,
        said,
        float(began_s),
        frame,
        server,
        sequence,
        Circumstances(kinds, referents, place, robot),
        max(0.0, float(took_s)),
        Outcome(outcome),
        reason,
        Judgement(judgement),
    )


def rule_to_text(rule: Rule) -> str:
    """Return a rule as JSON."""
    return json.dumps({**asdict(rule), "kind": int(rule.kind)})


def rule_from_text(text: str) -> Rule:
    """Read a rule.

    Raises:
        ValueError, TypeError, KeyError: it is malformed
    """
    entry: Dict[str, Any] = json.loads(text)
    rule = Rule(**{**entry, "kind": RuleKind(entry["kind"])})
    if not rule.rule_id or not rule.server:
        raise ValueError("it names no server")
    return rule
