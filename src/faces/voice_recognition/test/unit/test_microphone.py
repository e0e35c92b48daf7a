"""Where sound comes from, and what is said when none comes."""

import struct
import sys

import pytest

from voice_recognition.microphone import (
    AUDIO_TYPE,
    OTHER_RATE,
    PAGE_TYPE,
    PART_BYTES,
    Microphone,
    NoSound,
    in_parts,
    sound_of_message,
)


def program(text: str) -> Microphone:
    return Microphone([sys.executable, "-c", f"import sys\n{text}"])


def test_a_program_is_heard_until_it_ends() -> None:
    microphone = program(f"sys.stdout.buffer.write(bytes({3 * PART_BYTES + 5}))")
    assert [len(part) for part in microphone.parts()] == [PART_BYTES] * 3
    assert microphone.complaint == ""
    microphone.close()


def test_a_program_says_what_is_wrong() -> None:
    microphone = program(
        "print('ALSA lib\\naudio open error: Device or resource busy\\n', file=sys.stderr); sys.exit(1)"
    )
    assert list(microphone.parts()) == []
    assert microphone.complaint == "audio open error: Device or resource busy"
    microphone.close()
    with pytest.raises(OSError):
        Microphone(["/no/such/program"])


def test_another_rate_is_told_whatever_else_is_said() -> None:
    warning = f"Warning: {OTHER_RATE} (requested = 16000Hz, got = 44100Hz)"
    microphone = program(f"print({warning!r}, file=sys.stderr); print('please, try the plug plugin', file=sys.stderr)")
    assert list(microphone.parts()) == []
    assert microphone.complaint == warning
    microphone.close()


def test_messages_of_any_length_are_parts() -> None:
    sound = bytes(range(256)) * 20
    found = b"".join(in_parts([sound[:7], b"", sound[7:]]))
    assert len(found) == len(sound) // PART_BYTES * PART_BYTES and sound.startswith(found)


def test_only_a_message_with_sound_is_heard() -> None:
    assert sound_of_message(AUDIO_TYPE, struct.pack("<I", 3) + b"abc") == b"abc"
    assert sound_of_message(PAGE_TYPE, struct.pack("<III", 0, 0, 3) + b"abc") == b"abc"
    for kind, content in (
        ("std_msgs/String", struct.pack("<I", 3) + b"abc"),
        (AUDIO_TYPE, struct.pack("<I", 4) + b"abc"),
        (AUDIO_TYPE, b"a"),
        (PAGE_TYPE, struct.pack("<I", 3) + b"abc"),
    ):
        with pytest.raises(NoSound):
            sound_of_message(kind, content)
