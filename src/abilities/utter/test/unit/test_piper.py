"""Piper speaks as a program of its own; without it, or when it fails, espeak-ng does."""

import sys
import wave
from pathlib import Path

import pytest

from utter import piper
from utter.piper import NoPiper, Piper, installed_voice, piper_command

#: Writes a file for each line, as Piper does; ends at a line "end", and is silent at "hang".
PROGRAM = """
import pathlib, sys
folder = pathlib.Path(sys.argv[sys.argv.index("-d") + 1])
for number, line in enumerate(sys.stdin):
    if line == "end\\n":
        sys.exit(1)
    if line != "hang\\n":
        path = folder / f"{number}.wav"
        path.write_text(line)
        print(f"INFO:__main__:Wrote {path}", file=sys.stderr, flush=True)
"""


@pytest.fixture(name="program")
def _program():
    program = Piper([sys.executable, "-c", PROGRAM])
    yield program
    program.close()


def said(path: str) -> str:
    return Path(path).read_text() if path else ""


def test_each_text_has_its_sound(program: Piper) -> None:
    assert said(program.wave_of("Hello.")) == "Hello.\n"
    assert said(program.wave_of("Two\nlines, in one.")) == "Two lines, in one.\n"
    assert program.wave_of(" ") == ""


def test_a_program_that_ends_is_started_anew_after_a_while(program: Piper, monkeypatch: pytest.MonkeyPatch) -> None:
    assert program.wave_of("end") == ""
    assert program.wave_of("Hello.") == ""
    monkeypatch.setattr(piper, "RETRY_S", 0.0)
    other = Piper([sys.executable, "-c", PROGRAM])
    assert other.wave_of("end") == "" and said(other.wave_of("Hello.")) == "Hello.\n"
    other.close()


def test_a_program_that_does_not_answer_is_ended(program: Piper, monkeypatch: pytest.MonkeyPatch) -> None:
    assert said(program.wave_of("Hello.")) == "Hello.\n"
    monkeypatch.setattr(piper, "ANSWER_S", 0.2)
    assert program.wave_of("hang") == ""
    assert Piper(["/no/such/program"]).wave_of("Hello.") == ""


def test_another_voice_is_refused(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    monkeypatch.setattr(piper, "piper_folder", lambda: tmp_path)
    with pytest.raises(NoPiper, match="make piper"):
        installed_voice()
    path = tmp_path / piper.VOICE_FILE
    path.parent.mkdir(parents=True)
    path.write_bytes(b"another one")
    with pytest.raises(NoPiper, match="not the voice"):
        installed_voice()


def _is_installed() -> bool:
    try:
        installed_voice()
    except NoPiper:
        return False
    return True


@pytest.mark.skipif(not _is_installed(), reason="Piper is not installed: make piper")
def test_piper_speaks() -> None:
    speaking = Piper(*piper_command(installed_voice()))
    try:
        with wave.open(speaking.wave_of("Shall I go to the kitchen?"), "rb") as file:
            assert 0.5 < file.getnframes() / file.getframerate() < 5.0
    finally:
        speaking.close()
