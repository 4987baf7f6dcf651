"""The laws and twins that judge a sampler, and the defects that test the laws."""
