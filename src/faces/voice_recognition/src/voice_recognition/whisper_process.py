"""The process that Whisper runs in: it hears what comes on its standard input, and writes what it heard on its output.

A request is a line of JSON, and behind it so many bytes of sound as the line says. The answer is a line of JSON. The
process ends with its input.
"""

import json
import os
import sys
from collections import deque
from typing import Any, BinaryIO, Deque, Dict, Tuple

from voice_recognition.speech_detection import SpeechDetector
from voice_recognition.whisper_model import Encoded, NoWhisper, Sentence, Transcript, WhisperModel, shared_model

#: The least probability of speech in some part of a sound that is listened to.
LEAST_SPEECH = 0.5
#: Sounds that are remembered.
MOST_SOUNDS = 4


class Hearing:
    """Answers requests; remembers the last sounds, in which texts can be scored."""

    def __init__(self, model: WhisperModel, detector: SpeechDetector) -> None:
        """
        Args:
            model: hears
            detector: tells whether somebody speaks at all
        """
        self._model = model
        self._detector = detector
        self._sounds: Deque[Tuple[int, Encoded]] = deque(maxlen=MOST_SOUNDS)
        self._count = 0

    def answer(self, request: Dict[str, Any], pcm: bytes) -> Dict[str, Any]:
        """Return the answer to a request.

        Args:
            request: `hear` with a prompt, for what is said; or `score` with texts, and the number of a `sound`
            pcm: the sound of `hear`
        """
        if "score" in request:
            sound = dict(self._sounds).get(int(request["sound"]))
            scored = self._model.score(sound, request["score"]) if sound is not None else ()
            return {"sentences": [_as_data(one) for one in scored]}
        speech = self._detector.most_speech(pcm)
        if speech < LEAST_SPEECH:
            return {"sentences": [], "no_speech": 1.0 - speech}
        heard, encoded = self._model.hear(pcm, str(request.get("prompt", "")))
        self._count += 1
        self._sounds.append((self._count, encoded))
        sentences = [_as_data(one) for one in heard.sentences]
        return {"sentences": sentences, "no_speech": heard.no_speech, "sound": self._count}


def _as_data(sentence: Sentence) -> Dict[str, Any]:
    return {"text": sentence.text, "log_probability": sentence.log_probability, "tokens": sentence.tokens}


def transcript_of(answer: Dict[str, Any]) -> Transcript:
    """Return what an answer says."""
    sentences = tuple(Sentence(**one) for one in answer["sentences"])
    return Transcript(sentences, float(answer.get("no_speech", 0.0)), int(answer.get("sound", 0)))


def serve(source: BinaryIO, target: BinaryIO) -> int:
    """Answer requests until they end; return the exit status."""

    def write(answer: Dict[str, Any]) -> None:
        target.write(json.dumps(answer).encode() + b"\n")
        target.flush()

    try:
        hearing = Hearing(shared_model(), SpeechDetector())
    except NoWhisper as reason:
        write({"error": str(reason)})
        return 1
    write({"ready": True})
    for line in iter(source.readline, b""):
        request: Dict[str, Any] = json.loads(line)
        write(hearing.answer(request, source.read(int(request.get("bytes", 0)))))
    return 0


def main() -> int:
    """Run the process: whatever a library prints does not get between the answers."""
    answers = os.fdopen(os.dup(sys.stdout.fileno()), "wb")
    os.dup2(sys.stderr.fileno(), sys.stdout.fileno())
    return serve(sys.stdin.buffer, answers)


if __name__ == "__main__":
    sys.exit(main())
