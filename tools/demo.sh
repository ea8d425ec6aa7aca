#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# Samples the bundled flight with two methods: tools/demo.sh COMMAND FOLDER writes the motions into FOLDER.
set -eu
orispline=$1
folder=$2
keys=examples/data/flight_keys.csv

mkdir -p "$folder"
for method in timed-c2 quintic; do
  "$orispline" sample "$keys" --method "$method" --rate 100 --truth examples/data/flight_truth.csv \
    -o "$folder/flight_$method.csv"
done
"$orispline" inspect "$keys" --method timed-c2 --method quintic
echo "The motions are in $folder/flight_timed-c2.csv and $folder/flight_quintic.csv"
