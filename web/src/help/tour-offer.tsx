import { Press } from '../ui/press';
import { words } from '../words';
import { endTour, isOffered, startTour } from './tour';

/** Who is here for the first time may be shown around, once; the help has it for later. */
export function TourOffer() {
  const said = words.value.help;
  if (!isOffered.value) return null;
  return (
    <section class="tour-offer">
      <p>{said.offer}</p>
      <div class="row">
        <Press act={startTour}>{said.take}</Press>
        <Press act={endTour}>{said.later}</Press>
      </div>
    </section>
  );
}
