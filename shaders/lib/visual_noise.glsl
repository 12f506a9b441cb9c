// The grain that an eye sees in the dark, as a pure function of place, time and seed.
