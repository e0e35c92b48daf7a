"""Files that several threads add at once: what is announced last is what there is."""

import threading
from pathlib import Path
from typing import List

import pytest

from semantic_framer.units import lexicon_files
from semantic_framer.units.lexicon import Lexicon
from semantic_framer.units.lexicon_files import LexiconFiles, LexiconState
from semantic_frames.lexical_unit import LexicalUnit

#: So long the first addition gives the second one to overtake it; it never has to wait when it can be overtaken.
OVERTAKING_S = 0.3


def write(folder: Path, name: str, text: str) -> str:
    path = folder / name
    path.write_text(text, encoding="utf-8")
    return str(path)


def test_addition_that_is_overtaken_does_not_announce_an_old_state_last(tmp_path: Path) -> None:
    turn = write(tmp_path, "turn.yaml", "frame_name: turning\nverb: turn\n")
    move = write(tmp_path, "move.yaml", "frame_name: moving\nverb: move\n")
    announced: List[LexiconState] = []
    overtaken = threading.Event()
    others: List[threading.Thread] = []

    def announce(state: LexiconState) -> None:
        if not others:
            others.append(threading.Thread(target=lambda: files.add([move])))
            others[0].start()
            overtaken.wait(OVERTAKING_S)
        announced.append(state)
        overtaken.set()

    files = LexiconFiles(Lexicon(), threading.Lock(), announce)
    files.add([turn])
    others[0].join(10.0)
    assert [sorted(state.files) for state in announced] == [[turn], sorted([turn, move])]


def test_lexicon_is_free_while_its_state_is_announced(tmp_path: Path) -> None:
    path = write(tmp_path, "turn.yaml", "frame_name: turning\nverb: turn\n")
    lock = threading.Lock()
    is_free: List[bool] = []

    def announce(state: LexiconState) -> None:
        is_free.append(lock.acquire(blocking=False))
        lock.release()

    LexiconFiles(Lexicon(), lock, announce).add([path])
    assert is_free == [True]


def test_refused_file_is_told_of_until_it_is_mended(tmp_path: Path) -> None:
    wrong = write(tmp_path, "wrong.yaml", "frame_name: turning\n")
    right = write(tmp_path, "right.yaml", "frame_name: turning\nverb: turn\n")
    states: List[LexiconState] = []
    files = LexiconFiles(Lexicon(), threading.Lock(), states.append)
    files.add([wrong, right])
    assert states[0].accepted == (right,) and {problem.path for problem in states[0].refused} == {wrong}
    write(tmp_path, "wrong.yaml", "frame_name: turning\nverb: spin\n")
    files.add([right])
    files.add([wrong])
    assert [bool(state.problems) for state in states] == [True, True, False]
    assert [bool(state.refused) for state in states] == [True, False, False]


def test_lexicon_of_units_knows_their_verbs() -> None:
    unit = LexicalUnit(frame_name="taking", verbs=("pick up", "take"))
    lexicon = Lexicon.of_units([unit])
    assert lexicon.units_of("take") == (unit,) and lexicon.verbs_beginning_with("pick") == ("pick up",)
    assert lexicon.files == {}


def test_files_are_limited(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(lexicon_files, "MOST_FILES", 1)
    first = write(tmp_path, "first.yaml", "frame_name: turning\nverb: turn\n")
    second = write(tmp_path, "second.yaml", "frame_name: moving\nverb: move\n")
    files = LexiconFiles(Lexicon(), threading.Lock(), lambda state: None)
    state = files.add([first, second, first])
    assert [(problem.code, problem.path) for problem in state.refused] == [("TOO_MANY", second)]
    assert list(state.files) == [first]
