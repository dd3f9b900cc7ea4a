/**
 * What a tablet loads of English at first: the console's words but for those of some pages, and those of messages but for `en-later.ts`
 * and what stands only in a terminal, a report or a score sheet.
 */
export { en as own } from './en';

export const messages = import.meta.glob<string>(
  [
    '../../../core/words/en/*.ftl',
    '!../../../core/words/*/{advice,bag,description,drafts,effect,franka,gap,import,imports,instruction,kuka,library,mesh,newcell,sensors,setup,symptom,timeline,torques,trial,uploads,xacro,xarm}.ftl',
    '!../../../core/words/*/{certificate,cli,record,report,result,sheet}.ftl',
  ],
  { query: '?raw', import: 'default', eager: true },
);
