"""What people cry when a robot must stop, by words alone.

The short way of "Stop." must not wait for a parser, a file or another node, and does not know what runs: so every word
that it needs stands in this module. An utterance is a cry where a phrase of `CRIES` stands at the front of one of its
sentences, or behind nothing but fillers, politeness, a name or a warning, and what follows does not make another
command of it: "stop, you will hit the lamp" is a cry, "stop at the door" and "wait for me" are not.
"""

import enum
from dataclasses import dataclass
from typing import Dict, FrozenSet, Iterable, List, Mapping, Optional, Sequence, Tuple

from command_server.spoken_words import plain_text, tokens_of

Phrase = Tuple[str, ...]


class Kind(enum.Enum):
    """What a cry is for. Until a robot can pause, each kind stops it."""

    STOP = "stop"
    PAUSE = "pause"
    TAKE_BACK = "take_back"
    FORGET = "forget"


class Tail(enum.Enum):
    """What may follow a cry besides fillers, a pause in speech, or the next cry."""

    ANYTHING = "anything"  # but a place, a distance, a time or a condition, which belong to a command
    LASTING = "lasting"  # a clause of its own, or how long: "don't move for a minute"
    UNTIL = "until"  # a clause of its own, or until when: "stay there until I come back"
    CLAUSE = "clause"  # a clause of its own: "hold on you're too close"
    OBJECT = "object"  # a clause, or what was asked for: "cancel that", "cancel the last command"
    NEEDS_OBJECT = "needs_object"  # what was asked for, and no less: "forget that"
    ACTIVITY = "activity"  # a clause, an activity or "it": "quit following me", "enough driving"
    NOTHING = "nothing"


@dataclass(frozen=True)
class Cry:
    """An utterance that stops the robot.

    Attributes:
        kind: what it is for
        rest: what was said behind it
    """

    kind: Kind
    rest: str = ""


#: The table of cries, in plain words: contractions are spelled out before it is asked ("dont", "don't": "do not").
CRIES: Tuple[Tuple[Kind, Tail, str], ...] = (
    (
        Kind.STOP,
        Tail.ANYTHING,
        (
            "stop; halt; abort; whoa; woah; estop; e stop; cease; emergency stop; emergency halt; would you mind "
            "stopping; do you mind stopping; how about stopping; come to a stop; come to a halt; come to a "
            "standstill; come to a full stop; come to a complete stop; come to a complete halt; enough of"
        ),
    ),
    (
        Kind.STOP,
        Tail.LASTING,
        (
            "freeze; stand still; keep still; hold still; be still; sit still; stay still; remain where you are; do "
            "not move; do not you move; do not you dare move; do not anybody move; nobody move; stand down; stay "
            "back; keep back"
        ),
    ),
    (
        Kind.STOP,
        Tail.CLAUSE,
        (
            "no more of that; no more of this; no further; no closer; go no further; come no closer; not another "
            "step; not one more step; not another inch; do not come any closer; do not go any further; do not go any "
            "closer; do not take another step; do not take one more step; not one more inch; that is far enough; "
            "that is close enough; far enough; close enough; that will do; that is quite enough; that is more than "
            "enough; that will be enough; that would be enough; i have had enough; i have had enough of this; i have "
            "had enough of that; enough is enough; cut it out; cut that out; knock it off; knock that off; pack it "
            "in; give it a rest; desist; lay off; watch out; look out; brake; brakes; hit the brake; hit the brakes; "
            "apply the brakes; put the brakes on; kill the engine; kill the engines; kill the motor; kill the "
            "motors; kill the power; hit the emergency stop; press the emergency stop; push the emergency stop; cut "
            "the engine; cut the engines; cut the motor; cut the motors; cut the power; time out; timeout"
        ),
    ),
    (Kind.STOP, Tail.ACTIVITY, "quit; enough; that is enough; no more"),
    (
        Kind.STOP,
        Tail.NOTHING,
        (
            "full stop; all stop; dead stop; hard stop; complete stop; emergency; do not; do not do that; do not do "
            "it; do not do this; do not you dare; stay away; stay away from me; keep away; keep away from me; leave "
            "me alone; shut down; shutdown; shut it down; power down; power off; kill switch; break"
        ),
    ),
    (
        Kind.PAUSE,
        Tail.UNTIL,
        (
            "stay; stay put; stay here; stay there; stay right here; stay right there; stay where you are; stay "
            "right where you are; wait here; wait there; wait right here; wait right there"
        ),
    ),
    (
        Kind.PAUSE,
        Tail.CLAUSE,
        (
            "wait; wait up; hold on; hold it; hold up; hold everything; hold your horses; hold position; hold your "
            "position; hang on; one moment; just a moment; just a second; just a sec; just a minute; give me a "
            "moment; give me a second; give me a sec; give me a minute"
        ),
    ),
    (Kind.PAUSE, Tail.OBJECT, "pause; suspend; interrupt"),
    (Kind.PAUSE, Tail.NOTHING, "hold; stand by"),
    (Kind.TAKE_BACK, Tail.OBJECT, "cancel; terminate; discontinue; disregard; never mind; nevermind"),
    (
        Kind.TAKE_BACK,
        Tail.NEEDS_OBJECT,
        "scratch; scrap; strike; ignore; belay; call off; end; abandon; revoke; withdraw",
    ),
    (
        Kind.TAKE_BACK,
        Tail.CLAUSE,
        "call it off; call that off; i take that back; i take it back; i changed my mind; i have changed my mind",
    ),
    (Kind.TAKE_BACK, Tail.NOTHING, "no no; skip it; skip that; on second thought; on second thoughts"),
    (Kind.FORGET, Tail.NEEDS_OBJECT, "forget; forget about"),
    (Kind.FORGET, Tail.CLAUSE, "forget i said anything; forget i said that; forget i said it"),
)

