"""Inflects the verb at the beginning of a clause: "pick up the box" becomes "picked up the box"."""

from dataclasses import dataclass

from mood_matrix.english import gerund_of, participle_of, past_of, third_of


@dataclass(frozen=True)
class Forms:
    """The forms of a verb, or of a clause that begins with it, for the slots of a template."""

    base: str
    third: str
    past: str
    participle: str
    gerund: str


def inflect(verb: str) -> Forms:
    """Return the forms of a verb: one word in lower case."""
    return Forms(verb, third_of(verb), past_of(verb), participle_of(verb), gerund_of(verb))


def inflect_clause(clause: str) -> Forms:
    """Return the forms of a clause whose first word is its verb; its other words do not change."""
    verb, _, rest = clause.partition(" ")
    forms = inflect(verb)
    if verb in ("high", "low"):  # "high five me": the second word is inflected
        second, _, rest = rest.partition(" ")
        five = inflect(second)
        forms = Forms(*(f"{verb} {form}" for form in (five.base, five.third, five.past, five.participle, five.gerund)))
    return Forms(
        *(f"{form} {rest}".strip() for form in (forms.base, forms.third, forms.past, forms.participle, forms.gerund))
    )
