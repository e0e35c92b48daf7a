# RoboFrameNet: 'make demo' shows it, 'make test' checks it; both install what they need.
SHELL := /bin/bash
.DEFAULT_GOAL := help
ROBOT ?= turtlebot
FILTER ?=
DATA ?=
SMACH ?=
VOICE ?=
FORM ?= standard
ONLY ?=

# The browser that tests the page, unless the tests of another package are run.
.PHONY: browser
browser: setup
	$(if $(filter-out web_console roboframenet_tests,$(FILTER)),,@scripts/setup browser)

.PHONY: help setup stanza agents voice piper build demo run test acceptance reliability record format lint bench screenshots docs install clean

help: ## list the targets
	@grep -hE '^[a-z]+:.*## ' $(MAKEFILE_LIST) | sed -E 's/^([a-z]+):.*## /  make \1|/' | column -t -s '|'

setup: ## install system packages and the Python environment (root or sudo)
	@scripts/setup

stanza: setup ## install Stanza and torch too, which 'runtime: stanza', trainings and some tests need
	@scripts/setup stanza

agents: setup ## install the SDK of the Model Context Protocol, so that agents can command the robot
	@scripts/setup agents

voice: setup ## install Whisper too, which hears spoken commands better than pocketsphinx
	@scripts/setup voice

piper: setup ## install Piper too (GPL), with which the robot speaks in a pleasant voice
	@scripts/setup piper

build: setup ## build the workspace into devel/
	@scripts/build
	$(if $(filter build,$(MAKECMDGOALS)),@echo "[build] built; now 'make demo' or 'make run'")

demo: build ## start simulated robots, say the paper's sentences, show what each robot did
	@scripts/demo

run: build ## keep the stack up for your own 'rostopic pub' (ROBOT=pr2, turtlebot3 or turtlesim for another robot, VOICE=1 to talk to it)
	@scripts/run robot:=$(ROBOT) $(if $(filter-out 0,$(VOICE)),voice:=true)

test: build stanza agents voice browser ## run the tests, at most ten minutes (FILTER=package runs one package's; SMACH=folder: also on that SMACH)
	@SMACH="$(abspath $(SMACH))" scripts/test test $(if $(FILTER),-R $(FILTER))

acceptance: build stanza ## run full tables and corpora, at most 75 minutes (DATA=folder of corpora, FILTER=package)
	@ROBOFRAMENET_DATA="$(abspath $(DATA))" scripts/test acceptance $(if $(FILTER),-R $(FILTER))

reliability: build $(if $(ONLY),$(if $(findstring R14,$(ONLY)),browser),browser) ## attack a running robot, R1 to R18, and print a table (FORM=short, standard or full; ONLY=R2,R5); then the long tests
	@scripts/reliability --form $(FORM) $(if $(ONLY),--only $(ONLY))
	$(if $(ONLY)$(filter short,$(FORM)),,@scripts/test reliability $(if $(FILTER),-R $(FILTER)))

record: build ## record what the parser's models answer to the unit tests (FILTER=package adds what is missing)
	@scripts/record $(FILTER)

format: setup ## format the Python code, and apply the safe fixes of ruff
	@.venv/bin/ruff check --fix-only --quiet . && .venv/bin/ruff format .

lint: build ## check format, rules, types, packages and launch files; change nothing
	@scripts/lint

bench: build stanza agents ## compare with stock Stanza and stock actionlib (EWT=folder: score the parser on the treebank)
	@EWT="$(abspath $(EWT))" HURIC="$(abspath $(HURIC))" scripts/bench

screenshots: build browser ## make the pictures of the page in docs/pictures again, with a browser and simulated robots
	@scripts/screenshots

docs: build ## make the reference of modules and messages into build/docs/html (needs Debian's python3-sphinx)
	@scripts/docs

install: build ## install into install/ (DESTDIR-style: set PREFIX to choose another folder)
	@scripts/install $(PREFIX)

clean: ## remove what was built; the Python environment stays
	@rm -rf build devel install .ros