#: Cries that may also stand behind a name or a warning without a pause in speech: "Rosie stop".
STRONG: FrozenSet[str] = frozenset("stop halt estop whoa woah freeze wait".split())

#: Words that are passed over wherever they stand.
SOFT: FrozenSet[str] = frozenset("please kindly really maybe simply just".split())
#: Words that change nothing, before or behind a cry.
FILLERS: FrozenSet[str] = frozenset(
    (
        "robot turtlebot computer machine now right immediately instantly quickly quick hey hi yo oh ah uh "
        "uhh um umm er erm eh hm ok okay alright well so no nope yes yeah yep you there here already "
        "god gosh jesus christ damn dammit goddamn hell shit fuck ouch ow sorry listen look sir mister mr dear "
        "buddy guys boy everybody everyone somebody someone anybody actually again dead do stupid thanks all "
        "both straightaway"
    ).split()
)
FILLER_PHRASES: Tuple[str, ...] = (
    "thank you",
    "come on",
    "my god",
    "my dear",
    "for god s sake",
    "for gods sake",
    "for heaven s sake",
    "for heavens sake",
    "for christ s sake",
    "for pete s sake",
    "for goodness sake",
    "for crying out loud",
    "for the love of god",
    "excuse me",
    "that is it",
    "one second",
    "good robot",
    "all right",
    "damn it",
    "god damn it",
    "at once",
    "be careful",
    "no matter what",
)

#: "And stop" is a cry of its own, but not behind "Go to the kitchen."
OPENINGS: Tuple[str, ...] = ("and", "then", "and then", "but")
#: What leads to a cry: "could you please stop", "I said stop".
LEADS: Tuple[str, ...] = (
    "can you",
    "could you",
    "will you",
    "would you",
    "can not you",
    "will not you",
    "why do not you",
    "why will not you",
    "why can not you",
    "i want you to",
    "i need you to",
    "i would like you to",
    "i say",
    "i said",
    "i repeat",
    "i told you to",
    "i asked you to",
    "i am telling you to",
    "i am asking you to",
    "i order you to",
    "i command you to",
    "i beg you",
    "i beg you to",
    "i am begging you",
    "i am begging you to",
    "you have to",
    "you need to",
    "you must",
    "you should",
    "you can",
    "you may",
    "you better",
    "you had better",
    "you would better",
    "you ought to",
    "we need to",
    "we have to",
    "we must",
    "we should",
    "we better",
    "let us",
    "time to",
    "it is time to",
    "make it",
    "make the robot",
    "get it to",
    "try to",
    "go ahead and",
    "be so kind and",
    "would you be so kind and",
    "would you be so kind as to",
    "do me a favor and",
    "do me a favour and",
    "i want to",
    "i would like to",
    "i need to",
    "i think",
    "i am going to need you to",
    "i will need you to",
    "i must ask you to",
    "i have to ask you to",
    "could i ask you to",
    "i wish you would",
    "can we",
    "could we",
    "can someone",
    "can somebody",
    "could someone",
    "could somebody",
    "will someone",
    "will somebody",
    "would someone",
    "would somebody",
    "how about you",
    "you are to",
    "you might want to",
    "what the hell",
    "what are you doing",
    "where are you going",
)

