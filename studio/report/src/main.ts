// SPDX-License-Identifier: Apache-2.0
import './style.css';
import { showHeader } from './header';
import { methodMenus, showPlayback } from './playback';
import { componentsChoice, showPlots } from './plots';
import { quantities } from './quantities';
import { report, shownMethods } from './report';
import { showScenes } from './scene/scenes';
import { showSkeleton } from './skeleton/skeleton';
import { showTable } from './table';

showHeader();
if (report.skeleton) showSkeleton(report.skeleton);
else {
  showTable();
  if (shownMethods.length > 0) {
    showPlayback(methodMenus());
    showScenes();
    showPlots(quantities, ['first', 'second', 'components'], componentsChoice());
  }
}
