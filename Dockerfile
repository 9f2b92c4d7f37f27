# The workflow with its locked packages, for any folder: see README, "In other work".
FROM python:3.11.7-slim-bookworm
COPY . /thirdbody
RUN cd /thirdbody \
 && python -m pip install --no-cache-dir --require-hashes --requirement locks/workflow.txt \
 && python -m pip install --no-cache-dir --no-deps --no-build-isolation . \
 && cp workflow/envs/container_home.* /usr/local/lib/python3.11/site-packages \
 && mkdir --mode=1777 /work
WORKDIR /work
ENTRYPOINT ["snakemake", "--snakefile", "/usr/local/lib/python3.11/site-packages/thirdbody/workflow/Snakefile"]
CMD ["--cores", "2"]
