"""Which recogniser hears: Whisper where it runs, otherwise pocketsphinx."""

import enum
from typing import Tuple

from voice_recognition.speech_detection import detector_file
from voice_recognition.whisper_model import NoWhisper, model_folder


class Engine(enum.Enum):
    """The recogniser that is wished for."""

    AUTO = "auto"  # Whisper, if it is installed
    WHISPER = "whisper"
    POCKETSPHINX = "pocketsphinx"


def chosen(wished: Engine) -> Tuple[Engine, str]:
    """Return the engine that hears, and why it is not the better one; empty if it is the one that was wished for."""
    if wished is Engine.POCKETSPHINX:
        return wished, ""
    try:
        model_folder()
        detector_file()
    except NoWhisper as reason:
        return Engine.POCKETSPHINX, str(reason)
    return Engine.WHISPER, ""
