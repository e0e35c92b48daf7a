"""Parameters of the node."""

import enum
from dataclasses import dataclass
from typing import Dict, Mapping, Tuple

from roboframenet_ros.parameters import Parameters, parameter
from voice_recognition.dialogue import Confirm, DialogueSettings
from voice_recognition.engines import Engine


class Listening(enum.Enum):
    """When the node listens for commands; for a stop it always listens."""

    PUSH = "push"  # after a push to talk, and for answers
    ALWAYS = "always"


@dataclass(frozen=True)
class Settings(Parameters):
    """Private parameters, checked.

    Attributes:
        engine: the recogniser: ``whisper``, ``pocketsphinx``, or ``auto`` for Whisper where it is installed
        microphone: program that writes sound (16 kHz, 16 bit, mono) and its arguments; empty for arecord
        device: of ALSA, for arecord; empty for the default one
        audio_topic: of audio_common, whose sound is heard in place of a microphone; empty for none
        listening: ``push`` (only after a push to talk, and for answers) or ``always``
        wake_words: names by which the robot is called; while it listens always, a command begins with one
        confirm: when the robot asks before it does what it heard
        confirm_always, confirm_never: frames for which that is different
        aloud: make sound with Piper or espeak-ng, if one is installed
        speak_replies: say the reply to each command
        voice_id: name of this microphone among the voices of REP 155
        listen_s: how long it listens after a push
        answer_s: how long it waits for an answer

    Raises:
        ParameterError: a value of another type, out of its range, or not among the choices
    """

    engine: Engine = parameter(Engine.AUTO)
    microphone: Tuple[str, ...] = parameter(())
    device: str = parameter("")
    audio_topic: str = parameter("")
    listening: Listening = parameter(Listening.PUSH, is_live=True)
    wake_words: Tuple[str, ...] = parameter(("robot",))
    confirm: Confirm = parameter(Confirm.MOTION, is_live=True)
    confirm_always: Tuple[str, ...] = parameter(())
    confirm_never: Tuple[str, ...] = parameter(())
    aloud: bool = parameter(True)
    speak_replies: bool = parameter(True, is_live=True)
    voice_id: str = parameter("robot_microphone", may_be_empty=False)
    listen_s: float = parameter(8.0, least=1.0, most=600.0, is_live=True)
    answer_s: float = parameter(10.0, least=1.0, most=600.0, is_live=True)

    @property
    def dialogue(self) -> DialogueSettings:
        """How the robot talks about what it heard."""
        frames: Dict[str, Confirm] = dict.fromkeys(self.confirm_never, Confirm.NEVER)
        frames.update(dict.fromkeys(self.confirm_always, Confirm.ALWAYS))
        chosen: Mapping[str, Confirm] = frames
        return DialogueSettings(
            confirm=self.confirm,
            confirm_frames=chosen,
            always_listening=self.listening is Listening.ALWAYS,
            listen_s=self.listen_s,
            answer_s=self.answer_s,
        )
