"""Every frame of the domains is carried out in the home by a sentence of a test."""

from home_frames.grounding import groundings, servers_by_frame

from offline_pipeline.knowledge import load_knowledge, shipped_domains

FRAMES = load_knowledge([shipped_domains()]).frames


#: No server that is shipped watches what others do.
UNWATCHED = frozenset(["condition_of_act"])


def test_every_frame_is_carried_out_by_a_sentence():
    found = [one for one in groundings(FRAMES) if one.frame not in UNWATCHED]
    assert [one.frame for one in found if not one.is_grounded] == []
    assert [one.frame for one in found if not one.sentences] == []


def test_every_domain_is_grounded():
    found = groundings(FRAMES)
    assert {one.domain for one in found if one.is_grounded} == {one.domain for one in found}


def test_servers_are_those_of_frames():
    assert set(servers_by_frame()) <= set(FRAMES)
