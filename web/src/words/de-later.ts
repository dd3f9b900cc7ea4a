/** Messages in German that are fetched when the first of them is to be said: those of diagnoses, trials, tools, robots’ descriptions, new cells, sensors, arms of UFACTORY, files that are sent. */
export const messages = import.meta.glob<string>(
  '../../../core/words/de/{advice,bag,description,drafts,effect,franka,gap,import,imports,instruction,kuka,library,mesh,newcell,sensors,setup,symptom,timeline,torques,trial,uploads,xacro,xarm}.ftl',
  { query: '?raw', import: 'default', eager: true },
);
