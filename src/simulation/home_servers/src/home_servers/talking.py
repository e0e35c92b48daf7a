"""Frames of speaking with people and of gestures."""

from typing import Dict, List

from home_servers.body import CannotDo
from home_servers.looking import described, sentence
from home_servers.memory import Known, is_whole
from home_servers.skills import SPEAKERS, Skill, Skills, argument, said
from home_servers.telling import told
from typed_arguments import FilledFrame, Source, TypedArgument
from word_classes import word_class

_OF_SPEAKER = word_class("words_of_the_speaker") | word_class("speaker_subjects") | word_class("speaker_objects")


def greet(skills: Skills, frame: FilledFrame) -> None:
    """Go to somebody and greet them, one by one."""
    near = argument(frame, "place") if said(frame, "place") else None
    for person in skills.persons(argument(frame, "addressee"), near=near):
        skills.say(f"Hello, {person.name}.")


def part(skills: Skills, frame: FilledFrame) -> None:
    """Go to somebody, wave and say goodbye."""
    words = argument(frame, "addressee")
    person = skills.person(words) if words.text else skills.speaker()
    skills.attempt("gesture", value="wave", goal=person.id)
    skills.say(f"Goodbye, {person.name}.")


def meet(skills: Skills, frame: FilledFrame) -> None:
    """Go to somebody and introduce oneself, one by one."""
    near = argument(frame, "place") if said(frame, "place") else None
    for person in skills.persons(argument(frame, "person"), near=near):
        skills.say(f"Hello, {person.name}. I am the robot of this home.")


def introduce(skills: Skills, frame: FilledFrame) -> None:
    """Introduce oneself, or somebody to somebody."""
    who, whom = argument(frame, "individual"), argument(frame, "addressee")
    if who.text.lower() in ("yourself", "you"):
        if whom.text:
            skills.person(whom)
        skills.say("I am the robot of this home. I bring things, and do what I am told.")
        return
    first = skills.find(who, "person")
    second = skills.person(whom) if whom.text else skills.speaker()
    skills.say(f"{second.name}, this is {first.name}.")


def tell(skills: Skills, frame: FilledFrame) -> None:
    """Find out what is to be told, go to whom it is for, and tell it."""
    whom = argument(frame, "addressee")
    message = argument(frame, "message")
    text = told(skills, message)
    is_asked_by_them = not whom.text or whom.text.lower() in SPEAKERS
    # "I" in what somebody said is not the robot.
    is_of_speaker = message.source is Source.SAID and not _OF_SPEAKER.isdisjoint(message.text.lower().split())
    opening = "I was asked to tell you: " if is_of_speaker and not is_asked_by_them else ""
    if is_whole(whom):
        _tell_each(skills, whom, text, opening)
        return
    person = _hearer(skills, whom)
    skills.answer(
        sentence(f"{person.name}, {opening}{text}"),
        reply=sentence(text if is_asked_by_them else f"I told {person.name}: {text}"),
    )


def _hearer(skills: Skills, whom: TypedArgument) -> Known:
    """Return whom something is said to, and be with them: whoever was named, or else whom the robot is with."""
    if whom.text and whom.text.lower() not in SPEAKERS:
        return skills.person(whom)
    person = skills.speaker() if whom.text else skills.company() or skills.speaker()
    skills.join(person)
    return person


def _tell_each(skills: Skills, whom: TypedArgument, text: str, opening: str = "") -> None:
    """Go to each person of a kind, tell them, and say who they were."""
    names: List[str] = []
    for person in skills.persons(whom):
        skills.say(sentence(f"{person.name}, {opening}{text}"))
        names.append(person.name)
    skills.answers.append(sentence(f"I told {', '.join(names)}: {text}"))


def say(skills: Skills, frame: FilledFrame) -> None:
    """Say something, to somebody when they are named."""
    message, whom = argument(frame, "message"), argument(frame, "addressee")
    text = told(skills, message)
    if is_whole(whom):
        _tell_each(skills, whom, text)
        return
    if whom.text or skills.company() is not None:
        text = f"{_hearer(skills, whom).name}, {text}"
    skills.say(sentence(text))