#: What may stand behind any cry.
TRAILS: Tuple[str, ...] = (
    "where you are",
    "a second",
    "a sec",
    "a minute",
    "a moment",
    "a bit",
    "one second",
    "one moment",
    "one minute",
    "for a moment",
    "for a second",
    "for a sec",
    "for a bit",
    "for now",
    "for today",
    "at all",
    "a muscle",
    "an inch",
    "any further",
    "any farther",
    "any closer",
    "any more",
    "anymore",
    "another inch",
    "yet",
    "right away",
    "straight away",
    "will you",
    "would you",
    "if you please",
    "in place",
    "just a minute",
    "just a second",
    "just a moment",
    "a mo",
    "a tick",
    "this instant",
    "this minute",
    "this second",
)

#: What was asked for, as "cancel" and its like may name it.
OBJECTS: FrozenSet[str] = frozenset(
    (
        "it this that them everything all the my your last previous current whole what i just said asked told "
        "you are doing were of program command commands order orders request requests instruction instructions "
        "task tasks mission goal goals action actions movement motion navigation operation plan job thing "
        "things robot about"
    ).split()
)
_WEAK_OBJECTS: FrozenSet[str] = frozenset("the my your last previous current whole of i you are were about".split())

#: Behind "stop": a place, a distance or a time, which make a command of it that goes the long way.
PLACES: FrozenSet[str] = frozenset(
    (
        "at by in near next beside behind on onto under underneath below above outside inside between opposite "
        "close before after past across within beyond against around along over short halfway midway towards "
        "toward during every later tomorrow tonight as where wherever"
    ).split()
)
#: ... unless the words go on like this.
NO_PLACES: Tuple[str, ...] = (
    "at once",
    "at this",
    "at last",
    "in your tracks",
    "in the name",
    "in place",
    "on the spot",
    "on the double",
    "where you are",
    "where you stand",
    "wherever you are",
    "as soon as possible",
    "as soon as you can",
    "as fast",
    "as quickly",
    "as quick",
    "as i said",
    "as i told",
    "before you",
    "before i",
    "before it is",
    "before we",
    "before he",
    "before she",
    "before they",
    "before someone",
    "before somebody",
    "before something",
    "around here",
)
_BEFORE_PLACES: FrozenSet[str] = frozenset(
    "right just exactly directly immediately only shortly somewhere about".split()
)
CONDITIONS: FrozenSet[str] = frozenset("when whenever if once".split())
NO_CONDITIONS: Tuple[str, ...] = (
    "once and",
    "if you please",
    "if you can",
    "if you could",
    "if you would",
    "if you hear",
    "if you do not mind",
    "if possible",
)
_LENGTHS: FrozenSet[str] = frozenset(
    (
        "foot feet ft inch inches yard yards metre metres meter meters centimetre centimetres centimeter centimeters "
        "cm m mm km mile miles step steps degree degrees"
    ).split()
)
_AMOUNTS: FrozenSet[str] = frozenset(
    (
        "a an one two three four five six seven eight nine ten twelve fifteen twenty thirty forty fifty hundred half "
        "quarter couple few of and point"
    ).split()
)
#: "A stop sign" is a thing.
_COMPOUNDS: FrozenSet[str] = frozenset("sign signs button".split())

#: Begin a clause of its own behind a cry: "wait you are going the wrong way".
_CLAUSES: FrozenSet[str] = frozenset(
    "you i he she we they no not and then or but let do because somebody what why how could can would".split()
)
_IMPERSONAL: FrozenSet[str] = frozenset("it that there this".split())
_SUBJECTS: FrozenSet[str] = frozenset("i you".split())
_VERBS_OF_IT: FrozenSet[str] = frozenset("is was will might could can does has looks".split())
_LASTS: FrozenSet[str] = frozenset("until till while unless before or".split())
_TAIL_WORDS: Mapping[Tail, FrozenSet[str]] = {Tail.UNTIL: _LASTS, Tail.LASTING: _LASTS | {"for"}}

