"""Whisper in a process of its own: started in the background, and anew when it ends or does not answer."""

import contextlib
import json
import queue
import subprocess
import sys
import threading
import time
from pathlib import Path
from typing import Any, Dict, Optional, Sequence, Tuple

from voice_recognition.whisper_model import Sentence, Transcript
from voice_recognition.whisper_process import transcript_of

#: Seconds until the process is ready, and for one answer.
START_S, ANSWER_S = 60.0, 8.0
#: Seconds before it is started anew.
RETRY_S = 2.0
#: Seconds between two looks at whether it is ready.
LOOK_S = 0.2


class NotHeard(RuntimeError):
    """Whisper does not answer; the message says why."""


class WhisperProcess:
    """Owns the process and the thread that reads its answers. One request at a time."""

    def __init__(self, command: Sequence[str] = (sys.executable, "-m", "voice_recognition.whisper_process")) -> None:
        """
        Args:
            command: program and arguments
        """
        self._command = tuple(command)
        self._lock = threading.Lock()
        self._process: Optional[subprocess.Popen[bytes]] = None
        self._answers: queue.Queue[Dict[str, Any]] = queue.Queue()
        self._is_closed = False
        self._problem = "Whisper is being loaded"
        self._ready = threading.Event()
        self._may_start_at = 0.0
        self._started_at = self._loaded_in_s = 0.0

    @property
    def is_ready(self) -> bool:
        """Whether it hears."""
        return self._ready.is_set()

    @property
    def loaded_in_s(self) -> float:
        """Seconds that it took to load it; 0 as long as it does not hear."""
        return self._loaded_in_s

    @property
    def memory_mb(self) -> int:
        """Memory that the process holds, megabytes; 0 when nobody knows."""
        process = self._process
        try:
            text = Path(f"/proc/{process.pid}/status").read_text(encoding="ascii") if process is not None else ""
        except OSError:
            return 0
        resident = next((line.split()[1] for line in text.splitlines() if line.startswith("VmRSS")), "0")
        return int(resident) // 1000

    @property
    def problem(self) -> str:
        """Why it does not hear; empty if it does."""
        return "" if self.is_ready else self._problem

    def start(self) -> None:
        """Load it in the background, unless it runs, or has just been started."""
        with self._lock:
            self._start()

    def wait_until_ready(self, timeout_s: float = START_S) -> bool:
        """Wait until it hears, started anew if need be; return whether it does."""
        until = time.monotonic() + timeout_s
        while not self._ready.wait(LOOK_S) and time.monotonic() < until:
            self.start()
        return self.is_ready

    def hear(self, pcm: bytes, prompt: str = "") -> Transcript:
        """Return what is said in a sound.

        Args:
            pcm: 16 kHz, 16 bit, mono
            prompt: names and words that are likely
        Raises:
            NotHeard: it does not answer
        """
        return transcript_of(self._ask({"hear": True, "prompt": prompt, "bytes": len(pcm)}, pcm))

    def score(self, sound: int, texts: Sequence[str]) -> Tuple[Sentence, ...]:
        """Return how likely some texts are in a sound; nothing for a sound that is forgotten.

        Args:
            sound: its number
            texts: what may have been said
        Raises:
            NotHeard: it does not answer
        """
        return transcript_of(self._ask({"score": list(texts), "sound": sound})).sentences if texts else ()

    def end_process(self, problem: str) -> None:
        """End the process; the next request starts it anew.

        Args:
            problem: why
        """
        with self._lock:
            self._end(problem)

    def close(self) -> None:
        """End the process for good."""
        with self._lock:
            self._is_closed = True
            self._end("closed")

    def _start(self) -> None:
        if self._is_closed or self._process is not None or time.monotonic() < self._may_start_at:
            return
        self._started_at = time.monotonic()
        self._may_start_at = self._started_at + RETRY_S
        try:
            # Ctrl-C is for the program that owns it; the process ends with its input.
            process = subprocess.Popen(
                self._command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, start_new_session=True
            )
        except OSError as error:
            self._problem = str(error)
            return
        self._process, self._answers = process, queue.Queue()
        threading.Thread(target=self._read, args=(process, self._answers), daemon=True).start()

    def _read(self, process: "subprocess.Popen[bytes]", answers: "queue.Queue[Dict[str, Any]]") -> None:
        """Read the answers of one process until it ends."""
        assert process.stdout is not None
        for line in process.stdout:
            answer: Dict[str, Any] = json.loads(line)
            if answer.get("ready"):
                self._loaded_in_s = time.monotonic() - self._started_at
                self._ready.set()
            else:
                self._problem = str(answer.get("error", self._problem))
                answers.put(answer)
        answers.put({"error": "Whisper has ended"})
        with self._lock:
            if process is self._process:
                self._end(self._problem)

    def _ask(self, request: Dict[str, Any], pcm: bytes = b"") -> Dict[str, Any]:
        with self._lock:
            self._start()
            process = self._process
            if process is None or not self._ready.is_set():
                raise NotHeard(self._problem)
            answers = self._answers
            assert process.stdin is not None
            try:
                process.stdin.write(json.dumps(request).encode() + b"\n" + pcm)
                process.stdin.flush()
                answer = answers.get(timeout=ANSWER_S)
            except (OSError, queue.Empty) as error:
                self._end("Whisper did not answer, and is started anew")
                raise NotHeard(self._problem) from error
            if "error" in answer:
                raise NotHeard(str(answer["error"]))
            return answer

    def _end(self, problem: str) -> None:
        """End the process; its thread ends with it."""
        process, self._process = self._process, None
        self._problem = problem
        self._ready.clear()
        self._loaded_in_s = 0.0
        if process is not None:
            process.kill()
            process.wait(timeout=ANSWER_S)
            if process.stdin is not None:
                # What was not written is lost with the process.
                with contextlib.suppress(OSError):
                    process.stdin.close()