def remind(skills: Skills, frame: FilledFrame) -> None:
    """Go to somebody and remind them."""
    person = skills.person(argument(frame, "addressee"))
    skills.say(f"{person.name}, do not forget {argument(frame, 'topic').text}.")


def ask(skills: Skills, frame: FilledFrame) -> None:
    """Ask somebody, and say what they answer to whoever speaks."""
    person = skills.person(argument(frame, "addressee"))
    message = argument(frame, "message")
    replies = skills.say(f"{person.name}, {_question(message.text)}?")
    if replies:
        skills.answer(f"{replies[0][0]} says: {replies[0][1]}.")


def _question(text: str) -> str:
    words = text.lower()
    for pronoun in ("her ", "his ", "their "):
        if words.startswith(pronoun):
            return f"what is your {text[len(pronoun) :]}"
    return f"what about {text}"


def request(skills: Skills, frame: FilledFrame) -> None:
    """Ask somebody to do something."""
    person = skills.person(argument(frame, "addressee"))
    words = argument(frame, "message").text
    words = words[3:] if words.lower().startswith("to ") else words
    skills.say(f"{person.name}, please {words}.")


def describe(skills: Skills, frame: FilledFrame) -> None:
    """Look at something, and say how it looks."""
    item, whom = argument(frame, "item"), argument(frame, "addressee")
    one = _thing_or_room(skills, item)
    skills.go(one.id)
    skills.attempt("look")
    now = skills.memory.get(one.id) or one
    if one.sort == "room":
        names = sorted({thing.the_name for thing in skills.memory.all() if thing.room == one.id})
        words = f"In {one.the_name} I see {', '.join(names)}."
    else:
        words = sentence(f"{described(skills, now)}; {now.it_is} {' and '.join(now.attributes) or now.category}")
    if whom.text:
        skills.person(whom)
    skills.answer(words)


def _thing_or_room(skills: Skills, item: TypedArgument) -> Known:
    if item.text.lower() in ("the room", "the view", "this room"):
        here = skills.room_here()
        if here is not None:
            return here
    return skills.find(item)


def report(skills: Skills, frame: FilledFrame) -> None:
    """Say what the robot has seen."""
    whom, topic = argument(frame, "addressee"), argument(frame, "topic")
    text = told(skills, topic) if topic.text else ""
    person = _hearer(skills, whom)
    seen = len([one for one in skills.memory.all("thing") if one.relation])
    known = text or f"I am well, and know where {seen} things are"
    skills.answer(sentence(f"{person.name}, {known}"), reply=sentence(known))


def answer(skills: Skills, frame: FilledFrame) -> None:
    """Answer: the robot goes to who asks, and listens; the phone is picked up."""
    words = argument(frame, "trigger")
    found = skills.memory.find(words, "furniture", "thing")
    if found:
        skills.attempt("press", theme=found[0].id)
        skills.say("Hello, this is the robot of this home.")
        return
    person = _hearer(skills, argument(frame, "addressee"))
    skills.say(f"{person.name}, what is your question? Please ask.")


def gesture(value: str, target: str = "") -> Skill:
    """Return the skill of a gesture, towards what an element names."""

    def act(skills: Skills, frame: FilledFrame) -> None:
        goal = ""
        if target and said(frame, target):
            one = skills.find(argument(frame, target))
            goal = one.id
            if one.sort == "person":
                skills.go(goal, reach_m=1.0)
            skills.attempt("face", goal=goal)
        skills.attempt("gesture", value=value, goal=goal)

    return act


def play(skills: Skills, frame: FilledFrame) -> None:
    """Play music on the radio; games and instruments are not for this robot."""
    words = argument(frame, "performance")
    noun = (words.lemma or words.text).lower()
    if not any(word in noun for word in ("song", "music", "radio")) or said(frame, "instrument"):
        raise CannotDo(f"I cannot play {words.text}.")
    skills.attempt("switch", theme=skills.find(TypedArgument(text="radio"), "furniture").id, value="on")


#: Frames of greetings with the arms, as gestures.
PROPS: Dict[str, Skill] = {
    "high_fiving": gesture("high five", "partner"),
    "low_fiving": gesture("low five", "partner"),
    "pounding": gesture("fist bump", "partner"),
    "hugging": gesture("hug", "partner"),
}