#: Words that take a cry as what is said, not as a cry.
SAYING: FrozenSet[str] = frozenset(
    (
        "say says saying said tell tells telling told ask asks asked shout shouts shouted yell yells cry call "
        "write writes spell read repeat translate announce whisper answer reply mean means word add type print "
        "display draw sing"
    ).split()
)
#: Before "stop": a name ends with none of these.
_NO_NAMES: FrozenSet[str] = frozenset(
    (
        "a an the this that these those my your his her its our their two next last first second final only "
        "nice good short long quick brief bus tram train taxi truck pit door coach metro subway rest full non "
        "toilet coffee deep press push click never not to and or then who what when where why how which if "
        "once until till unless whenever after before always often hardly barely usually sometimes i we he she "
        "it they do did does will would can could shall should may might must am is are was were be been has "
        "have had at by in on near about into from of for with no"
    ).split()
)
#: A warning before a cry begins with one of these: "you're going to hit the wall stop", "too far stop".
WARNINGS: FrozenSet[str] = frozenset(
    ("you your i we that it its there not wrong too watch look mind careful be ouch ow oh no nope hey god help").split()
)
_BLOCKING: FrozenSet[str] = SAYING | {"until", "till", "when", "whenever", "if", "once", "never", "unless"}
#: Said just before a cry they set it off: "a bit further okay stop".
_SET_OFF: FrozenSet[str] = frozenset("ok okay no nope oh hey whoa wait alright ouch enough".split())

#: Verbs of commands.
COMMAND_VERBS: FrozenSet[str] = frozenset(
    (
        "accompany approach back bring carry check clean clear climb close come cross deliver describe dock "
        "drive drop enter escort exit face fetch find fly follow get give go grab grasp greet guide hand head "
        "help hold inspect introduce lead leave lift lock look lower make march memorize meet move navigate "
        "open park pass pick place play point position pour proceed pull push put raise reach release remember "
        "remove repeat return reverse ride roll rotate run say search send serve set show sit speak spin start "
        "step switch take tell throw travel turn unlock vacuum visit walk wash wipe withdraw"
    ).split()
)
#: Words that are mistyped, and the English words that a slip of them would give.
_TYPED: Mapping[str, Kind] = {
    "stop": Kind.STOP,
    "halt": Kind.STOP,
    "abort": Kind.STOP,
    "freeze": Kind.STOP,
    "cancel": Kind.TAKE_BACK,
    "wait": Kind.PAUSE,
}
_ENGLISH: FrozenSet[str] = frozenset("top sop stoop alt hat hal bort feeze reeze ait wat wit await canel".split())


def _by_first_word(phrases: Iterable[str]) -> Mapping[str, Tuple[Phrase, ...]]:
    """Return phrases by their first word, the longest first."""
    found: Dict[str, List[Phrase]] = {}
    for phrase in phrases:
        words = tuple(phrase.split())
        found.setdefault(words[0], []).append(words)
    return {first: tuple(sorted(of_it, key=len, reverse=True)) for first, of_it in found.items()}


#: No name of the robot begins so, nor does a warning: "at the door, stop", "turn left, stop".
_NO_ADDRESS: FrozenSet[str] = (
    PLACES
    | CONDITIONS
    | _BLOCKING
    | COMMAND_VERBS
    | (_AMOUNTS - {"a", "and"})
    | {"first", "next", "last", "to", "from", "with"}
)
_NOT_FIRST = _NO_NAMES | SAYING | COMMAND_VERBS | {"one"}
# Words; who says more fillers than that has cried before them.
_LONGEST_WARNING = 12
_LONGEST_TRAIL = 24
_PAUSES = frozenset(",.")
_ADDRESSING = (FILLERS - WARNINGS) | {","}
_AUXILIARIES = frozenset("do does did will would can could should must may might need".split())
_ENTRIES: Mapping[Phrase, Tuple[Kind, Tail]] = {
    tuple(phrase.split()): (kind, tail) for kind, tail, phrases in CRIES for phrase in phrases.split(";")
}
_CRIES = _by_first_word(" ".join(phrase) for phrase in _ENTRIES)
_OPENINGS = _by_first_word(FILLER_PHRASES + LEADS + OPENINGS)
_LEADS = _by_first_word(FILLER_PHRASES + LEADS)
_TRAILS = _by_first_word(FILLER_PHRASES + TRAILS)
_NO_PLACES = _by_first_word(NO_PLACES + NO_CONDITIONS)


def _phrase_at(words: Sequence[str], position: int, phrases: Mapping[str, Tuple[Phrase, ...]]) -> int:
    """Return the number of words of the longest phrase that stands at a position, 0 for none."""
    if position >= len(words):
        return 0
    return next(
        (
            len(phrase)
            for phrase in phrases.get(words[position], ())
            if tuple(words[position : position + len(phrase)]) == phrase
        ),
        0,
    )


