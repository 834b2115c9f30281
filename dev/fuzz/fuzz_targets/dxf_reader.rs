#![no_main]

libfuzzer_sys::fuzz_target!(|data: &[u8]| cspace_fuzz::fuzz("dxf_reader", data));
