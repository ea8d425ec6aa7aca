// SPDX-License-Identifier: Apache-2.0
import './style.css';
import { showHeader } from './header';
import { showPlayback } from './playback';
import { showPlots } from './plots';
import { shownMethods } from './report';
import { showScenes } from './scene/scenes';
import { showTable } from './table';

showHeader();
showTable();
if (shownMethods.length > 0) {
  showPlayback();
  showScenes();
  showPlots();
}
