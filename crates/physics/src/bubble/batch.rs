//! Many bubbles at once.

use super::{
    BubbleError, BubbleModel, BubbleState, Controls, Driving, Gas, Liquid, Watch, advance,
};
use rayon::prelude::*;

/// One bubble of many with its surroundings and whoever watches it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Member<D, W> {
    /// Its gas.
    pub gas: Gas,
    /// Its state.
    pub state: BubbleState,
    /// Its surroundings until the time asked for.
    pub driving: D,
    /// Takes its events.
    pub watch: W,
}

/// Advances all bubbles to a time, s, in parallel. Each is independent of the others, so that the bits do not depend on
/// the number of threads. All are advanced even if some fail; a bubble that closes stops there.
///
/// # Errors
/// Index and error of the first bubble, by index, that failed.
pub fn advance_all<M: BubbleModel + ?Sized, D: Driving + Send + Sync, W: Watch + Send>(
    model: &M,
    liquid: &Liquid,
    controls: &Controls,
    members: &mut [Member<D, W>],
    until: f64,
) -> Result<(), (usize, BubbleError)> {
    let failed = members
        .par_iter_mut()
        .enumerate()
        .filter_map(|(index, member)| {
            let Member {
                gas,
                state,
                driving,
                watch,
            } = member;
            advance(model, liquid, gas, driving, controls, state, until, watch)
                .err()
                .map(|error| (index, error))
        })
        .min_by_key(|(index, _)| *index);
    failed.map_or(Ok(()), Err)
}
