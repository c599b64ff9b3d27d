# SPDX-License-Identifier: BSD-3-Clause
# Shared by the scripts of this folder, which source it: `render` draws their data, the scene
# "atrium" or what their own arguments name.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
mkdir -p output

data=(--scene atrium)
[ "$#" -eq 0 ] || data=("$@")

render() {
  bash Utilities/with-display.sh build/bin/widefov-render "${data[@]}" "$@"
}
