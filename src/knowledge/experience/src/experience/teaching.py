"""What people say of deeds and of servers, and what the robot answers."""

from dataclasses import dataclass
from typing import Callable, Dict, FrozenSet, Mapping, Optional, Tuple

from experience.known import Aspect, Subject
from experience.memory import Memory
from experience.rules import Rule, RuleKind, is_named, words_of
from experience.trial import Judgement, Outcome, Trial
from roboframenet_ros.spoken_text import join_with_and, with_capital
from typed_arguments import TypedArgument

#: Rules that an answer names.
_MOST_NAMED = 5


@dataclass(frozen=True)
class Answer:
    """What is said, and what has changed in the memory and must be stored.

    Attributes:
        sentence: for the person
        judged: a command, and what was said of it
        kept: new rules
        dropped: rules that hold no longer
    """

    sentence: str
    judged: Optional[Tuple[str, Judgement]] = None
    kept: Tuple[Rule, ...] = ()
    dropped: Tuple[Rule, ...] = ()

    @property
    def is_change(self) -> bool:
        """Whether something must be stored."""
        return bool(self.judged or self.kept or self.dropped)


@dataclass(frozen=True)
class Asked:
    """What a person said, and what it is answered from.

    Attributes:
        memory: trials and rules
        arguments: by element
        servers: names of all servers that are registered, by frame
        reasons: of commands: why the arbitrator asked a server first
        said: the words of the person; empty when unknown
        now_s: ROS time
    """

    memory: Memory
    arguments: Mapping[str, TypedArgument]
    servers: Mapping[str, FrozenSet[str]]
    reasons: Mapping[str, str]
    said: str = ""
    now_s: float = 0.0

    @property
    def server(self) -> str:
        """The words that name servers, without a determiner."""
        words = self.arguments.get("server", TypedArgument()).text.split()
        return " ".join(
            words[1:] if len(words) > 1 and words_of(words[0])[:1] != words_of(" ".join(words))[:1] else words
        )

    def meant(self) -> Dict[str, FrozenSet[str]]:
        """Return the registered servers of that name, by frame."""
        found = {name: frozenset(one for one in of if is_named(self.server, one)) for name, of in self.servers.items()}
        return {name: of for name, of in found.items() if of}

    def purpose(self) -> Tuple[str, str]:
        """Return the frame and the noun that a purpose names; both are empty without one."""
        argument = self.arguments.get("purpose")
        if argument is None or not argument.text:
            return "", ""
        frame = "_".join(argument.text.lower().split())
        return (frame, "") if frame in self.servers else ("", argument.lemma or words_of(argument.text)[-1])


def praise(asked: Asked) -> Answer:
    """Count what succeeded in the last command as right."""
    return _judge(asked, Judgement.RIGHT)


def criticize(asked: Asked) -> Answer:
    """Count what succeeded in the last command as wrong."""
    return _judge(asked, Judgement.WRONG)


def _judge(asked: Asked, judgement: Judgement) -> Answer:
    deed = asked.memory.last_deed()
    if not deed:
        return Answer("Thank you, but I remember nothing that I did." if judgement is Judgement.RIGHT else _NO_DEED)
    said = deed[-1].said.strip(" .!?")
    judged = asked.memory.judge(judgement)
    if not judged:
        return Answer(f'"{said}" did not work anyway.')
    servers = join_with_and(dict.fromkeys(name_of(trial.server) for trial in judged))
    told = (deed[0].command_id, judgement)
    if judgement is Judgement.RIGHT:
        return Answer(f'Thank you. I remember that {servers} did "{said}" well.', told)
    return Answer(f'I am sorry. I remember that {servers} did "{said}" wrong.', told)


_NO_DEED = "I remember nothing that I did."
_NO_RULES = "I have no rules about my parts."
#: Which rules are meant, by the constant that a lexical unit has in place of a server.
_SERVERS_OF_RULES = {"all": slice(None), "last": slice(-1, None)}


def prefer(asked: Asked) -> Answer:
    """Ask some servers first, the next time or always; without a purpose, for what was done last."""
    is_once = asked.arguments.get("frequency", TypedArgument()).text == "once"
    frame, thing = asked.purpose()
    if not frame and not thing and is_once:
        deed = asked.memory.last_deed()
        frame = next((trial.frame for trial in deed if is_able(asked, trial.frame)), "")
    return _teach(asked, RuleKind.FIRST, frame, thing, is_once=is_once)


