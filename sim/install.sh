#!/bin/sh
# install.sh - puts library, header, tool, pages and completion into a folder, or takes them away
# SPDX-License-Identifier: Apache-2.0
#
# usage: PREFIX=... DESTDIR=... VERSION=... REQUIRES=... BUILD=... \
#            sim/install.sh install|uninstall|pc
# DESTDIR stands before PREFIX, for packages. install puts there what BUILD and BUILD/dist have, and
# sphaera.pc, which names PREFIX alone; pc writes that into BUILD/dist. uninstall removes what
# install put there, and no folder but sphaera's own. REQUIRES: packages of a static library.
set -eu
cd "$(dirname "$0")/.."
dist=$BUILD/dist to=$DESTDIR$PREFIX shared=libsphaera.so.$VERSION major=${VERSION%%.*}
bash=$to/share/bash-completion/completions zsh=$to/share/zsh/site-functions

write_pc() { # quoted as pkg-config reads it: Cflags and Libs are words
    prefix=$(printf '%s' "$PREFIX" | sed 's/[^A-Za-z0-9_./+,:=@%-]/\\&/g')
    cat >"$1" <<END
prefix=$prefix
libdir=\${prefix}/lib
includedir=\${prefix}/include

Name: sphaera
Description: golden model of a ray tracer in hardware
Version: $VERSION
Cflags: -I\${includedir}
Libs: -L\${libdir} -lsphaera
Requires.private: $REQUIRES
Libs.private: -pthread -lstdc++ -lm
END
}

# What find_package(sphaera) takes: sphaera::sphaera, and with COMPONENTS static sphaera::static.
write_cmake() { # folder
    cat >"$1/sphaera-config.cmake" <<END
get_filename_component(_sphaera "\${CMAKE_CURRENT_LIST_DIR}/../../.." ABSOLUTE)
if(NOT TARGET sphaera::sphaera)
  add_library(sphaera::sphaera SHARED IMPORTED)
  set_target_properties(sphaera::sphaera PROPERTIES
    IMPORTED_LOCATION "\${_sphaera}/lib/$shared" IMPORTED_SONAME libsphaera.so.$major
    INTERFACE_INCLUDE_DIRECTORIES "\${_sphaera}/include")
endif()
if("static" IN_LIST sphaera_FIND_COMPONENTS AND NOT TARGET sphaera::static)
  include(CMakeFindDependencyMacro)
  find_dependency(PkgConfig)
  find_dependency(Threads)
  pkg_check_modules(SPHAERA_NEEDS REQUIRED IMPORTED_TARGET $REQUIRES)
  add_library(sphaera::static STATIC IMPORTED)
  set_target_properties(sphaera::static PROPERTIES
    IMPORTED_LOCATION "\${_sphaera}/lib/libsphaera.a"
    INTERFACE_INCLUDE_DIRECTORIES "\${_sphaera}/include"
    INTERFACE_LINK_LIBRARIES "PkgConfig::SPHAERA_NEEDS;Threads::Threads;stdc++;m")
endif()
set(sphaera_static_FOUND TRUE)
END
    cat >"$1/sphaera-config-version.cmake" <<END
set(PACKAGE_VERSION $VERSION)
if(PACKAGE_FIND_VERSION_MAJOR STREQUAL "$major" AND
   NOT PACKAGE_FIND_VERSION VERSION_GREATER $VERSION)
  set(PACKAGE_VERSION_COMPATIBLE TRUE)
endif()
if(PACKAGE_FIND_VERSION VERSION_EQUAL $VERSION)
  set(PACKAGE_VERSION_EXACT TRUE)
endif()
END
}

case $1 in
pc) write_pc "$dist/sphaera.pc" ;;
install)
    install -d "$to/bin" "$to/include/sphaera" "$to/lib/sphaera" "$to/lib/pkgconfig" \
        "$to/lib/cmake/sphaera" "$to/share/sphaera/vip" \
        "$to/share/man/man1" "$bash" "$zsh"
    install -m 755 "$BUILD/sphaera" "$to/bin"
    for part in image mesh view; do # each may be missing
        [ ! -e "$BUILD/sphaera_$part.so" ] ||
            install -m 755 "$BUILD/sphaera_$part.so" "$to/lib/sphaera/$part.so"
    done
    install -m 644 cmodel/sphaera/sphaera.h cmodel/sphaera/sphaera.hpp "$to/include/sphaera"
    install -m 644 tb/vip/*.sv tb/vip/*.py "$to/share/sphaera/vip"
    install -m 755 "$dist/$shared" "$to/lib"
    ln -sf "$shared" "$to/lib/libsphaera.so.$major"
    ln -sf "$shared" "$to/lib/libsphaera.so"
    install -m 644 "$dist/libsphaera.a" "$to/lib"
    write_pc "$to/lib/pkgconfig/sphaera.pc"
    write_cmake "$to/lib/cmake/sphaera"
    chmod 644 "$to/lib/pkgconfig/sphaera.pc" "$to"/lib/cmake/sphaera/*.cmake
    install -m 644 "$dist"/man/*.1 "$to/share/man/man1"
    install -m 644 "$dist/complete.bash" "$bash/sphaera"
    install -m 644 "$dist/complete.zsh" "$zsh/_sphaera"
    ;;
uninstall)
    for file in bin/sphaera lib/sphaera/image.so lib/sphaera/mesh.so lib/sphaera/view.so \
        include/sphaera/sphaera.h include/sphaera/sphaera.hpp \
        lib/cmake/sphaera/sphaera-config.cmake lib/cmake/sphaera/sphaera-config-version.cmake \
        "lib/$shared" "lib/libsphaera.so.$major" lib/libsphaera.so lib/libsphaera.a \
        lib/pkgconfig/sphaera.pc; do
        rm -f "$to/$file"
    done
    rm -f "$bash/sphaera" "$zsh/_sphaera"
    for page in "$dist"/man/*.1; do rm -f "$to/share/man/man1/${page##*/}"; done
    for file in tb/vip/*.sv tb/vip/*.py; do rm -f "$to/share/sphaera/vip/${file##*/}"; done
    rmdir "$to/include/sphaera" "$to/lib/sphaera" "$to/lib/cmake/sphaera" "$to/share/sphaera/vip" \
        "$to/share/sphaera" 2>/dev/null || :
    ;;
*)
    sed -n 's/^# usage: /usage: /p' "$0" >&2
    exit 2
    ;;
esac
