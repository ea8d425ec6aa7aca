#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# Samples the bundled flight with the default method and, to compare, others: tools/demo.sh COMMAND FOLDER writes the
# motions into FOLDER and says how far each is from the truth, and where its rates jump.
set -eu
orispline=$1
folder=$2
keys=examples/data/flight_keys.csv

mkdir -p "$folder"
for method in auto timed-c2 quintic slerp; do
  "$orispline" sample "$keys" --method "$method" --rate 100 --truth examples/data/flight_truth.csv \
    -o "$folder/flight_$method.csv"
done
"$orispline" inspect "$keys" --method auto,timed-c2,quintic,slerp
echo "The motion is in $folder/flight_auto.csv, those of the other methods beside it"
