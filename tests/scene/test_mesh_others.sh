#!/bin/sh
# test_mesh_others.sh - meshes as trimesh reads them; what `make mesh-setup` installs, else skipped
# SPDX-License-Identifier: Apache-2.0
set -u
cd "$(dirname "$0")/../.." || exit 1
python=$BUILD/venv/mesh/bin/python
if [ ! -e "$BUILD/sphaera_mesh.so" ]; then
    echo "ok 1 - # SKIP built without assimp: make mesh-setup"
elif ! "$python" -c 'import trimesh' 2>/dev/null; then
    echo "ok 1 - # SKIP there is no trimesh: make mesh-setup"
else
    exec "$python" tests/scene/mesh_others.py "$SPHAERA" "$TMP"
fi
echo 1..1
