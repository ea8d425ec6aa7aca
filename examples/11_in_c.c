// SPDX-License-Identifier: Apache-2.0
// The same curves for C: keys in flat arrays, a curve, samples, an error, and a task.
#include <orispline.h>
#include <stdio.h>

/// Says what went wrong; 1 for main().
static int failed(orispline_error *error) {
  fprintf(stderr, "%s\n", orispline_error_text(error));
  orispline_error_free(error);
  return 1;
}

/// 5 samples of the orientation and of the angular velocity, side by side in one table.
static int print_samples(const orispline_curve *curve) {
  double table[5][7];
  const orispline_output outputs[] = {{ORISPLINE_ORIENTATION, ORISPLINE_DOUBLE, &table[0][0], 7},
                                      {ORISPLINE_ANGULAR_VELOCITY, ORISPLINE_DOUBLE, &table[0][4], 7}};
  orispline_error *error = NULL;
  if (orispline_sample_even(curve, 0.25, 0.35, 5, ORISPLINE_WXYZ, "hold", 1, outputs, 2, &error)) return failed(error);
  for (int k = 0; k < 5; ++k)
    printf("%.2f s: q = %7.4f %7.4f %7.4f %7.4f, speed about z %7.4f rad/s\n", 0.25 + 0.35 * k, table[k][0],
           table[k][1], table[k][2], table[k][3], table[k][6]);
  return 0;
}

/// The motion slowed to a limit, as its keys.
static int print_slowed(const orispline_keys *keys) {
  const orispline_input input = {"keys", keys};
  const char *options[] = {"method=timed-c2", "max_rate=60deg/s"};
  orispline_outcome *outcome = NULL;
  orispline_keys *slower = NULL;
  orispline_error *error = NULL;
  double times[4];
  if (orispline_task_run("retime", &input, 1, options, 2, NULL, NULL, &outcome, &error)) return failed(error);
  if (orispline_outcome_track(outcome, 0, &slower, &error)) return failed(error);
  if (orispline_keys_column(slower, "times", 0, times, 4, &error)) return failed(error);
  printf("slowed to 60 deg/s it takes %.2f s\n", times[3]);
  orispline_keys_free(slower);
  orispline_outcome_free(outcome);
  return 0;
}

int main(void) {
  const double times[] = {0.0, 0.5, 1.2, 2.0};
  const double orientations[] = {1.0, 0.0, 0.0, 0.0,  // w, x, y, z
                                 0.8, 0.0, 0.0, 0.6,  //
                                 0.6, 0.0, 0.0, 0.8,  //
                                 0.6, 0.0, 0.8, 0.0};
  const double tensions[] = {1.0, 0.5, 1.0, 1.0};
  const orispline_column column = {"tension", tensions, 4};
  orispline_keys *keys = NULL;
  orispline_curve *curve = NULL;
  orispline_error *error = NULL;

  if (orispline_abi() != ORISPLINE_C_ABI) return 1;
  if (orispline_keys_make(times, orientations, 4, ORISPLINE_WXYZ, ORISPLINE_SHORTEST, &column, 1, &keys, &error))
    return failed(error);
  if (orispline_curve_make(keys, "timed-c2:ends=rest", &curve, &error)) return failed(error);
  if (print_samples(curve)) return 1;
  orispline_curve_free(curve);

  if (orispline_curve_make(keys, "timed-c3:tensoin=1", &curve, &error)) printf("%s\n", orispline_error_text(error));
  orispline_error_free(error);
  if (print_slowed(keys)) return 1;
  orispline_keys_free(keys);
  return 0;
}
