"""The node: hears commands, asks, and passes them to the pipeline."""

import functools
import threading
import time
from typing import Callable, Dict, Optional, Tuple

import rospy
from roboframenet_msgs.msg import Reply
from std_msgs.msg import Bool, Empty, String
from std_srvs.srv import Trigger, TriggerRequest, TriggerResponse

from command_server.answers import closed_answers
from command_server.emergency_words import is_emergency_stop
from command_server.stop_words import is_stop
from roboframenet_ros.ros_live_parameters import LiveParameters
from roboframenet_ros.ros_node import read_parameters, run_node
from utter.ros_voice import Voice
from voice_recognition import dialogue
from voice_recognition.agreement import Heard, Verdict, answer_of
from voice_recognition.calling import understood
from voice_recognition.dialogue import (
    Answered,
    Asked,
    Command,
    Confirming,
    Event,
    OtherCommand,
    Pushed,
    Replying,
    RobotSpeaks,
    Say,
    Settled,
    SpeechEnded,
    Stop,
    Stopped,
    Thinking,
    Tick,
    Understood,
)
from voice_recognition.early_hearing import EarlyHearing
from voice_recognition.ears import answers
from voice_recognition.endpointing import Utterance
from voice_recognition.engines import Engine, chosen
from voice_recognition.offers import Offer
from voice_recognition.recogniser import NoRecogniser, model_dictionary
from voice_recognition.replies import ReplyEars
from voice_recognition.ros_listener import Listener
from voice_recognition.ros_live_speech import LiveSpeechTopics
from voice_recognition.ros_search_thread import SearchThread
from voice_recognition.ros_speakable import AnyEars, SpeakableCommands
from voice_recognition.ros_speaker import Speaker
from voice_recognition.settings import Settings
from voice_recognition.spoken_language import Words, spoken_words
from voice_recognition.spotting import EMERGENCY_TEXT, STOP_TEXT, says_stop
from voice_recognition.whisper_client import WhisperProcess
from voice_recognition.whisper_ears import WhisperEars

#: Seconds between two looks at the expiry of a state.
TICK_S = 0.2
#: Seconds of one sound of another node that keep this node deaf, at most.
LONGEST_SOUND_S = 60.0


