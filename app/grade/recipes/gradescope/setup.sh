#!/usr/bin/env bash
# Gradescope, once for each image. The zip to upload holds, at its top:
#   setup.sh, run_autograder   these two files
#   halfway/                   a checkout of Halfway
#   assignment                 one line: an assignment's name, or a TOML file in the zip
#   seed                       one line: a secret of your own, the seed of the hidden points
set -euo pipefail
source="${AUTOGRADER:-/autograder}/source"

apt-get update -q
apt-get install -qy --no-install-recommends libegl1 libgl1 libgl1-mesa-dri python3-venv
python3 -m venv "$source/tools"
"$source/tools/bin/pip" install -q uv
"$source/tools/bin/uv" sync -q --project "$source/halfway" --no-dev --extra flip
chmod 600 "$source/seed"
