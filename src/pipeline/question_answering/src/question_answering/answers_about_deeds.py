"""Answers to questions about what the robot did, does and will do, and why."""

from typing import Callable, Dict, Optional, Sequence

from question_answering.robot_knowledge import Deed, Outcome, RobotKnowledge
from question_answering.wording import Arguments
from typed_arguments import TypedArgument
from word_classes import word_class

#: How the reply to a command begins that was carried out.
_DONE = "Done."
#: Deeds that an answer names.
MOST_NAMED = 3
_GENERAL = frozenset(["doing", "done"])
_PRONOUNS = word_class("pronouns")
_SMALL = word_class("determiners") | word_class("place_prepositions") | frozenset(["do", "to"])


def reason(arguments: Arguments, known: RobotKnowledge) -> str:
    """Say why: because somebody asked for it, or what went wrong."""
    deed = arguments.get("deed")
    about = _deed_of(deed, known.deeds) if deed is not None else None
    if deed is not None and about is None and not _is_general(deed):
        if known.doing and _is_about(deed, known.doing):
            return f'You asked me to: "{known.doing}".'
        return "I do not remember anything like that."
    if about is None and known.doing and not _is_last_stopped(known.deeds):
        return f'I am still carrying out "{known.doing}", because you asked me to.'
    about = about or _last_ended(known.deeds)
    if about is None:
        return "I have not done anything yet."
    if deed is None and about.outcome is Outcome.DONE:
        return f'I carried out "{about.text}", because you asked me to.{_what_else(about)}'
    return _why(about, known.deeds)


def stopping(_: Arguments, known: RobotKnowledge) -> str:
    """Say who stopped the robot last, in what, and what it has done since; or that nobody did."""
    if known.doing and not _is_last_stopped(known.deeds):
        return f'I have not stopped: I am carrying out "{known.doing}".'
    last, place = _last_ended(known.deeds), _place_of_last_stop(known.deeds)
    if place is None and last is None:
        return "I have not done anything yet."
    if place is None and last is not None:
        if last.outcome is Outcome.DONE:
            return f'Nobody stopped me: I carried out "{last.text}" to its end.{_what_else(last)}'
        return _why(last, known.deeds)
    assert place is not None
    # What a stop ends may get its reply before it or after it.
    around = [*known.deeds[max(0, place - 1) : place], *known.deeds[place + 1 : place + 2]]
    ended = next((one for one in around if one.outcome is Outcome.SUPERSEDED and not one.is_stop), None)
    doing = f'I was carrying out "{ended.text}", and then you' if ended is not None else "You"
    since = [one for one in known.deeds[place + 1 :] if one is not ended]
    done = f' Since then, I have carried out "{since[-1].text}".' if since and since[-1].outcome is Outcome.DONE else ""
    return f'{doing} said "{known.deeds[place].text}".{done}'


def _place_of_last_stop(found: Sequence[Deed]) -> Optional[int]:
    return next((place for place in reversed(range(len(found))) if found[place].is_stop), None)


def _what_else(deed: Deed) -> str:
    """Return what the reply said beyond "Done.": what was not done, and why."""
    rest = deed.sentence[len(_DONE) :].strip() if deed.sentence.startswith(_DONE) else ""
    return f" {rest}" if rest else ""


def _why(deed: Deed, deeds: Sequence[Deed]) -> str:
    if deed.outcome is Outcome.DONE:
        return f'You asked me to: "{deed.text}".'
    if deed.outcome is Outcome.SUPERSEDED:
        later = deeds[deeds.index(deed) + 1 :]
        after = next((other for other in later if other.is_stop), None) or next(iter(later), None)
        if after is not None:
            return f'I was carrying out "{deed.text}", and then you said "{after.text}".'
        return f'Something else took the place of "{deed.text}".'
    how = {Outcome.FAILED: "did not work", Outcome.REFUSED: "was not done", Outcome.ASKED: "is still open"}
    return f'"{deed.text}" {how[deed.outcome]}: {deed.sentence}'


def next_step(_: Arguments, known: RobotKnowledge) -> str:
    """Say what comes after what the robot does now."""
    if not known.doing:
        return "Nothing: I am doing nothing at the moment."
    if not known.next_steps:
        return f'Nothing after "{known.doing}", as far as I know.'
    return f"Next: {', then '.join(known.next_steps[:MOST_NAMED])}."


def deeds(_: Arguments, known: RobotKnowledge) -> str:
    """Say what was done last, and how it ended."""
    last = _last_ended(known.deeds)
    doing = f' I am carrying out "{known.doing}" now.' if known.doing else ""
    if last is None:
        return doing.strip() or "I have not done anything yet."
    if last.outcome is Outcome.DONE:
        return f'I carried out "{last.text}".{_what_else(last)}{doing}'
    if last.outcome is Outcome.SUPERSEDED:
        return f'I began "{last.text}", and did not finish it.{doing}'
    return f'I did not do it: "{last.text}". {last.sentence}{doing}'


def _last_ended(found: Sequence[Deed]) -> Optional[Deed]:
    """Return the last command that is no cry: after a stop, what it ended."""
    return next((deed for deed in reversed(found) if not deed.is_stop), None)


def _is_last_stopped(found: Sequence[Deed]) -> bool:
    return bool(found) and found[-1].is_stop


def _is_general(deed: TypedArgument) -> bool:
    """Whether words name no deed of their own: "do it", "do that", "that"."""
    words = set(deed.text.lower().split()) - _SMALL
    return words <= _PRONOUNS | _GENERAL


def _deed_of(deed: TypedArgument, found: Sequence[Deed]) -> Optional[Deed]:
    if _is_general(deed):
        return None
    return next((one for one in reversed(found) if _is_about(deed, one.text)), None)


def _is_about(deed: TypedArgument, text: str) -> bool:
    """Whether a command has all content words of a deed: "go to the kitchen" of "Please go to the kitchen."."""
    said = {_stem(word.strip(".,!?")) for word in text.lower().split()}
    asked = {_stem(word) for word in deed.text.lower().split()} - _SMALL
    return bool(asked) and asked <= said


def _stem(word: str) -> str:
    """Return a word without the ending of a participle: "mov" for "moving" and "move"."""
    return (word[:-3] if word.endswith("ing") and len(word) > 5 else word).rstrip("e")


ABOUT_DEEDS: Dict[str, Callable[[Arguments, RobotKnowledge], str]] = {
    "question_of_reason": reason,
    "question_of_stopping": stopping,
    "question_of_next_step": next_step,
    "question_of_deeds": deeds,
}
