"""One base for several servers."""

import threading

from move_action_server.base_claim import BaseClaims
from roboframenet_testing import wait_until


def test_free_base_is_granted_at_once():
    claim = BaseClaims().claim(timeout_s=0.0)
    assert claim is not None and not claim.is_revoked


def test_newer_claim_revokes_and_waits_for_the_release():
    claims = BaseClaims()
    first = claims.claim(timeout_s=0.0)
    granted = []
    thread = threading.Thread(target=lambda: granted.append(claims.claim(timeout_s=10.0)))
    thread.start()
    wait_until(lambda: first.is_revoked)
    assert granted == []
    first.release()
    thread.join(10.0)
    assert granted[0] is not None and not granted[0].is_revoked


def test_holder_that_does_not_let_go_makes_the_newer_one_fail():
    claims = BaseClaims()
    first = claims.claim(timeout_s=0.0)
    assert claims.claim(timeout_s=0.0) is None
    first.release()
    assert claims.claim(timeout_s=0.0) is not None


def test_of_two_that_wait_the_newest_gets_the_base():
    claims = BaseClaims()
    first = claims.claim(timeout_s=0.0)
    results = {}
    older = threading.Thread(target=lambda: results.update(older=claims.claim(timeout_s=10.0)))
    older.start()
    wait_until(lambda: claims.newest_ticket == 2)
    newer = threading.Thread(target=lambda: results.update(newer=claims.claim(timeout_s=10.0)))
    newer.start()
    older.join(10.0)
    assert results == {"older": None}
    first.release()
    newer.join(10.0)
    assert results["newer"] is not None


def test_cancelled_wait_ends():
    claims = BaseClaims()
    claims.claim(timeout_s=0.0)
    assert claims.claim(timeout_s=60.0, is_cancelled=lambda: True) is None


def test_second_release_frees_nothing():
    claims = BaseClaims()
    first = claims.claim(timeout_s=0.0)
    first.release()
    second = claims.claim(timeout_s=0.0)
    first.release()
    assert claims.claim(timeout_s=0.0) is None
    second.release()
