"""Listens to the microphone: divides its sound into utterances, and finds the stops in it."""

import threading
import time
from functools import partial
from typing import Callable, Optional, Tuple

import rospy

from voice_recognition.early_hearing import EarlyHearing
from voice_recognition.endpointing import Endpointer, Utterance, VoiceDetector
from voice_recognition.microphone import OTHER_RATE, Microphone, SoundSource, arecord_command
from voice_recognition.own_voice import OwnVoice
from voice_recognition.recogniser import NoRecogniser, model_dictionary
from voice_recognition.ros_audio import TopicMicrophone
from voice_recognition.ros_search_thread import SearchThread
from voice_recognition.settings import Settings
from voice_recognition.sound import clipped_share
from voice_recognition.speech_detection import SpeechStream, load_session
from voice_recognition.spotting import LONGEST_S, StopSpotter
from voice_recognition.stop_hearing import OtherOpinion, StopHearing
from voice_recognition.whisper_model import NoWhisper

#: Seconds before the microphone is tried again.
RETRY_S = 10.0
#: Share of a sound from which on it is told that it is cut off, and seconds between two such lines of the log.
CLIPPED, WARN_S = 0.01, 60.0


class Listener:
    """Owns the thread of the microphone, and the one that searches for stops: neither waits for the commands."""

    def __init__(
        self,
        settings: Callable[[], Settings],
        *,
        is_robot_speaking: Callable[[], bool],
        may_robot_say_stop: Callable[[], bool],
        on_stop: Callable[[str], None],
        on_pause: Callable[[Utterance], None],
        on_utterance: Callable[[Utterance], None],
        stop_by_whisper: Optional[OtherOpinion],
    ) -> None:
        """
        Args:
            settings: returns which microphone to listen to
            is_robot_speaking: whether the robot speaks now; then stops are searched for in the stream
            may_robot_say_stop: whether what the robot says now has a stop in it, which must not stop it
            on_stop: called with a stop that was heard
            on_pause: called when an utterance may have ended
            on_utterance: called when it has
            stop_by_whisper: the stop that Whisper hears; None if pocketsphinx alone hears
        """
        self._stop_by_whisper = stop_by_whisper
        self._settings = settings
        self._is_robot_speaking, self._may_robot_say_stop = is_robot_speaking, may_robot_say_stop
        self._on_stop, self._on_pause, self._on_utterance = on_stop, on_pause, on_utterance
        self._stops = SearchThread("stops")
        self._early_stop: EarlyHearing[None, str] = EarlyHearing()

    def start(self) -> None:
        """Listen from now on."""
        threading.Thread(target=self._run, daemon=True).start()

    def _run(self) -> None:
        said = ""
        while not rospy.is_shutdown():
            settings = self._settings()
            command = settings.microphone or arecord_command(settings.device)
            has_sound, complaint = False, "arecord is not installed"
            if settings.audio_topic:
                has_sound, complaint = self._listen_to(
                    settings.audio_topic, partial(TopicMicrophone, settings.audio_topic)
                )
            elif command is not None:
                has_sound, complaint = self._listen_to(command[0], partial(Microphone, command))
            complaint = complaint or "sound card?"
            if has_sound:
                rospy.logwarn("the microphone has ended (%s), and is tried again", complaint)
            elif said != complaint:
                rospy.loginfo("no microphone input (%s); running without voice", complaint)
            said = "" if has_sound else complaint
            time.sleep(RETRY_S)

    def _listen_to(self, name: str, open_source: Callable[[], SoundSource]) -> Tuple[bool, str]:
        """Listen to a microphone until it ends; return whether it made any sound, and what it said is wrong."""
        try:
            spotter = StopSpotter(model_dictionary())
            source = open_source()
        except (NoRecogniser, OSError) as reason:
            return False, str(reason)
        hearing = StopHearing(spotter, self._stop_by_whisper)
        endpointer, own_voice = Endpointer(voice=self._voice_detector()), OwnVoice()
        has_sound = False
        try:
            for part in source.parts():
                if rospy.is_shutdown():
                    return True, ""
                if not has_sound:
                    if OTHER_RATE in source.complaint:
                        return False, source.complaint
                    has_sound = True
                    rospy.loginfo("listening to %s", name)
                is_speaking = self._is_robot_speaking()
                own_voice.follow(endpointer.time_s, is_speaking=is_speaking)
                if is_speaking and not self._may_robot_say_stop():
                    self._stops.later(lambda part=part: self._look_for_stop(spotter, part))
                for utterance in endpointer.feed(part):
                    if self._may_be_stop(utterance):
                        self._stops.later(lambda utterance=utterance: self._check_for_stop(hearing, utterance))
                    if not own_voice.is_own(utterance):
                        _warn_of_bad_sound(utterance)
                        self._on_utterance(utterance)
                pause = endpointer.take_pause()
                if pause is not None:
                    self._search_early(hearing, pause)
                    if not own_voice.is_own(pause):
                        self._on_pause(pause)
            return has_sound, source.complaint
        finally:
            source.close()
            hearing.close()

    def _voice_detector(self) -> Optional[VoiceDetector]:
        """Return what tells a voice from noise, where Whisper hears."""
        if self._stop_by_whisper is None:
            return None
        try:
            return SpeechStream(load_session()).feed
        except NoWhisper as reason:
            rospy.logwarn("the end of what is said is found by its loudness alone: %s", reason)
            return None

    def _look_for_stop(self, spotter: StopSpotter, part: bytes) -> None:
        """Look for a stop in the stream while the robot speaks."""
        if not self._is_robot_speaking() or self._pass_on_stop(spotter.stop_in_stream(part)):
            spotter.forget_stream()

    def _search_early(self, hearing: StopHearing, utterance: Utterance) -> None:
        """Look for a stop in what may be a whole utterance; it counts if nobody speaks on."""
        if self._may_be_stop(utterance):
            self._stops.later(lambda: self._early_stop.listen(utterance, None, hearing.stop_in))

    def _check_for_stop(self, hearing: StopHearing, utterance: Utterance) -> None:
        self._pass_on_stop(self._early_stop.heard(utterance, None, hearing.stop_in))

    def _pass_on_stop(self, text: Optional[str]) -> bool:
        """Pass on the stop that was heard, empty for none; returns whether there was one."""
        if text:
            self._on_stop(text)
        return bool(text)

    def _may_be_stop(self, utterance: Utterance) -> bool:
        """Whether an utterance is short enough for a stop, and not the robot's own."""
        is_own = self._is_robot_speaking() and self._may_robot_say_stop()
        return utterance.end_s - utterance.begin_s <= LONGEST_S and not is_own


def _warn_of_bad_sound(utterance: Utterance) -> None:
    if clipped_share(utterance.pcm) > CLIPPED:
        rospy.logwarn_throttle(WARN_S, "the microphone is too loud, and its sound is cut off: lower its gain")
    if utterance.is_cut:
        rospy.logwarn_throttle(WARN_S, "the sound has no pause: it is heard in parts")
