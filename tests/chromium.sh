#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# Prints the path of the browser that tests use; fails where there is none. The shell is Chromium without a window, which takes half the
# time; thorough tests take the browser that users have.
shell=chromium-headless-shell
[ -z "${ORISPLINE_THOROUGH-}" ] || shell=
for browser in $shell chromium chromium-browser google-chrome; do
  command -v "$browser" && exit
done
exit 1
