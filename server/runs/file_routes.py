"""What a run leaves behind as files: its recording, its report."""

from __future__ import annotations

from fastapi import APIRouter, Response

from core.words.catalogue import Language
from core.words.message import Message
from server.http import downloads
from server.http.dependencies import SettingsDep
from server.runner.run_folder import RECORDING, name_report
from server.runs.conductor import Conductor, ConductorDep

router = APIRouter(prefix="/api/runs/{run}", tags=["runs"])


@router.get("/recording", response_class=Response, responses=downloads.ZIPPED)
def download_recording(run: str, conductor: ConductorDep, settings: SettingsDep) -> Response:
    """The samples of a run as a zip of its recording folder; also of one that ended early."""
    missing = Message.of("runs-no-recording", run=run, state=_state_of(conductor, run))
    return downloads.send_zip(settings.recordings_folder / run / RECORDING, f"run-{run}", missing)


@router.get("/report", response_class=Response, responses=downloads.PAGE)
def download_report(run: str, conductor: ConductorDep, settings: SettingsDep, language: Language = "en") -> Response:
    """The report of a run that came through, as a page; in English where it was made before there were other languages."""
    folder = settings.recordings_folder / run
    missing = Message.of("runs-no-report", run=run, state=_state_of(conductor, run))
    return downloads.page([folder / name_report(language), folder / name_report("en")], f"run-{run}", missing)


def _state_of(conductor: Conductor, run: str) -> str:
    return conductor.row_of(run).state
