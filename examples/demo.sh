#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# The bundled flight from keys to a report: examples/demo.sh COMMAND FOLDER writes the motion by the default method and by
# others to compare into FOLDER, says how far each is from the truth and where its rates jump, tunes tensions, and ends with
# a page that compares all methods, and with one on which its keys are dragged where that was built.
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
"$orispline" tune "$keys" --method timed-c2 -o "$folder/flight_keys_tuned.csv"
"$orispline" compare "$keys" --reference examples/data/flight_truth.csv --tune --report "$folder/flight.html"
echo "The motion is in $folder/flight_auto.csv, those of the other methods beside it.
All methods compared, tensions tuned, to look at in a browser: $folder/flight.html"
if "$orispline" studio "$keys" --no-open -o "$folder/flight_studio.html" >"$folder/studio.log" 2>&1; then
  echo "Its keys, to drag in a browser: $folder/flight_studio.html"
else
  echo "To drag its keys in a browser: make studio run"
fi
