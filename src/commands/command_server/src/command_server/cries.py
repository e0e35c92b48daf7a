"""Tables of the cries that stop a robot ("stop", "hold on"), and of the words that may stand around a cry.

The tables are constants and not files of word classes, because a stop must not depend on a file or on another node.
"""

import enum
from dataclasses import dataclass
from typing import FrozenSet, Mapping, Tuple


class Kind(enum.Enum):
    """What a cry asks for. Every kind stops the robot, which cannot pause yet."""

    STOP = "stop"
    PAUSE = "pause"
    TAKE_BACK = "take_back"
    FORGET = "forget"


class Tail(enum.Enum):
    """What may follow a cry. Fillers, a pause in speech and another cry may always follow."""

    ANYTHING = "anything"  # except a place, distance, time or condition: "stop at the door" is a command
    LASTING = "lasting"  # a new clause, or a duration: "don't move for a minute"
    UNTIL = "until"  # a new clause, or an end: "stay there until I come back"
    CLAUSE = "clause"  # a new clause: "hold on you're too close"
    OBJECT = "object"  # a new clause, or the request that is cancelled: "cancel that", "cancel the last command"
    NEEDS_OBJECT = "needs_object"  # the request that is cancelled, which must not be missing: "forget that"
    ACTIVITY = "activity"  # a new clause, an activity or "it": "quit following me", "enough driving"
    NOTHING = "nothing"


@dataclass(frozen=True)
class Cry:
    """An utterance that stops the robot.

    Attributes:
        kind: what it asks for
        rest: the words that follow it
        before: the words in front of it
    """

    kind: Kind
    rest: str = ""
    before: str = ""


