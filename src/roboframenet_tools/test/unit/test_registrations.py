"""What the doctor says of registrations."""

from roboframenet_tools.registrations import registration_findings


def test_registration_for_a_frame_that_no_file_describes_is_found() -> None:
    (finding,) = registration_findings(["broadcasting"], [("brodcasting", "radio", True)])
    assert finding.subject == "radio"
    assert "'brodcasting', which no file describes" in finding.found
    assert finding.advice == "did you mean 'broadcasting'?"


def test_dead_server_is_found_once() -> None:
    (finding,) = registration_findings(["a", "b"], [("a", "dead", False), ("b", "dead", False), ("a", "well", True)])
    assert (finding.subject, bool(finding.advice)) == ("dead", True)


def test_registrations_without_fault() -> None:
    (finding,) = registration_findings(["a"], [("a", "one", True), ("a", "two", True)])
    assert not finding.advice
    assert finding.found.startswith("2")