def is_able(asked: Asked, frame: str) -> bool:
    """Whether one of the servers that are meant is registered for a frame."""
    return frame in asked.meant()


def avoid(asked: Asked) -> Answer:
    """Never use some servers, for a purpose or for everything."""
    frame, thing = asked.purpose()
    return _teach(asked, RuleKind.NEVER, frame, thing, is_once=False)


def _teach(asked: Asked, kind: RuleKind, frame: str, thing: str, *, is_once: bool) -> Answer:
    if not asked.meant():
        return Answer(f'I have no server that is called "{asked.server}".')
    rule = asked.memory.teach(
        kind, asked.server, frame=frame, thing=thing, is_once=is_once, said=asked.said, now_s=asked.now_s
    )
    if rule is None:
        return Answer("I have too many rules already. Take some back first.")
    opposite = RuleKind.FIRST if kind is RuleKind.NEVER else RuleKind.NEVER
    old = tuple(
        one
        for one in asked.memory.rules
        if one.kind is opposite and (one.server, one.frame, one.thing) == (rule.server, rule.frame, rule.thing)
    )
    asked.memory.take_back(old)
    return Answer(f"All right: {rule.sentence}.", kept=(rule,), dropped=old)


def take_back(asked: Asked) -> Answer:
    """Drop the rules about some servers, for a purpose or all of them; or all rules, or the last one."""
    frame, thing = asked.purpose()
    about = frozenset(words_of(asked.server))
    rules = asked.memory.rules
    found = tuple(
        rule
        for rule in rules
        if about <= frozenset(words_of(rule.server)) and frame in ("", rule.frame) and thing in ("", rule.thing)
    )
    if asked.server in _SERVERS_OF_RULES:
        found = rules[_SERVERS_OF_RULES[asked.server]]
        if not found:
            return Answer(_NO_RULES)
    if not found:
        return Answer(f'I have no rule about "{asked.server}".')
    asked.memory.take_back(found)
    return Answer(f"All right, this holds no longer: {join_with_and(rule.sentence for rule in found)}.", dropped=found)


def tell_rules(asked: Asked) -> Answer:
    """Name the rules."""
    rules = asked.memory.rules
    if not rules:
        return Answer(_NO_RULES)
    more = f", and {len(rules) - _MOST_NAMED} more" if len(rules) > _MOST_NAMED else ""
    return Answer(f"My rules are: {'; '.join(rule.sentence for rule in rules[:_MOST_NAMED])}{more}.")


def tell_choice(asked: Asked) -> Answer:
    """Say why a server was used the last time."""
    trial = next((one for one in reversed(asked.memory.trials) if is_named(asked.server, one.server)), None)
    if trial is None:
        return Answer(f'I remember no deed of "{asked.server}".')
    before = [
        one
        for one in asked.memory.trials
        if one.command_id == trial.command_id and one.outcome is Outcome.FAILED and one.server != trial.server
    ]
    reason = asked.reasons.get(trial.command_id, "")
    if reason:
        return Answer(reason)
    if before:
        return Answer(f"{with_capital(name_of(before[-1].server))} had failed: it {before[-1].reason.rstrip('.')}.")
    return Answer(f"{_figures(asked.memory, trial)} That did not decide: my policy or chance did.")


def _figures(memory: Memory, trial: Trial) -> str:
    subject = Subject(trial.frame, trial.server, trial.circumstances.robot)
    record = memory.experience.records.get(subject)
    cell = record.cells.get((Aspect.NOTHING, "")) if record is not None else None
    if cell is None:
        return f"I remember nothing else of {name_of(trial.server)}."
    count = cell.recent.count(True)
    return f"{with_capital(name_of(trial.server))} succeeded {count} of {len(cell.recent)} times."


def name_of(server: str) -> str:
    """Return the name of a server for a person."""
    return server.lstrip("/")


#: By the name of the frame.
TEACHING: Dict[str, Callable[[Asked], Answer]] = {
    "praising_a_deed": praise,
    "criticizing_a_deed": criticize,
    "preferring_a_server": prefer,
    "avoiding_a_server": avoid,
    "taking_back_a_rule": take_back,
    "question_of_rules": tell_rules,
    "question_of_choice": tell_choice,
}