class VoiceRecognition:
    """Hears commands.

    Subscribes:
        what a :class:`.ros_speakable.SpeakableCommands` does;
        speaking (std_msgs/Bool), said (std_msgs/String): the robot's own voice; reply (Reply); text, voice_answer
        (std_msgs/String): answers by another way; push_to_talk (std_msgs/Empty); LiveSpeech of other voices
    Publishes:
        text (std_msgs/String), voice_question (std_msgs/String, latched), voice_state (std_msgs/String, latched),
        voice_heard (std_msgs/String), said, speaking, LiveSpeech
    Services:
        listen (std_srvs/Trigger)
    Parameters: see :class:`voice_recognition.settings.Settings`.
    """

    def __init__(self, settings: Settings) -> None:
        self._settings = settings
        self._rules = settings.dialogue
        self._lock = threading.RLock()
        self._state: dialogue.State = dialogue.begin(self._rules)
        self._speakers: Dict[str, float] = {}
        self._said = ""
        self._early: EarlyHearing[Tuple[dialogue.State, AnyEars], Heard] = EarlyHearing()
        self._reply_ears: Optional[ReplyEars] = None
        self._commands = SearchThread("commands")
        self._whisper = _whisper(settings.engine)
        self._speakable = SpeakableCommands(self._commands, self._whisper, settings.wake_words)
        self._question = rospy.Publisher("voice_question", String, queue_size=1, latch=True)
        self._state_publisher = rospy.Publisher("voice_state", String, queue_size=1, latch=True)
        self._heard = rospy.Publisher("voice_heard", String, queue_size=10)
        self._text = rospy.Publisher("text", String, queue_size=10)
        self._shown: Tuple[str, str] = ("", "")
        self._speaker = Speaker(Voice(is_aloud=settings.aloud, timeout_s=self._rules.deaf_s), self._on_own_speech)
        self._live = LiveSpeechTopics(settings.voice_id, self._on_live_speech)
        self._show()
        self._listener = Listener(
            lambda: self._settings,
            is_robot_speaking=lambda: bool(self._speakers),
            may_robot_say_stop=lambda: says_stop(self._said),
            on_stop=self._on_stop,
            on_pause=self._on_pause,
            on_utterance=self._on_utterance,
            stop_by_whisper=self._stop_by_whisper if self._whisper is not None else None,
        )
        self._subscribers = [
            rospy.Subscriber("speaking", Bool, self._on_speaking, queue_size=10),
            rospy.Subscriber("said", String, self._on_said, queue_size=10),
            rospy.Subscriber("reply", Reply, self._on_reply, queue_size=10),
            rospy.Subscriber("text", String, self._on_text, queue_size=10),
            rospy.Subscriber("voice_answer", String, self._on_answer, queue_size=10),
            rospy.Subscriber("push_to_talk", Empty, lambda _: self._happened(Pushed()), queue_size=10),
        ]
        self._service = rospy.Service("listen", Trigger, self._on_listen)
        self._tuned = LiveParameters(settings, self._tune)
        threading.Thread(target=self._run_clock, daemon=True).start()
        self._listener.start()
        rospy.loginfo("ready: %s", settings)

    def _tune(self, settings: Settings) -> None:
        with self._lock:
            is_between = self._state == dialogue.begin(self._rules)
            self._settings, self._rules = settings, settings.dialogue
            if is_between:
                self._state = dialogue.begin(self._rules)
                self._show()

    # --- events

    def _happened(self, event: Event) -> None:
        with self._lock:
            self._state, actions = dialogue.step(self._state, event, time.monotonic(), self._rules)
            for action in actions:
                self._do(action)
            self._show()

    def _do(self, action: dialogue.Action) -> None:
        if isinstance(action, Say):
            self._speaker.say(action.sentence)
        elif isinstance(action, Stop):
            self._text.publish(String(data=EMERGENCY_TEXT if action.is_emergency else STOP_TEXT))
            self._speaker.be_silent()
            rospy.loginfo("heard %s", "the emergency stop" if action.is_emergency else "a stop")
        elif isinstance(action, Command):
            rospy.loginfo("passes on: %s (%s)", action.text, "confirmed" if action.is_confirmed else "not asked")
            self._text.publish(String(data=action.text))

    def _show(self) -> None:
        """Publish the state and the open question, if they have changed."""
        state = self._state.behind if isinstance(self._state, dialogue.Deaf) else self._state
        state = state.behind if isinstance(state, Thinking) else state
        question = state.offers[0].question if isinstance(state, Confirming) else ""
        if isinstance(state, Confirming) and len(state.offers) > 1:
            question = " / ".join(offer.question for offer in state.offers)
        shown = (type(self._state).__name__.lower(), question)
        if shown[0] != self._shown[0]:
            self._state_publisher.publish(String(data=shown[0]))
        if shown[1] != self._shown[1] or not self._shown[0]:
            self._question.publish(String(data=shown[1]))
        self._shown = shown

    def _on_listen(self, _: TriggerRequest) -> TriggerResponse:
        self._happened(Pushed())
        is_ready = self._speakable.ears is not None
        return TriggerResponse(success=is_ready, message="" if is_ready else "nothing can be heard yet")

    def _answer_in(self, words: Words) -> str:
        """Return the answer to the open question that some words are; empty for none."""
        with self._lock:
            question, ears = dialogue.open_question(self._state), self._reply_ears
            if isinstance(question, Replying):
                return answer_of(words, ears.ways) if ears is not None else ""
            return answer_of(words, answers()) if question is not None else ""

    def _on_answer(self, message: String) -> None:
        name = self._answer_in(spoken_words(message.data))
        if name:
            self._happened(Answered(name))

    def _on_text(self, message: String) -> None:
        if message._connection_header.get("callerid") == rospy.get_name():
            return
        # The pipeline hears an answer to its own question itself.
        is_own = isinstance(dialogue.open_question(self._state), Confirming)
        name = self._answer_in(spoken_words(message.data)) if is_own else ""
        self._happened(Answered(name) if name else OtherCommand())

    def _on_reply(self, message: Reply) -> None:
        if self._settings.speak_replies and message.sentence:
            self._speaker.say(message.sentence)
        if message.outcome != Reply.NEEDS_INFORMATION:
            self._happened(Settled())
            return
        answers = closed_answers(message.code, message.sentence)
        with self._lock:
            self._reply_ears = None
            self._happened(Asked(has_answers=bool(answers)))
        if answers:
            self._commands.later(lambda: self._make_reply_ears(answers))

    def _make_reply_ears(self, answers: Tuple[str, ...]) -> None:
        try:
            ears = ReplyEars(answers, model_dictionary())
        except NoRecogniser as reason:
            rospy.logerr("no answer can be heard: %s", reason)
            return
        with self._lock:
            self._reply_ears = ears

    # --- the robot's own voice

    def _on_own_speech(self, is_speaking: bool) -> None:
        self._is_speaking(rospy.get_name(), is_speaking)

    def _on_speaking(self, message: Bool) -> None:
        caller = message._connection_header.get("callerid", "")
        if caller != rospy.get_name():
            self._is_speaking(caller, message.data)

    def _is_speaking(self, who: str, is_speaking: bool) -> None:
        now = time.monotonic()
        with self._lock:
            if is_speaking:
                self._speakers[who] = now + LONGEST_SOUND_S
            else:
                self._speakers.pop(who, None)
            self._speakers = {name: until for name, until in self._speakers.items() if until > now}
            self._happened(RobotSpeaks(bool(self._speakers)))

    def _on_said(self, message: String) -> None:
        self._said = message.data

    # --- sound

    def _run_clock(self) -> None:
        while not rospy.is_shutdown():
            time.sleep(TICK_S)
            self._speakable.turn()
            self._happened(Tick())

    def _on_stop(self, text: str) -> None:
        self._happened(Stopped(text == EMERGENCY_TEXT))

    def _on_utterance(self, utterance: Utterance) -> None:
        with self._lock:
            searches = self._searches()
            if searches is None:
                return
            self._happened(SpeechEnded())
        how, hear = searches
        self._commands.later(lambda: self._understand(utterance, how, hear))

    def _on_pause(self, utterance: Utterance) -> None:
        """Begin the searches when an utterance may have ended; what they hear counts if nobody speaks on."""
        with self._lock:
            searches = self._searches()
        if searches is not None:
            how, hear = searches
            self._commands.later(lambda: self._early.listen(utterance, how, hear))

    def _searches(self) -> Optional[Tuple[Tuple[dialogue.State, AnyEars], Callable[[bytes], Heard]]]:
        """Return what a sound is heard for now, and the searches; None when nothing but a stop is heard."""
        ears, state = self._speakable.ears, self._state
        if ears is None or not dialogue.hears(state):
            return None
        hear = ears.hear_answer if isinstance(state, Confirming) else ears.hear
        replies = self._reply_ears
        if isinstance(state, Replying) and replies is not None:
            hear = _reply_search(replies, ears)
        return (state, ears), hear

    def _stop_by_whisper(self, pcm: bytes) -> Optional[str]:
        """Return the stop that Whisper hears; empty for none, None if it cannot tell."""
        ears = self._speakable.ears
        return ears.hear_stop(pcm) if isinstance(ears, WhisperEars) else None

    def _understand(
        self, utterance: Utterance, how: Tuple[dialogue.State, AnyEars], hear: Callable[[bytes], Heard]
    ) -> None:
        began = time.monotonic()
        heard = self._early.heard(utterance, how, hear)
        self._tell(heard, time.monotonic() - began)
        self._happened(understood(heard, self._speakable.calls))

    def _tell(self, heard: Heard, seconds: float) -> None:
        words = " ".join(heard.by_grammar)
        text = f"{heard.verdict.value}: {words or '(nothing)'} | {' '.join(heard.by_ngram) or '(nothing)'}"
        self._heard.publish(String(data=text))
        rospy.loginfo("heard in %.2f s: %s", seconds, text)
        if heard.offers or heard.answer:
            self._live.heard(heard.offers[0].text if heard.offers else words, float(heard.verdict is Verdict.SURE))

    def _on_live_speech(self, sentence: str) -> None:
        """Take what another recogniser heard, as if the two searches had agreed on it."""
        if is_stop(sentence):
            self._happened(Stopped(is_emergency_stop(sentence)))
            return
        words = spoken_words(sentence)
        with self._lock:
            ears, state = self._speakable.ears, self._state
            if not dialogue.hears(state):
                return
            answer = self._answer_in(words)
            offer = ears.finder.find(words) if ears is not None else None
            if offer is not None:
                heard = Heard(Verdict.SURE, (offer,), words, answer=answer)
            else:
                # Not in the language: the pipeline may read it, so the words are offered in place of a frame.
                heard = Heard(Verdict.LIKELY, (Offer("", (), sentence),), words, answer=answer)
            self._happened(Understood(heard))


def _whisper(wished: Engine) -> Optional[WhisperProcess]:
    """Load Whisper in the background, if it is to hear; say which recogniser hears, and why."""
    engine, reason = chosen(wished)
    if reason:
        (rospy.logerr if wished is Engine.WHISPER else rospy.loginfo)("hears by pocketsphinx: %s", reason)
    else:
        rospy.loginfo("hears by %s", engine.value)
    if engine is not Engine.WHISPER:
        return None
    whisper = WhisperProcess()
    rospy.on_shutdown(whisper.close)
    whisper.start()
    return whisper


def _reply_search(replies: ReplyEars, ears: AnyEars) -> Callable[[bytes], Heard]:
    """Return the search for the answer to a question of the pipeline."""
    if not isinstance(ears, WhisperEars):
        return functools.partial(replies.hear, commands=ears)
    by_pocketsphinx = functools.partial(replies.hear, commands=ears.by_pocketsphinx)
    return functools.partial(ears.hear_one_of, ways=replies.ways, otherwise=by_pocketsphinx)


def main() -> None:
    """Run the node until ROS shuts down; exits with a sentence when a parameter is wrong."""
    run_node("voice_recognition", lambda: VoiceRecognition(read_parameters(Settings)))
