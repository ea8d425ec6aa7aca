#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# Prints the path of the browser that tests use; fails where there is none.
for browser in chromium chromium-browser google-chrome; do
  command -v "$browser" && exit
done
exit 1
