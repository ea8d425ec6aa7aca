// SPDX-License-Identifier: Apache-2.0
// Nothing: the tests' headers are read for it, once for all of them.
