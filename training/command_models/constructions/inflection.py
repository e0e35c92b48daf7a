"""Forms of verbs, for every mood: what ``words`` has for commands, and the irregular verbs of all units."""

from typing import Dict, Tuple

from command_models import words
from command_models.trees import Node

# lemma:past:participle; one form for both where only one is given
_IRREGULAR: Dict[str, Tuple[str, str]] = {}
for _entry in """
    be:was:been bear:bore:borne beat:beat:beaten become:became:become begin:began:begun bend:bent bid:bid bind:bound
    break:broke:broken bring:brought build:built buy:bought catch:caught choose:chose:chosen come:came:come creep:crept
    cut:cut deal:dealt dig:dug do:did:done draw:drew:drawn drink:drank:drunk drive:drove:driven eat:ate:eaten
    fall:fell:fallen feed:fed feel:felt find:found fling:flung fly:flew:flown forget:forgot:forgotten
    freeze:froze:frozen get:got give:gave:given go:went:gone grow:grew:grown hang:hung have:had hear:heard
    hide:hid:hidden hit:hit hold:held keep:kept know:knew:known lay:laid lead:led leave:left lend:lent let:let
    lie:lay:lain light:lit lose:lost make:made meet:met put:put quit:quit read:read ride:rode:ridden ring:rang:rung
    rise:rose:risen run:ran:run say:said see:saw:seen seek:sought sell:sold send:sent set:set shake:shook:shaken
    shoot:shot show:showed:shown shut:shut sing:sang:sung sit:sat sleep:slept slide:slid speak:spoke:spoken spin:spun
    split:split spread:spread stand:stood steal:stole:stolen stick:stuck sweep:swept swim:swam:swum swing:swung
    take:took:taken teach:taught tell:told think:thought throw:threw:thrown understand:understood wake:woke:woken
    wear:wore:worn withdraw:withdrew:withdrawn write:wrote:written untie:untied""".split():
    _lemma, _past, *_participle = _entry.split(":")
    _IRREGULAR[_lemma] = (_past, _participle[0] if _participle else _past)
_DOUBLING = frozenset(
    """beg bin clip dim drag fit forget get grip hem hum jog knit knot let nod pet plan quit regret rip run scrub ship
    shop sip slam slap slip slit snip spot strap strip stun swap swim tip trap tug unplug unzip whip wrap begin
    skin""".split()
)


def _stem(lemma: str) -> str:
    return lemma + lemma[-1] if lemma in _DOUBLING else lemma


def past_form(lemma: str) -> str:
    """Return the past tense."""
    return _IRREGULAR[lemma][0] if lemma in _IRREGULAR else _regular(lemma)


def participle_form(lemma: str) -> str:
    """Return the past participle."""
    return _IRREGULAR[lemma][1] if lemma in _IRREGULAR else _regular(lemma)


def _regular(lemma: str) -> str:
    if lemma in _DOUBLING:
        return _stem(lemma) + "ed"
    return words.past(lemma).form


def ing_form(lemma: str) -> str:
    """Return the form in "-ing"."""
    return _stem(lemma) + "ing" if lemma in _DOUBLING else words.ing(lemma)


def third_form(lemma: str) -> str:
    """Return the third person singular."""
    return {"be": "is", "have": "has"}.get(lemma) or words.third(lemma)


# The features of generated words train no head, so they are few.
def past(lemma: str) -> Node:
    return Node(past_form(lemma), lemma, "VERB", "VBD", "Mood=Ind|Tense=Past|VerbForm=Fin")


def perfect(lemma: str) -> Node:
    return Node(participle_form(lemma), lemma, "VERB", "VBN", "Tense=Past|VerbForm=Part")


def passive(lemma: str) -> Node:
    return Node(participle_form(lemma), lemma, "VERB", "VBN", "Tense=Past|VerbForm=Part|Voice=Pass")


def progressive(lemma: str) -> Node:
    return Node(ing_form(lemma), lemma, "VERB", "VBG", "Tense=Pres|VerbForm=Part")


def gerund(lemma: str) -> Node:
    return Node(ing_form(lemma), lemma, "VERB", "VBG", "VerbForm=Ger")


def present(lemma: str) -> Node:
    return Node(lemma, lemma, "VERB", "VBP", "Mood=Ind|Tense=Pres|VerbForm=Fin")


def third(lemma: str) -> Node:
    return Node(third_form(lemma), lemma, "VERB", "VBZ", "Mood=Ind|Number=Sing|Person=3|Tense=Pres|VerbForm=Fin")


imperative, infinitive = words.imperative, words.infinitive
