"""Lists the frames of the domains: ``PYTHONPATH=tests/unit:$PYTHONPATH python -m home_frames``."""

from offline_pipeline.knowledge import load_knowledge, shipped_domains

from .grounding import groundings


def main() -> None:
    """Print a line for each frame, and the counts."""
    found = groundings(load_knowledge([shipped_domains()]).frames)
    for one in found:
        by = ", ".join(one.servers) or ("other frames" if one.is_composed else "NOTHING")
        print(f"{one.domain:17} {one.frame:29} {by:36} {one.sentences[0] if one.sentences else 'NO SENTENCE'}")
    domains = {one.domain for one in found}
    grounded = {one.domain for one in found if one.is_grounded}
    print(
        f"{len(found)} frames, {sum(one.is_grounded for one in found)} grounded, "
        f"{sum(bool(one.sentences) for one in found)} carried out by a sentence; "
        f"{len(grounded)} of {len(domains)} domains"
    )


if __name__ == "__main__":
    main()