#: The cries, separated by semicolons. Contractions are spelled out before the comparison: "dont", "don't" are "do not".
CRIES: Tuple[Tuple[Kind, Tail, str], ...] = (
    (
        Kind.STOP,
        Tail.ANYTHING,
        (
            "stop; halt; abort; whoa; woah; estop; e stop; cease; emergency stop; emergency halt; engage the emergency "
            "stop; activate the emergency stop; would you mind "
            "stopping; do you mind stopping; how about stopping; come to a stop; come to a halt; come to a "
            "standstill; come to a full stop; come to a complete stop; come to a complete halt; enough of"
        ),
    ),
    (
        Kind.STOP,
        Tail.LASTING,
        (
            "freeze; stand still; keep still; hold still; be still; sit still; stay still; remain where you are; do "
            "not move; do not you move; do not you dare move; do not anybody move; nobody move; nobody moves; no one "
            "move; no one moves; stand down; stay back; keep back"
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
            "me alone; shut down; shutdown; shut it down; power down; power off; kill switch; break; careful; shut up; "
            "be quiet; quiet; silence; hush"
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

#: Cries that may follow a name or a warning without a pause in speech: "Rosie stop".
STRONG: FrozenSet[str] = frozenset("stop halt estop whoa woah freeze wait".split())

#: Words that are ignored everywhere in an utterance.
SOFT: FrozenSet[str] = frozenset("please kindly really maybe simply just".split())
#: Words that are ignored before and after a cry.
FILLERS: FrozenSet[str] = frozenset(
    (
        "robot turtlebot computer machine now right immediately instantly quickly quick hey hi yo oh ah uh "
        "uhh um umm er erm eh hm ok okay alright well so no nope yes yeah yep you there here already "
        "god gosh jesus christ damn dammit goddamn hell shit fuck ouch ow sorry listen look sir mister mr dear "
        "buddy guys boy everybody everyone somebody someone anybody actually again dead do stupid thanks all "
        "both straightaway"
    ).split()
)
#: Phrases that are ignored before and after a cry.
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

#: Words that may open an utterance with a cry: "and stop". After "Go to the kitchen." they continue a command.
OPENINGS: Tuple[str, ...] = ("and", "then", "and then", "but")
#: Phrases that introduce a cry: "could you please stop", "I said stop".
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
    "can everybody",
    "can everyone",
    "could everybody",
    "could everyone",
    "will everybody",
    "will everyone",
    "would everybody",
    "would everyone",
    "how about you",
    "you are to",
    "you might want to",
    "what the hell",
    "what are you doing",
    "where are you going",
)

#: Whom a sentence with one of `DUTIES` or `BANS` means: "everybody must stop", "the robot should not move".
HEARERS: Tuple[str, ...] = (
    "you",
    "you all",
    "you two",
    "all of you",
    "both of you",
    "each of you",
    "every one of you",
    "everybody",
    "everyone",
    "everybody here",
    "everyone here",
    "the robot",
    "this robot",
    "robot",
    "the robots",
    "robots",
    "all robots",
    "all the robots",
    "every robot",
)
#: What hearers have to do: "everybody has to stop" is "stop".
DUTIES: Tuple[str, ...] = (
    "must",
    "should",
    "shall",
    "can",
    "may",
    "ought to",
    "have to",
    "has to",
    "have got to",
    "has got to",
    "need to",
    "needs to",
    "had better",
    "would better",
    "better",
    "is to",
    "are to",
)
#: What they must not do: "everybody should not move" is "do not move".
BANS: Tuple[str, ...] = (
    "must not",
    "should not",
    "shall not",
    "may not",
    "ought not to",
    "ought to not",
    "had better not",
    "would better not",
    "better not",
    "is not to",
    "are not to",
    "is not allowed to",
    "are not allowed to",
)
#: With these a duty is a ban: "nobody must move". "Nobody has to move" forbids nothing.
NOBODIES: Tuple[str, ...] = (
    "nobody",
    "no one",
    "none of you",
    "not one of you",
    "no robot",
    "nobody here",
    "no one here",
    "nobody else",
    "no one else",
)
BANS_OF_NOBODY: Tuple[str, ...] = (
    "must",
    "should",
    "shall",
    "may",
    "ought to",
    "had better",
    "better",
    "is to",
    "are to",
    "is allowed to",
    "are allowed to",
)
#: Wishes for somebody: "I want everybody to stop".
WISHES: Tuple[str, ...] = ("i want", "i need", "i would like", "we want", "we need")

#: Phrases that may follow any cry.
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

#: Words that name the request that is cancelled: "cancel my last order".
OBJECTS: FrozenSet[str] = frozenset(
    (
        "it this that them everything all the my your last previous current whole what i just said asked told "
        "you are doing were of program command commands order orders request requests instruction instructions "
        "task tasks mission goal goals action actions movement motion navigation operation plan job thing "
        "things robot about"
    ).split()
)
#: Those of them that do not name a request alone: "cancel the last".
WEAK_OBJECTS: FrozenSet[str] = frozenset("the my your last previous current whole of i you are were about".split())

#: Words that begin a place or a time after "stop". The utterance is then a command, and is parsed: "stop at the door".
PLACES: FrozenSet[str] = frozenset(
    (
        "at by in near next beside behind on onto under underneath below above outside inside between opposite "
        "close before after past across within beyond against around along over short halfway midway towards "
        "toward during every later tomorrow tonight as where wherever"
    ).split()
)
#: Phrases that begin like a place or a time, and are none.
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
#: Adverbs that may precede the words of `PLACES`: "stop right before the door".
BEFORE_PLACES: FrozenSet[str] = frozenset(
    "right just exactly directly immediately only shortly somewhere about".split()
)
#: Words that begin a condition. The utterance is then a command: "stop when you see me".
CONDITIONS: FrozenSet[str] = frozenset("when whenever if once".split())
#: Phrases that begin like a condition, and are none.
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
#: Units of a distance: "stop two feet away" is a command.
LENGTHS: FrozenSet[str] = frozenset(
    (
        "foot feet ft inch inches yard yards metre metres meter meters centimetre centimetres centimeter centimeters "
        "cm m mm km mile miles step steps degree degrees"
    ).split()
)
#: Words of an amount.
AMOUNTS: FrozenSet[str] = frozenset(
    (
        "a an one two three four five six seven eight nine ten twelve fifteen twenty thirty forty fifty hundred half "
        "quarter couple few of and point"
    ).split()
)
#: Nouns that form a compound with "stop": "a stop sign" is a thing.
COMPOUNDS: FrozenSet[str] = frozenset("sign signs button".split())

#: Words that begin a new clause after a cry: "wait you are going the wrong way".
CLAUSES: FrozenSet[str] = frozenset(
    "you i he she we they no not and then or but let do because somebody what why how could can would".split()
)
#: Subjects that begin a new clause when one of `VERBS_OF_IT` follows: "stop it is too close".
IMPERSONAL: FrozenSet[str] = frozenset("it that there this".split())
#: Subjects of the clauses that say who asked for what: "cancel what I said".
SUBJECTS: FrozenSet[str] = frozenset("i you".split())
#: Verbs that may follow `IMPERSONAL`.
VERBS_OF_IT: FrozenSet[str] = frozenset("is was will might could can does has looks".split())
#: Words that begin a duration or an end: "until I come back".
LASTS: FrozenSet[str] = frozenset("until till while unless before or".split())
TAIL_WORDS: Mapping[Tail, FrozenSet[str]] = {Tail.UNTIL: LASTS, Tail.LASTING: LASTS | {"for"}}

#: With a verb of speech, "say stop" quotes a cry.
SAYING: FrozenSet[str] = frozenset(
    (
        "say says saying said tell tells telling told ask asks asked shout shouts shouted yell yells cry call "
        "write writes spell read repeat translate announce whisper answer reply mean means word add type print "
        "display draw sing"
    ).split()
)
#: Words that cannot end a name before a cry: in "the next stop", "next" is no name.
NO_NAMES: FrozenSet[str] = frozenset(
    (
        "a an the this that these those my your his her its our their two next last first second final only "
        "nice good short long quick brief bus tram train taxi truck pit door coach metro subway rest full non "
        "toilet coffee deep press push click never not to and or then who what when where why how which if "
        "once until till unless whenever while after before always often hardly barely usually sometimes i we he she "
        "it they do did does will would can could shall should may might must am is are was were be been has "
        "have had at by in on near about into from of for with no"
    ).split()
)
#: Words that begin a warning before a cry: "you're going to hit the wall stop", "too far stop".
WARNINGS: FrozenSet[str] = frozenset(
    ("you your i we that it its there not wrong too watch look mind careful be ouch ow oh no nope hey god help").split()
)
#: Words before a cry that make it part of a command or a quotation: "drive until I say stop".
BLOCKING: FrozenSet[str] = SAYING | {"until", "till", "when", "whenever", "if", "once", "never", "unless"}
#: Words that separate a cry from the words before it: "a bit further okay stop".
SET_OFF: FrozenSet[str] = frozenset("ok okay no nope oh hey whoa wait alright ouch enough".split())

#: Verbs that begin a command.
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
#: Cries that are recognised with one slip of the typist: "stpo".
TYPED: Mapping[str, Kind] = {
    "stop": Kind.STOP,
    "halt": Kind.STOP,
    "abort": Kind.STOP,
    "freeze": Kind.STOP,
    "cancel": Kind.TAKE_BACK,
    "wait": Kind.PAUSE,
}
#: English words that are one slip away from a cry.
ENGLISH: FrozenSet[str] = frozenset("top sop stoop alt hat hal bort feeze reeze ait wat wit await canel".split())