def _slips() -> Mapping[str, Kind]:
    """Return what a slip of the finger makes of a cry: two letters swapped, one left out or typed twice."""
    found: Dict[str, Kind] = {}
    for word, kind in _TYPED.items():
        swapped = {word[:at] + word[at + 1] + word[at] + word[at + 2 :] for at in range(len(word) - 1)}
        short = {word[:at] + word[at + 1 :] for at in range(len(word))}
        double = {word[:at] + word[at] + word[at:] for at in range(len(word))}
        found.update({slip: kind for slip in swapped | short | double if slip != word and slip not in _ENGLISH})
    return found


_SLIPS = _slips()


class _Sentence:
    """A sentence in plain words, with "," for pauses."""

    def __init__(self, words: Sequence[str], *, is_first: bool) -> None:
        self._words = list(words)
        self._openings = _OPENINGS if is_first else _LEADS
        self._fronts = self._find_fronts()
        self._first_block = next((at for at, word in enumerate(words) if word in _BLOCKING), len(words))
        # Where the sentence begins behind "hey robot,".
        self._start = next((at for at, word in enumerate(words) if word not in _ADDRESSING), len(words))
        self._is_warning = self._start < len(words) and words[self._start] in WARNINGS

    def cry(self) -> Optional[Tuple[Kind, int]]:
        """Return the kind of the first cry and the position behind it."""
        for position in range(len(self._words)):
            for phrase in _CRIES.get(self._words[position], ()):
                end = position + len(phrase)
                kind, tail = _ENTRIES[phrase]
                if (
                    tuple(self._words[position:end]) == phrase
                    and self._may_begin(position, phrase)
                    and self._may_end(end, tail, phrase)
                ):
                    return kind, end
        return None

    def _find_fronts(self) -> Mapping[int, bool]:
        """Return the positions before which only a name, fillers and leads stand, and whether there is a name."""
        position, has_name, has_lead = 0, False, False
        fronts: Dict[int, bool] = {}
        while position < len(self._words):
            fronts[position] = has_name
            word = self._words[position]
            length = _phrase_at(self._words, position, self._openings)
            if not length and word not in FILLERS and word != ",":
                if has_name or has_lead or not word.isalpha() or word in _NOT_FIRST:
                    break
                has_name = True
            has_lead = has_lead or length > 0
            position += max(length, 1)
        return fronts

    def _may_begin(self, position: int, phrase: Phrase) -> bool:
        is_strong = phrase[0] in STRONG
        has_name = self._fronts.get(position)
        if has_name is not None:
            # "Rosie stop" and "Rosie hold on", but not "warm enough".
            return is_strong or not has_name or (len(phrase) > 1 and phrase[0] != "no" and phrase != ("do", "not"))
        if not self._start < position <= min(self._first_block, self._start + _LONGEST_WARNING):
            return False
        before = self._words[self._start : position]
        last = next((word for word in reversed(before) if word != ","), "")
        if before[-1] == "," and last not in ("not", "never", "to", "and", "or"):
            # "My dear robot, stop"; "the lamp, stop": but not "at the door, stop".
            return self._is_warning or (len(before) <= 4 and before[0] not in _NO_ADDRESS)
        return (
            is_strong
            and not self._is_negated(position)
            and (
                self._is_set_off(before)
                or self._is_guided(before)
                or (
                    last not in _NO_NAMES
                    and (self._is_warning or self._words[position + 1 : position + 2] == [phrase[0]])
                )
            )
        )

    def _is_negated(self, position: int) -> bool:
        """Whether it is said not to: "don't ever stop"."""
        return any(
            self._words[at] == "not" and self._words[at - 1] in _AUXILIARIES
            for at in range(max(1, position - 3), position)
        )

    @staticmethod
    def _is_set_off(before: Sequence[str]) -> bool:
        """Whether an interjection stands before a cry; "no" is none in "there is no stop here"."""
        is_determiner = before[-1] == "no" and before[-2:-1] and before[-2] in ("is", "are", "have", "has", "see")
        return before[-1] in _SET_OFF and not is_determiner

    @staticmethod
    def _is_guided(before: Sequence[str]) -> bool:
        """Whether a robot is guided by words that are said again and again: "back back back stop"."""
        return any(
            len(before) % length == 0 and list(before) == list(before[:length]) * (len(before) // length)
            for length in (1, 2, 3)
            if 2 * length <= len(before)
        )

    def _may_end(self, end: int, tail: Tail, phrase: Phrase) -> bool:
        if tail is Tail.ANYTHING:
            return not self._goes_on_as_command(end)
        if tail in (Tail.OBJECT, Tail.NEEDS_OBJECT):
            behind = self._behind_object(end)
            if tail is Tail.NEEDS_OBJECT and behind == end:
                return False
            end = behind
        position = end
        while position < min(len(self._words), end + _LONGEST_TRAIL):
            word = self._words[position]
            if tail is not Tail.NOTHING and (
                _phrase_at(self._words, position, _CRIES)
                or self._is_clause(position)
                or word in _TAIL_WORDS.get(tail, ())
            ):
                return True
            if (
                tail is Tail.ACTIVITY
                and position == end
                and ((word.endswith("ing") and len(word) > 4) or word in ("it", "that", "this"))
            ):
                return True
            is_again = tuple(self._words[position : position + len(phrase)]) == phrase
            length = len(phrase) if is_again else _phrase_at(self._words, position, _TRAILS)
            if not length and word not in FILLERS and word != ",":
                return False
            position += max(length, 1)
        return True

    def _is_clause(self, position: int) -> bool:
        """Whether something else is said from here on: "wait, I see", "wait it's hot"."""
        word = self._words[position]
        is_impersonal = word in _IMPERSONAL and self._words[position + 1 : position + 2]
        return word == "," or word in _CLAUSES or bool(is_impersonal and self._words[position + 1] in _VERBS_OF_IT)

    def _behind_object(self, position: int) -> int:
        """Return the position behind what was asked for ("the last command", "what I said"), the same for none."""
        end = position
        while (
            end < len(self._words)
            and self._words[end] in OBJECTS
            and (self._words[end] not in _SUBJECTS or "what" in self._words[position:end])
        ):
            end += 1
        return position if set(self._words[position:end]) <= _WEAK_OBJECTS else end

    def _goes_on_as_command(self, position: int) -> bool:
        """Whether a place, a distance, a time or a condition follows: "stop at the door", "stop when you see me"."""
        words = self._words
        if position < len(words) and words[position] in _COMPOUNDS:
            return True
        while position < len(words) and words[position] in _BEFORE_PLACES:
            position += 1
        if position < len(words) and words[position] in PLACES:
            return not _phrase_at(words, position, _NO_PLACES)
        behind = position
        while behind < len(words) and (words[behind] in _AMOUNTS or words[behind][0].isdigit()):
            behind += 1
        if position < behind < len(words) and words[behind] in _LENGTHS:
            return True
        for word, following, at in zip(words[position:], words[position + 1 :], range(position, len(words))):
            if word in _CLAUSES or word == "," or (word, following) == ("it", "is"):
                return False
            is_after = word == "after" and (following in _AMOUNTS or following.isdigit())
            if is_after or (word in CONDITIONS and at + 2 < len(words)):
                return not _phrase_at(words, at, _NO_PLACES)
        return False


def find_cry(text: str) -> Optional[Cry]:
    """Find out whether an utterance stops the robot.

    Args:
        text: in any spelling; of a very long one only the beginning counts
    Returns:
        the cry; None where the utterance goes the long way
    """
    said, unquoted = plain_text(text)
    spoken = tokens_of(unquoted)
    # "Just a moment" is a cry of its own.
    tokens = [
        token
        for token, following in zip(spoken, spoken[1:] + spoken[:1])
        if token.word not in SOFT or (token.word == "just" and following.word == "a")
    ]
    different = {token.word for token in tokens} - _PAUSES
    if len(different) == 1 and different <= _SLIPS.keys():
        return Cry(_SLIPS[different.pop()])
    if different.isdisjoint(_CRIES):
        return None
    words = [token.word for token in tokens]
    ends = [at for at, word in enumerate(words) if word == "."] + [len(words)]
    for first, last in zip([0] + [end + 1 for end in ends], ends):
        if _CRIES.keys().isdisjoint(words[first:last]):
            continue
        found = _Sentence(words[first:last], is_first=first == 0).cry()
        if found is not None:
            kind, end = found
            return Cry(kind, said[tokens[first + end - 1].end :])
    return None


def is_stop(text: str) -> bool:
    """Whether an utterance stops the robot: `find_cry` without its kind."""
    return find_cry(text) is not None
