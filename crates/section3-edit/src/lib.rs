//! Section 3: COPY, TRACUT, INDEX and plots of cutter location data
