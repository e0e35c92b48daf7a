"""Sounds of words."""

import shutil

import pytest

from voice_recognition.pronunciation import pronounce, read_dictionary, sounds_by_espeak, to_arpabet

KNOWN = {"robot": ("R OW B AA T",), "bob": ("B AA B",), "u": ("Y UW",), "turn": ("T ER N",), "boss": ("B AO S",)}
#: The sounds of the acoustic model.
ARPABET = set(
    "AA AE AH AO AW AY B CH D DH EH ER EY F G HH IH IY JH K L M N NG OW OY P R S SH T TH UH UW V W Y Z ZH".split()
)


def test_the_dictionary_counts_first_and_the_guess_last() -> None:
    found, unknown = pronounce(["robot", "moobot", "zzz"], KNOWN, {"moobot": "M UW B AA T", "zzz": ""}.__getitem__)
    assert found == {"robot": ("R OW B AA T",), "moobot": ("M UW B AA T",)}
    assert unknown == {"zzz"}


def test_parts_of_a_word_and_genitives_are_known() -> None:
    found, unknown = pronounce(["u-turn", "bob's", "boss's"], KNOWN, lambda word: "")
    assert not unknown
    assert found == {"u-turn": ("Y UW T ER N",), "bob's": ("B AA B Z",), "boss's": ("B AO S IH Z",)}


def test_mnemonics_become_arpabet() -> None:
    assert to_arpabet("m 'u: b 0 t") == "M UW B AA T"
    assert to_arpabet("'aI@ n") == "AY ER N"
    assert to_arpabet("m ¤") == ""


def test_further_ways_of_a_word_are_read(tmp_path) -> None:
    path = tmp_path / "words.dict"
    path.write_text("the DH AH\nthe(2) DH IY\nto T UW\n", encoding="utf-8")
    assert read_dictionary(str(path)) == {"the": ("DH AH", "DH IY"), "to": ("T UW",)}


@pytest.mark.skipif(not shutil.which("espeak-ng"), reason="espeak-ng is not installed")
@pytest.mark.parametrize("word", "worktop huric séverin thirteen kobuki yellowish church judge vision weather".split())
def test_espeak_ng_says_words_in_sounds_of_the_model(word: str) -> None:
    sounds = sounds_by_espeak(word).split()
    assert sounds and set(sounds) <= ARPABET
